// Two walks over the routes: forward from what makes events by itself (clocks, the camera, the host), and backward from what
// is drawn. Both pass through the nodes that make events of events, and from what binds a node to all that it binds or unbinds.

#include "scene/event_flow.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

namespace plugc {
namespace {

using RoutesByField = std::map<EventField, std::vector<EventField>>;

/// X3D 4.1, 8.2.4.2: a sensor that does not loop runs from its startTime on, if that is still to come. Time 0 is when the scene
/// is loaded, and 0 the default for sensors that wait for an event.
bool starts_by_itself(const NodeGraph& graph, NodeId sensor) {
  return graph.boolean(sensor, "enabled") && (graph.boolean(sensor, "loop") || graph.number(sensor, "startTime") > 0);
}

/// `placed`: null for all.
bool is_source(const NodeGraph& graph, NodeId node, const EventNodeInfo& info, const std::set<NodeId>* placed) {
  if (info.kind == EventKind::time_sensor) return starts_by_itself(graph, node);
  const bool looks = info.kind == EventKind::proximity_sensor || info.kind == EventKind::camera;
  return looks && (placed == nullptr || placed->contains(node));
}

class Walk {
 public:
  Walk(const NodeGraph& graph, const Scripts& scripts) : graph_(graph), scripts_(scripts) {}

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
      if (passed_.contains(field.first)) continue;
      const EventNodeInfo* info = find_event_node(graph_, scripts_, field.first);
      if (info == nullptr || find_field_index(forward ? info->inputs : info->outputs, field.second) < 0) continue;
      passed_.insert(field.first);
      for (const std::string_view name : forward ? info->outputs : info->inputs) {
        if (!name.empty()) reach({field.first, name});
      }
    }
    return std::move(reached_);
  }

 private:
  const NodeGraph& graph_;
  const Scripts& scripts_;
  std::set<EventField> reached_;
  std::set<NodeId> passed_;  // all that it sends, or listens to, is reached
  std::vector<EventField> work_;
};

/// The routes of a graph from both of their ends, and what binding leads to.
struct Links {
  RoutesByField leaving, arriving;
  std::array<std::optional<EventField>, kBindKinds> stacks = {};  ///< A field of no node's: what binds leads there.

  explicit Links(const NodeGraph& graph) {
    for (const GraphRoute& route : graph.routes()) {
      add({route.from, route.from_field}, {route.to, route.to_field});
      if (const auto kind = bind_kind(graph, route.to); kind && route.to_field == "set_bind")
        add({route.to, route.to_field}, stack(*kind, route.to));
      if (const auto kind = bind_kind(graph, route.from); kind && says_what_is_bound(route.from_field))
        add(stack(*kind, route.from), {route.from, route.from_field});
    }
  }

 private:
  void add(const EventField& from, const EventField& to) {
    leaving[from].push_back(to);
    arriving[to].push_back(from);
  }
  EventField stack(BindKind kind, NodeId node) {
    std::optional<EventField>& known = stacks[static_cast<std::size_t>(kind)];
    if (!known) known = EventField(node, "");
    return *known;
  }
};

std::set<EventField> find_live(const NodeGraph& graph, const Scripts& scripts, const Links& links,
                               std::span<const DynamicField> dynamic, const std::set<NodeId>* placed) {
  Walk forward(graph, scripts);
  for (const auto& [field, receivers] : links.leaving) {
    const EventNodeInfo* info = find_event_node(graph, scripts, field.first);
    if (info == nullptr || find_field_index(info->outputs, field.second) < 0) continue;
    if (is_source(graph, field.first, *info, placed) || sends_at_start(scripts, field.first, field.second))
      forward.reach(field);
  }
  for (const auto& stack : links.stacks) {
    if (stack) forward.reach(*stack);  // when the scene is loaded, the first of its kind is bound
  }
  for (const DynamicField& field : dynamic) forward.reach({field.node, field.name});
  return forward.run(links.leaving, true);
}

}  // namespace

bool says_what_is_bound(std::string_view field) {
  return std::ranges::find(kBindOutputs, field) != std::end(kBindOutputs);
}

std::optional<BindKind> bind_kind(const NodeGraph& graph, NodeId node) {
  if (graph.is(node, "Viewpoint") || graph.is(node, "OrthoViewpoint")) return BindKind::viewpoint;
  if (graph.is(node, "X3DBackgroundNode")) return BindKind::background;
  if (graph.is(node, "NavigationInfo") || graph.is(node, "KambiNavigationInfo")) return BindKind::navigation_info;
  return graph.is(node, "Fog") ? std::optional(BindKind::fog) : std::nullopt;
}

std::set<EventField> find_live_fields(const NodeGraph& graph, const Scripts& scripts, std::span<const DynamicField> dynamic) {
  if (graph.routes().empty() && dynamic.empty()) return {};
  return find_live(graph, scripts, Links(graph), dynamic, nullptr);
}

EventFlow find_event_flow(const NodeGraph& graph, const Scripts& scripts, std::span<const EventField> drawn,
                          std::span<const DynamicField> dynamic, const std::set<NodeId>& placed) {
  const Links links(graph);
  Walk backward(graph, scripts);
  for (const EventField& field : drawn) backward.reach(field);
  return {find_live(graph, scripts, links, dynamic, &placed), backward.run(links.arriving, false)};
}

}  // namespace plugc
