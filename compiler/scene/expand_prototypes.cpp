// Every instance of a prototype is a fresh copy of its body's nodes (X3D 4.1 part 1, 4.4.4). First the values that the
// instance gives are built in the scope where it stands, then the defaults of the others, then the body in a scope of its
// own. The first node of the body takes the instance's place; the others go nowhere, but exist for their routes. IS in the
// body finds the values ready, and leaves a link behind, along which routes are followed later.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

/// What an instance costs beside its fields, in nodes: it has name spaces of its own.
constexpr std::size_t kInstanceWork = 16;

/// Of fields with the same name the first one counts, and an instance has no others.
void index_fields(Prototype& prototype, const Document& text) {
  if (!prototype.field_index.empty()) return;
  for (const InterfaceSyntax& declared : text.of(prototype.syntax->interface)) {
    prototype.field_index.emplace(declared.name.text, static_cast<std::uint32_t>(prototype.field_index.size()));
  }
}

}  // namespace

void GraphBuilder::declare_prototype(Scope& scope, std::uint32_t index, bool external) {
  Prototype& prototype = prototypes_.emplace_back();
  prototype.document = scope.document;
  prototype.syntax = &document(scope).protos[index];
  if (!spend(1, prototype.syntax->name.span)) return;
  prototype.scope = &scope;
  prototype.order = scope.prototype_count++;
  prototype.external = external;
  const Name& name = prototype.syntax->name;
  std::vector<Prototype*>& declared = scope.prototypes[name.text];
  if (!declared.empty()) {
    report(DiagnosticId::name_repeated, name.span,
           fmt::format("prototype `{}` is declared here for the second time; an instance means the last one before it",
                       name.text));
  }
  declared.push_back(&prototype);
}

/// A body sees the prototypes declared before its own in the scopes around it, the nearest first.
Prototype* GraphBuilder::find_prototype(const Scope& scope, std::string_view name) const {
  std::uint32_t visible = UINT32_MAX;
  for (const Scope* at = &scope; at != nullptr; visible = at->visible_prototypes, at = at->declared_in) {
    const auto found = at->prototypes.find(name);
    if (found == at->prototypes.end()) continue;
    const std::vector<Prototype*>& declared = found->second;
    const auto behind =
        std::partition_point(declared.begin(), declared.end(), [&](const Prototype* one) { return one->order < visible; });
    if (behind != declared.begin()) return *(behind - 1);
  }
  return nullptr;
}

/// A prototype that the file never uses is expanded once, out of sight, so that what it holds can be checked. The last one
/// first: it may use those before it.
void GraphBuilder::expand_unused(Scope& scope) {
  static const NodeSyntax kNothingGiven;
  for (std::size_t i = prototypes_.size(); i-- > 0;) {
    Prototype& prototype = prototypes_[i];
    if (prototype.scope != &scope || prototype.external || prototype.used) continue;
    Job job;
    job.node = &kNothingGiven;
    job.scope = &scope;
    job.to.written = &kNothingGiven;
    expand(job, prototype, nullptr);
    run_jobs();
  }
}

void GraphBuilder::instantiate(const Job& job, Prototype& prototype) {
  if (!prototype.external) return expand(job, prototype, nullptr);
  Prototype* target = resolve_external(prototype);
  if (target == nullptr) return lose(*job.scope, *job.node);
  if (target->built_in != nullptr) return create_node(job, *target->built_in);
  expand(job, *target, &prototype);
}

/// `external` is the declaration that led here from another file, if any.
void GraphBuilder::expand(const Job& job, Prototype& prototype, const Prototype* external) {
  const NodeSyntax& syntax = *job.node;
  const Span& place = syntax.type.empty() ? prototype.syntax->name.span : syntax.type.span;
  if (!spend(kInstanceWork + syntax.fields.count + prototype.syntax->interface.count, place)) return;
  prototype.used = true;
  index_fields(prototype, document(*prototype.scope));
  if (!may_expand(job, prototype)) return lose(*job.scope, syntax);
  Instance& instance = new_instance(job, prototype, external);
  Job finish = job;
  finish.kind = JobKind::finish;
  finish.following = 0;
  finish.definition = instance.definition;
  jobs_.push_back(finish);
  const auto first = static_cast<std::ptrdiff_t>(jobs_.size());
  for (const FieldSyntax& field : document(*job.scope).of(syntax.fields)) set_field(job, instance, field);
  for (ProtoField& field : instance.fields) {
    const ValueKind kind = field.declared->value.kind;
    if (field.has_value || kind == ValueKind::none || kind == ValueKind::is) continue;
    give_value(job, instance, field, field.declared->value, *instance.body);
  }
  Job body = job;
  body.kind = JobKind::body;
  body.following = 0;
  body.stands_for = &instance;
  jobs_.push_back(body);
  std::reverse(jobs_.begin() + first, jobs_.end());
}

/// A prototype cannot contain itself (a file that inlines itself through one is found by may_inline).
bool GraphBuilder::may_expand(const Job& job, const Prototype& prototype) {
  const Span& span = job.node->type.span;
  for (const Scope* at = job.scope; at->instance != nullptr; at = at->outer) {
    if (at->instance->prototype->syntax != prototype.syntax) continue;
    report(DiagnosticId::proto_cycle, span, fmt::format("prototype `{}` contains itself", prototype.syntax->name.text));
    return false;
  }
  if (job.scope->proto_depth < kMaxProtoDepth) return true;
  report(DiagnosticId::proto_cycle, span, fmt::format("prototypes stand more than {} deep inside one another", kMaxProtoDepth));
  return false;
}

Instance& GraphBuilder::new_instance(const Job& job, const Prototype& prototype, const Prototype* external) {
  Instance& instance = instances_.emplace_back();
  instance.prototype = &prototype;
  instance.external = external;
  instance.stands_for = job.stands_for;
  instance.def = job.node->extras->def.text;
  instance.definition = define(*job.scope, job.node->extras->def);
  if (instance.definition != nullptr) instance.definition->instance = &instance;
  Scope& body = scopes_.emplace_back();
  body.document = prototype.document;
  body.outer = job.scope;
  body.declared_in = prototype.scope;
  body.visible_prototypes = prototype.order;
  body.instance = &instance;
  body.inline_depth = job.scope->inline_depth;
  body.proto_depth = job.scope->proto_depth + 1;
  body.repeats = true;
  instance.body = &body;
  declare_fields(instance);
  return instance;
}

void GraphBuilder::declare_fields(Instance& instance) {
  std::unordered_set<std::string_view> names;
  for (const InterfaceSyntax& declared : document(*instance.body).of(instance.prototype->syntax->interface)) {
    if (!declare_once(names, declared)) continue;
    ProtoField& field = instance.fields.emplace_back();
    field.declared = &declared;
    field.type = field_type(declared.type.text);
    if (field.type != FieldType::unknown) continue;
    report_unknown_type(declared.type);
  }
}

void GraphBuilder::run_body(const Job& job) {
  Scope& body = *job.stands_for->body;
  const std::span<const StatementSyntax> statements = document(body).of(job.stands_for->prototype->syntax->body);
  const auto first = static_cast<std::size_t>(
      std::find_if(statements.begin(), statements.end(),
                   [](const StatementSyntax& statement) { return statement.kind == StatementKind::node; }) -
      statements.begin());
  Job nowhere;
  nowhere.scope = &body;
  nowhere.depth = job.depth;
  if (first < statements.size()) {
    push_statements(statements.subspan(first + 1), nowhere);
    Job in_place = job;
    in_place.scope = &body;
    push_statements(statements.subspan(first, 1), in_place);
  }
  push_statements(statements.first(first), nowhere);
}

}  // namespace plugc
