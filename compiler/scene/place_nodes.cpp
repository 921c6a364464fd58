// Where a built node goes: into its parent's list, after a look at what the field accepts. In XML the field is found here,
// when the node's type is known even if a USE or a prototype's instance stands there.
//
// The longest path below each finished node is kept. A node may be put below another (by USE, or by IS) only where the
// whole path stays within kMaxSceneDepth, so that later phases may recurse.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/container_field.h"
#include "scene/event_names.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

/// Fields that name a node which lives elsewhere, even around them.
constexpr std::array<std::string_view, 5> kReferences = {"light", "projectedLight", "projector", "receiveShadows", "viewpoint"};

std::vector<std::string_view> node_field_names(const NodeInfo& node) {
  std::vector<std::string_view> names;
  for (const FieldInfo& field : node.fields) {
    if (takes_nodes(&field)) names.push_back(field.name);
  }
  return names;
}

/// "X3DTextureNode", "A or B", "A, B or others".
std::string accepted_types(const FieldInfo& field) {
  std::vector<std::string_view> types;
  any_alternative(field.accepts, [&](std::string_view type) {
    types.push_back(type);
    return false;
  });
  if (types.size() > 3) return fmt::format("`{}`, `{}` or others", types[0], types[1]);
  std::string text = fmt::format("`{}`", types[0]);
  for (std::size_t i = 1; i < types.size(); ++i) text += fmt::format("{}`{}`", i + 1 == types.size() ? " or " : ", ", types[i]);
  return text;
}

Span place_of(const Destination& to) {
  return to.written->extras->use.empty() ? to.written->type.span : to.written->extras->use.span;
}

bool is_defined_outside(const Scope& scope, std::string_view name) {
  for (const Scope* outer = scope.outer; outer != nullptr; outer = outer->outer) {
    if (outer->definitions.contains(name)) return true;
  }
  return false;
}

bool contains(const Span& outer, const Span& inner) {
  return outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Whether the name is given behind this place, in no prototype's body or in the same one.
bool is_defined_behind(const Document& text, const Name& name) {
  const auto same_body = [&](const NodeSyntax& node) {
    return std::all_of(text.protos.begin(), text.protos.end(), [&](const ProtoSyntax& proto) {
      return contains(proto.span, name.span) == contains(proto.span, node.extras->def.span);
    });
  };
  const auto first = std::find_if(text.nodes.begin(), text.nodes.end(), [&](const NodeSyntax& node) {
    return node.extras->def.text == name.text && node.extras->def.span.begin > name.span.begin;
  });
  return first != text.nodes.end() && same_body(*first);
}

/// Whether a USE here names its node without containing it: as a reference, or for a Script's code.
bool only_refers(const Destination& to, const NodeInfo* holder) {
  if (holder == nullptr) return false;
  if (is_a(*holder, "X3DScriptNode")) return true;
  const std::string_view field = to.field != nullptr ? to.field->name : to.written->extras->container_field.text;
  return std::find(kReferences.begin(), kReferences.end(), field) != kReferences.end();
}

}  // namespace

void GraphBuilder::place(const Job& job, NodeId id) {
  for (Instance* instance = job.stands_for; instance != nullptr; instance = instance->stands_for) {
    instance->first = id;
    if (instance->definition != nullptr) instance->definition->node = id;
  }
  Destination to = job.to;
  if (to.by_container && !choose_container(to, id)) return;
  if (to.list == nullptr) return;
  if (to.single && !to.list->empty()) {
    return report(DiagnosticId::field_type, place_of(to), "this field takes one node; the first one counts");
  }
  if (to.field != nullptr) check_accepted(*to.field, to.holder, id, place_of(to));
  to.list->push_back(id);
}

bool GraphBuilder::choose_container(Destination& to, NodeId id) {
  const NodeInfo& holder = *graph_.nodes_[to.holder.value].info;
  const NodeInfo& node = *graph_.nodes_[id.value].info;
  const Name& written = to.written->extras->container_field;
  const FieldInfo* renamed = find_field_as_written(holder, written.text, Encoding::vrml2);
  const bool is_wrong = !written.empty() && !takes_nodes(find_field_info(holder, written.text)) && !takes_nodes(renamed);
  if (is_wrong && !is_reported(DiagnosticId::field_unknown, written.span)) {
    report(DiagnosticId::field_unknown, written.span,
           fmt::format("`{}` has no field `{}` for nodes{}", holder.name, written.text,
                       suggest(written.text, [&] { return node_field_names(holder); })));
  }
  if (takes_nodes(renamed) && !takes_nodes(find_field_as_written(holder, written.text, Encoding::xml)))
    report_renamed(holder, written, *renamed);
  to.field = takes_nodes(renamed) ? renamed : container_field_of(holder, node, written.text);
  if (to.field == nullptr) {
    if (is_wrong) return false;
    report(DiagnosticId::node_misplaced, place_of(to),
           fmt::format("`{}` has no field for a `{}`; it is left out", holder.name, node.name));
    return false;
  }
  to.single = !is_multiple(to.field->type);
  NodeList*& list = container_lists_[{to.holder.value, to.field}];
  if (list == nullptr) {
    const std::size_t index = write_field(to.holder, *to.field, place_of(to));
    FieldValue& value = graph_.nodes_[to.holder.value].fields[index].value;
    value.type = to.field->type;
    value.span = to.written->span;
    list = new_list(to.holder, index, false);
  }
  to.list = list;
  return true;
}

void GraphBuilder::place_use(const Job& job) {
  const Name& name = job.node->extras->use;
  if (!spend(1, name.span)) return;
  const auto found = job.scope->definitions.find(name.text);
  if (found == job.scope->definitions.end()) {
    if (is_reported(DiagnosticId::use_unknown, name.span)) return;
    return report(DiagnosticId::use_unknown, name.span,
                  fmt::format("no `DEF {}` stands before this `USE`{}", name.text, unknown_name_hint(*job.scope, name)));
  }
  const Definition& definition = *found->second;
  if (definition.lost) return;
  if (definition.open) {
    const NodeInfo* holder = job.to.holder.valid() ? graph_.nodes_[job.to.holder.value].info : nullptr;
    if (only_refers(job.to, holder)) return;
    return report(DiagnosticId::use_cycle, name.span,
                  fmt::format("this `USE` stands inside `DEF {}`, so that it would contain itself", name.text));
  }
  if (!definition.node.valid() || !fits_depth(job.depth, definition.node, name.span)) return;
  check_use(job, definition);
  place(job, definition.node);
  raise_height(job.to.holder, definition.node);
}

/// A USE is the node as it is. In XML and JSON it looks like a node, so that it may give fields or call another type.
void GraphBuilder::check_use(const Job& job, const Definition& definition) {
  const NodeSyntax& use = *job.node;
  const std::string_view name = use.extras->use.text;
  const GraphNode& node = graph_.nodes_[definition.node.value];
  const std::string_view actual = node.info->name;
  const bool is_own = definition.instance == nullptr && node.document == job.scope->document;  // not imported
  const bool says_type = !use.type.empty() && !use.is_instance && is_own;
  if (says_type && use.type.text != actual) {
    report(DiagnosticId::node_misplaced, use.type.span,
           fmt::format("`{}` is a `{}`, but this `USE` calls it a `{}`", name, actual, use.type.text));
  }
  if (use.fields.empty()) return;
  const FieldSyntax& given = document(*job.scope).of(use.fields)[0];
  report(DiagnosticId::field_unknown, given.name.empty() ? given.value.span : given.name.span,
         fmt::format("`USE {}` is the node as it is; what is given to it here is passed over", name));
}

std::string GraphBuilder::suggest_defined(const Scope& scope, std::string_view name) {
  if (!may_look_through(scope.definitions.size())) return "";
  std::vector<std::string_view> names;
  for (const auto& [defined, definition] : scope.definitions) names.push_back(defined);
  std::sort(names.begin(), names.end());
  return did_you_mean(name, names);
}

/// Why a name is not known here. Looking costs more than all else about a mistake, so only the first ones are looked for.
std::string GraphBuilder::unknown_name_hint(const Scope& scope, const Name& name) {
  const Document& text = document(scope);
  if (!may_look_through(text.nodes.size() + text.protos.size())) return "";
  if (is_defined_behind(text, name)) return "; one stands behind it";
  const std::string suggestion = suggest_defined(scope, name.text);
  if (!suggestion.empty() || !is_defined_outside(scope, name.text)) return suggestion;
  return "; names outside a prototype's body or an inlined file cannot be seen in it";
}

/// The nodes that an instance was given, for one field of a node in its body. Null when they do not fit there.
NodeList* GraphBuilder::share(const Job& job, NodeId holder, const FieldInfo* info, const ProtoField& source) {
  NodeList* list = source.nodes;
  if (list == nullptr || !spend(1 + list->size(), source.value.span)) return nullptr;
  for (const NodeId id : list->ids()) {
    if (!fits_depth(job.depth + 1, id, source.value.span)) return nullptr;
  }
  for (const NodeId id : list->ids()) {
    if (info != nullptr) check_accepted(*info, holder, id, source.value.span);
    raise_height(holder, id);
  }
  return list;
}

void GraphBuilder::check_accepted(const FieldInfo& field, NodeId holder, NodeId id, const Span& span) {
  const NodeInfo& node = *graph_.nodes_[id.value].info;
  if (accepts(field, node)) return;
  report(DiagnosticId::node_misplaced, span,
         fmt::format("`{}` stands in `{}` of `{}`, which takes {}", node.name, field.name,
                     graph_.nodes_[holder.value].info->name, accepted_types(field)));
}

bool GraphBuilder::fits_depth(std::uint32_t depth, NodeId id, const Span& span) {
  if (depth + heights_[id.value] <= kMaxSceneDepth) return true;
  report(DiagnosticId::nesting_limit, span, fmt::format("more than {} nodes inside one another", kMaxSceneDepth));
  return false;
}

void GraphBuilder::raise_height(NodeId holder, NodeId child) {
  if (!holder.valid()) return;
  heights_[holder.value] = std::max(heights_[holder.value], heights_[child.value] + 1);
}

}  // namespace plugc
