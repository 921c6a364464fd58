// A name is looked for in every node, since prototypes and inlined files repeat names and a host knows nothing else.

#include "scene/dynamic_fields.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/event_names.h"
#include "scene/scene.h"

namespace plugc {
namespace {

/// Type and name of a field that receives events; an unknown type where there is none.
struct Receiver {
  std::string_view name;
  FieldType type = FieldType::unknown;
};

Receiver find_receiver(const GraphNode& node, std::string_view name) {
  for (const InterfaceField& own : node.interface()) {
    if (own.name == name && allows(own.access, EventUse::receive)) return {own.name, own.type};
  }
  const FieldInfo* field = find_field_info(*node.info, name);
  if (field != nullptr && allows(field->access, EventUse::receive)) return {field->name, field->type};
  return {};
}

std::vector<std::string_view> receiver_names(const GraphNode& node) {
  std::vector<std::string_view> names;
  for (const InterfaceField& own : node.interface()) {
    if (allows(own.access, EventUse::receive)) names.push_back(own.name);
  }
  for (const FieldInfo& field : node.info->fields) {
    if (allows(field.access, EventUse::receive)) names.push_back(field.name);
  }
  return names;
}

void report_no_receiver(const GraphNode& node, std::string_view name, Diagnostics& diagnostics) {
  diagnostics.report(DiagnosticId::dynamic_field, node.type_span,
                     fmt::format("`{}` has no field `{}` that a host could change{}", node.info->name, name,
                                 did_you_mean(name, receiver_names(node))));
}

}  // namespace

std::vector<DynamicField> find_dynamic_fields(const NodeGraph& graph, const std::vector<std::string>& names,
                                              std::vector<std::string>& known, Diagnostics& diagnostics) {
  std::vector<DynamicField> found;
  for (const std::string& name : names) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    const std::string_view def = std::string_view(name).substr(0, dot);
    const std::string_view field = std::string_view(name).substr(std::min(dot + 1, name.size()));
    for (std::uint32_t i = 0; i < graph.size() && !def.empty(); ++i) {
      const GraphNode& node = graph[NodeId{i}];
      if (node.def != def) continue;
      if (known.empty() || known.back() != name) known.push_back(name);
      const Receiver receiver = find_receiver(node, field);
      if (slot_type(receiver.type))
        found.push_back({NodeId{i}, receiver.name});
      else
        report_no_receiver(node, field, diagnostics);
    }
  }
  return found;
}

void report_ignored_events(const NodeGraph& graph, Diagnostics& diagnostics) {
  for (const GraphRoute& route : graph.routes()) {
    const GraphNode& receiver = graph[route.to];
    const Receiver field = find_receiver(receiver, route.to_field);
    const bool decides = is_node(field.type) || route.to_field == "url";
    if (!decides || graph.is(route.to, "Script") || graph.is(route.to, "X3DSensorNode")) continue;
    diagnostics.report(DiagnosticId::event_ignored, route.span,
                       fmt::format("events to `{}.{}` are not followed: a program cannot be made while the scene is drawn, so "
                                   "the field keeps its first value",
                                   receiver.info->name, route.to_field));
  }
}

}  // namespace plugc
