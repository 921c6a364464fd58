// What is told while a graph is built: each mistake once, with a near name where looking for one pays, and nothing about the
// names of what was passed over.

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

/// Nodes, fields, links and routes together: what expanding may cost when prototypes multiply anything but nodes.
constexpr std::size_t kMaxWork = std::size_t{6} * kMaxSceneNodes;

std::vector<std::string_view> node_names() {
  std::vector<std::string_view> names;
  for (const NodeInfo& info : node_table()) names.push_back(info.name);
  for (const std::string_view statement : {"ROUTE", "IMPORT", "EXPORT", "ProtoDeclare", "ProtoInstance"})
    names.push_back(statement);
  return names;
}

std::vector<std::string_view> field_type_names() {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(FieldType::unknown); ++i) {
    names.push_back(to_text(static_cast<FieldType>(i)));
  }
  return names;
}

}  // namespace

/// XML and JSON have one element for the instances of all prototypes.
void GraphBuilder::report_element_of_a_prototype(const Name& type) {
  report(DiagnosticId::node_unknown, type.span,
         fmt::format("`{}` is a prototype; its instance is a `ProtoInstance` with this `name`", type.text));
}

void GraphBuilder::report_unknown_node(const Job& job) {
  const Name& type = job.node->type;
  if (is_reported(DiagnosticId::node_unknown, type.span)) return;
  const auto known = [&] {
    std::vector<std::string_view> names;
    if (!job.node->is_instance) names = node_names();
    for (const Scope* at = job.scope; at != nullptr; at = at->declared_in) {
      for (const auto& [name, declared] : at->prototypes) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  };
  const std::string what = job.node->is_instance ? fmt::format("no prototype `{}` is declared before this instance", type.text)
                                                 : fmt::format("unknown node `{}`", type.text);
  report(DiagnosticId::node_unknown, type.span, what + suggest(type.text, known));
}

void GraphBuilder::report_unknown_type(const Name& type) {
  if (is_reported(DiagnosticId::field_type, type.span)) return;
  report(DiagnosticId::field_type, type.span,
         fmt::format("no field type is called `{}`{}", type.text, suggest(type.text, field_type_names)));
}

/// Of a node that is passed over the names are remembered, its own and those inside, so that no USE or ROUTE of them is told
/// as a further mistake.
void GraphBuilder::lose(Scope& scope, const NodeSyntax& node) {
  const Document& text = document(scope);
  std::vector<const NodeSyntax*> passed{&node};
  const auto pass_over = [&](const ValueSyntax& value) {
    if (value.kind != ValueKind::nodes) return;
    for (const NodeSyntax& inner : text.of(value.nodes())) passed.push_back(&inner);
  };
  while (!passed.empty()) {
    const NodeSyntax& one = *passed.back();
    passed.pop_back();
    if (!spend(1, one.span)) return;
    if (!one.extras->def.empty()) lose_name(scope, one.extras->def.text);
    for (const FieldSyntax& field : text.of(one.fields)) pass_over(field.value);
    for (const InterfaceSyntax& field : text.of(one.extras->interface)) pass_over(field.value);
  }
}

void GraphBuilder::lose_name(Scope& scope, std::string_view name) {
  Definition& definition = definitions_.emplace_back();
  definition.lost = true;
  scope.definitions[name] = &definition;
}

bool GraphBuilder::spend(std::size_t work, const Span& span) {
  work_ += work;
  if (out_of_work_) return false;
  if (work_ <= kMaxWork && graph_.nodes_.size() < kMaxSceneNodes) return true;
  out_of_work_ = true;
  report(DiagnosticId::scene_limit, span,
         fmt::format("the scene expands to more than {} nodes; what follows is left out", kMaxSceneNodes));
  return false;
}

void GraphBuilder::report(DiagnosticId id, const Span& span, const std::string& message) {
  const auto key =
      (std::uint64_t{static_cast<std::uint16_t>(id)} << 48) ^ (std::uint64_t{span.source.value} << 32) ^ span.begin;
  if (reported_.insert(key).second) diagnostics_.report(id, span, message);
}

bool GraphBuilder::is_reported(DiagnosticId id, const Span& span) const {
  return reported_.contains((std::uint64_t{static_cast<std::uint16_t>(id)} << 48) ^ (std::uint64_t{span.source.value} << 32) ^
                            span.begin);
}

bool GraphBuilder::may_look_through(std::size_t names) {
  looked_through_ += names;
  return ++suggestions_ <= kMaxSuggestions && looked_through_ <= kMaxLookedThrough;
}

std::string GraphBuilder::suggest(std::string_view name, const std::function<std::vector<std::string_view>()>& candidates) {
  if (!may_look_through(0)) return "";
  const std::vector<std::string_view> names = candidates();
  looked_through_ += names.size();
  return did_you_mean(name, names);
}

}  // namespace plugc
