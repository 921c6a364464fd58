// Two walks over the routes: forward from what makes events by itself (clocks, the camera, the host), and backward from what
// is drawn. Both pass through the nodes that make events of events.

#include "scene/event_flow.h"

#include <algorithm>

namespace plugc {
namespace {

using RoutesByField = std::map<EventField, std::vector<EventField>>;

/// X3D 4.1, 8.2.4.2: a sensor that does not loop runs from its startTime on, if that is still to come. Time 0 is when the scene
/// is loaded, and 0 the default for sensors that wait for an event.
bool starts_by_itself(const NodeGraph& graph, NodeId sensor) {
  return graph.boolean(sensor, "enabled") && (graph.boolean(sensor, "loop") || graph.number(sensor, "startTime") > 0);
}

bool is_source(const NodeGraph& graph, NodeId node, const EventNodeInfo& info, const std::set<NodeId>& placed) {
  if (info.kind == EventKind::time_sensor) return starts_by_itself(graph, node);
  return (info.kind == EventKind::proximity_sensor || info.kind == EventKind::camera) && placed.contains(node);
}

class Walk {
 public:
  explicit Walk(const NodeGraph& graph) : graph_(graph) {}

  void reach(const EventField& field) {
    if (reached_.insert(field).second) work_.push_back(field);
  }
  /// Follows `links`, and goes through event nodes from one side of them to the other.
  std::set<EventField> run(const RoutesByField& links, bool forward) {
    while (!work_.empty()) {
      const EventField field = work_.back();
      work_.pop_back();
      if (const auto found = links.find(field); found != links.end()) {
        for (const EventField& next : found->second) reach(next);
      }
      const EventNodeInfo* info = find_event_node(graph_[field.first].info->name);
      if (info == nullptr || find_field_index(forward ? info->inputs : info->outputs, field.second) < 0) continue;
      for (const std::string_view name : forward ? info->outputs : info->inputs) reach({field.first, name});
    }
    return std::move(reached_);
  }

 private:
  const NodeGraph& graph_;
  std::set<EventField> reached_;
  std::vector<EventField> work_;
};

}  // namespace

EventFlow find_event_flow(const NodeGraph& graph, std::span<const EventField> drawn, std::span<const DynamicField> dynamic,
                          const std::set<NodeId>& placed) {
  RoutesByField leaving, arriving;
  for (const GraphRoute& route : graph.routes()) {
    leaving[{route.from, route.from_field}].emplace_back(route.to, route.to_field);
    arriving[{route.to, route.to_field}].emplace_back(route.from, route.from_field);
  }
  Walk forward(graph), backward(graph);
  for (const auto& [field, receivers] : leaving) {
    const EventNodeInfo* info = find_event_node(graph[field.first].info->name);
    if (info == nullptr || find_field_index(info->outputs, field.second) < 0) continue;
    if (is_source(graph, field.first, *info, placed)) forward.reach(field);
  }
  for (const DynamicField& field : dynamic) forward.reach({field.node, field.name});
  for (const EventField& field : drawn) backward.reach(field);
  return {forward.run(leaving, true), backward.run(arriving, false)};
}

}  // namespace plugc
