// The fields that are drawn have their slots by now. From these the routes are followed back to what makes events; what is
// found on the way gets slots too, and an order in which each node stands behind those that send to it. Where routes run in a
// circle, the node that stands first in the text begins.

#include "scene/scene_events.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "scene/event_flow.h"
#include "scene/event_names.h"
#include "scene/scene_bindings.h"

namespace plugc {
namespace {

/// The transform of a proximity sensor, the index of a viewpoint.
std::map<NodeId, int> find_subjects(const SceneContext& context) {
  std::map<NodeId, int> subjects = context.sensor_transforms;
  const auto& viewpoints = context.scene.viewpoints;
  for (std::size_t i = 0; i < viewpoints.size(); ++i) subjects.try_emplace(viewpoints[i].node, static_cast<int>(i));
  return subjects;
}

std::set<NodeId> keys(const std::map<NodeId, int>& map) {
  std::set<NodeId> result;
  for (const auto& [key, value] : map) result.insert(key);
  return result;
}

/// What decides vertices or pixels of a texture, as far as it has no slot: all of that is done when the scene is compiled.
/// Nodes and urls are told of by report_ignored_events().
bool is_fixed(const NodeGraph& graph, const EventField& field) {
  const auto is = [&](std::string_view type) { return graph.is(field.first, type); };
  const FieldInfo* info = find_field_info(*graph[field.first].info, field.second);
  if (info == nullptr || is_node(info->type) || field.second == "url") return false;
  if (is("X3DBindableNode")) return field.second == "set_bind";
  return is("X3DGeometryNode") || is("X3DGeometricPropertyNode") || is("X3DFontStyleNode") || is("X3DTextureNode");
}

}  // namespace

bool is_unmade(const NodeGraph& graph, const Scripts& scripts, const EventField& field) {
  const NodeId node = field.first;
  if (bind_kind(graph, node) && says_what_is_bound(field.second)) return false;
  const bool by_hand = graph.is(node, "X3DPointingDeviceSensorNode") || graph.is(node, "X3DKeyDeviceSensorNode") ||
                       graph.is(node, "X3DNetworkSensorNode");
  constexpr std::string_view kOfFrame[] = {"rendering", "viewing", "projection"};
  const bool of_frame = graph.is(node, "RenderedTexture") && std::ranges::find(kOfFrame, field.second) != std::end(kOfFrame);
  if (by_hand || of_frame) return false;
  const EventNodeInfo* info = find_event_node(graph, scripts, node);
  if (info == nullptr && graph.is(node, "X3DScriptNode")) return true;
  if (info != nullptr && find_field_index(info->outputs, field.second) >= 0) return false;
  const std::span<const InterfaceField> own = graph[node].interface();
  const auto mine = std::ranges::find(own, field.second, &InterfaceField::name);
  if (mine != own.end()) return mine->access == AccessType::output_only;
  const FieldInfo* declared = find_field_info(*graph[node].info, field.second);
  return declared != nullptr && declared->access == FieldAccess::output_only;
}

namespace {

/// Why nothing comes of it.
std::string why_unmade(const NodeGraph& graph, const Scripts& scripts, NodeId sender) {
  if (scripts.contains(sender)) return "no function of its code stores to it";
  return fmt::format("plugc does not {} a `{}`", graph.is(sender, "X3DScriptNode") ? "run" : "evaluate",
                     graph[sender].info->name);
}

void report_ignored(SceneContext& context, const GraphRoute& route, std::string_view why) {
  context.diagnostics.report(DiagnosticId::event_ignored, route.span, std::string(why));
}

/// Routes that the standard would have move something that is drawn, but that plugc does not follow.
void report_unfollowed(SceneContext& context, const EventFlow& flow) {
  const NodeGraph& graph = context.graph;
  for (const GraphRoute& route : graph.routes()) {
    const EventField from{route.from, route.from_field}, to{route.to, route.to_field};
    const std::string_view sender = graph[route.from].info->name, receiver = graph[route.to].info->name;
    const bool fixed = is_fixed(graph, to) && !context.slots.find(to.first, to.second);
    if (fixed && flow.live.contains(from)) {
      report_ignored(context, route,
                     fmt::format("events to `{}.{}` are not followed: it is fixed when the scene is compiled, so the field "
                                 "keeps its first value",
                                 receiver, to.second));
    } else if (flow.reaching.contains(to) && is_unmade(graph, context.scripts, from)) {
      report_ignored(context, route,
                     fmt::format("`{}.{}` sends nothing: {}, so `{}.{}` keeps its first value", sender, from.second,
                                 why_unmade(graph, context.scripts, route.from), receiver, to.second));
    }
  }
}

/// What has to come before what. A vertex is a field, or a node: the field of no name.
struct OrderGraph {
  std::map<EventField, std::set<EventField>> edges;
  std::map<EventField, std::size_t> waiting;  ///< How many edges lead there from what is unfinished.

  void join(const EventField& from, const EventField& to) {
    waiting.try_emplace(from, 0);
    if (from != to && edges[from].insert(to).second) ++waiting[to];
  }

  std::vector<NodeId> nodes_in_order() {
    std::set<EventField> ready, unfinished;
    for (const auto& [vertex, count] : waiting) (count == 0 ? ready : unfinished).insert(vertex);
    std::vector<NodeId> order;
    while (!ready.empty() || !unfinished.empty()) {
      std::set<EventField>& from = ready.empty() ? unfinished : ready;  // a circle: its first one begins
      const EventField vertex = *from.begin();
      from.erase(from.begin());
      if (vertex.second.empty()) order.push_back(vertex.first);
      for (const EventField& next : edges[vertex]) {
        if (--waiting[next] == 0 && unfinished.erase(next) != 0) ready.insert(next);
      }
    }
    return order;
  }
};

class EventReader {
 public:
  EventReader(SceneContext& context, const EventFlow& flow)
      : context_(context), graph_(context.graph), scripts_(context.scripts), flow_(flow) {}

  void run(const std::map<NodeId, int>& subjects) {
    for (const GraphRoute& route : graph_.routes()) {
      if (flow_.carries(route)) add_route(route);
    }
    std::ranges::sort(context_.scene.routes);
    auto& made = context_.scene.event_nodes;
    for (const NodeId node : in_order()) {
      if (const BindStack* stack = stack_of(node))
        made.push_back(make_stack_node(context_, *stack));
      else
        add_node(node, subjects);
    }
    made.insert(made.end(), context_.chooses.begin(), context_.chooses.end());
  }

 private:
  void add_route(const GraphRoute& route);
  void add_node(NodeId node, const std::map<NodeId, int>& subjects);
  std::uint32_t slot(const EventField& field);
  std::uint32_t slot_beside(const EventField& field, const EventField& other);
  std::uint32_t input_slot(const EventField& field);
  std::vector<NodeId> in_order() const;
  NodeId stack_id(std::size_t kind) const { return {static_cast<std::uint32_t>(graph_.size() + kind)}; }
  const BindStack* stack_of(NodeId node) const;
  void join_stacks(OrderGraph& graph) const;

  SceneContext& context_;
  const NodeGraph& graph_;
  Scripts& scripts_;
  const EventFlow& flow_;
  std::set<EventField> sending_, receiving_;
  std::set<NodeId> nodes_;
};

/// How many numbers an interpolator makes whose value is a list.
std::size_t list_size(const NodeGraph& graph, NodeId node) {
  const std::size_t keys = graph.field(node, "key").numbers.size();
  return keys == 0 ? 0 : graph.field(node, "keyValue").numbers.size() / keys;
}

std::uint32_t EventReader::slot(const EventField& field) {
  const auto& [node, name] = field;
  const FieldInfo* info = find_field_info(*graph_[node].info, name);
  const bool is_list = name == "value_changed" && info != nullptr && is_multiple(info->type);
  return is_list ? context_.slots.slot_of_size(node, name, list_size(graph_, node)) : context_.slots.declared_slot(node, name);
}

/// How long a Script's list is says only who is at the other end of the route: whoever has a slot already.
std::uint32_t EventReader::slot_beside(const EventField& field, const EventField& other) {
  const auto known = context_.slots.find(other.first, other.second);
  if (!known || !scripts_.contains(field.first)) return slot(field);
  return context_.slots.list_slot(field.first, field.second, context_.scene.slots[*known].values.size());
}

void EventReader::add_route(const GraphRoute& route) {
  const EventField from{route.from, route.from_field}, to{route.to, route.to_field};
  const std::uint32_t sent = slot_beside(from, to), received = slot_beside(to, from);
  if (sent == kSceneNoSlot || received == kSceneNoSlot) return;  // strings and nodes
  const auto& slots = context_.scene.slots;
  if (slots[sent].values.size() != slots[received].values.size()) {
    return report_ignored(context_, route,
                          fmt::format("`{}.{}` sends {} numbers, but `{}.{}` holds {}, so it keeps its first value",
                                      graph_[from.first].info->name, from.second, slots[sent].values.size(),
                                      graph_[to.first].info->name, to.second, slots[received].values.size()));
  }
  context_.scene.routes.push_back({sent, received});
  sending_.insert(from);
  receiving_.insert(to);
  for (const EventField& end : {from, to}) {
    if (find_event_node(graph_, scripts_, end.first) != nullptr) nodes_.insert(end.first);
  }
}

std::uint32_t EventReader::input_slot(const EventField& field) {
  const auto& [node, name] = field;
  if (const auto known = context_.slots.find(node, name)) return *known;
  const FieldInfo* info = find_field_info(*graph_[node].info, name);
  if (info == nullptr) return kSceneNoSlot;  // of a Script: nobody sends to it
  const bool empty_list = is_multiple(info->type) && graph_.field(node, name).numbers.empty();
  return empty_list || !holds_value(info->access) ? kSceneNoSlot : context_.slots.slot_if_used(node, name);
}

void EventReader::add_node(NodeId node, const std::map<NodeId, int>& subjects) {
  const EventNodeInfo& info = *find_event_node(graph_, scripts_, node);
  const bool sends = std::ranges::any_of(info.outputs, [&](std::string_view name) { return sending_.contains({node, name}); });
  if (!sends) return;  // a viewpoint that only moves
  SceneEventNode added;
  added.kind = info.kind;
  added.node = node;
  for (const std::string_view name : info.outputs)
    added.outputs.push_back(sending_.contains({node, name}) ? slot({node, name})
                                                            : context_.slots.find(node, name).value_or(kSceneNoSlot));
  for (const std::string_view name : info.inputs) added.inputs.push_back(input_slot({node, name}));
  if (const auto subject = subjects.find(node); subject != subjects.end()) added.subject = subject->second;
  if (const auto script = scripts_.find(node); script != scripts_.end())
    added.script = std::move(script->second.program);  // nobody asks for its code again
  context_.scene.event_nodes.push_back(std::move(added));
}

/// Null for a node of the scene. A stack stands behind these.
const BindStack* EventReader::stack_of(NodeId node) const {
  return node.value < graph_.size() ? nullptr : &context_.stacks[node.value - graph_.size()];
}

/// A stack waits for what binds its nodes, and what they send waits for it.
void EventReader::join_stacks(OrderGraph& graph) const {
  for (std::size_t kind = 0; kind < context_.stacks.size(); ++kind) {
    const EventField stack{stack_id(kind), ""};
    const BindStack& members = context_.stacks[kind];
    bool takes_part = members.index != kSceneNoSlot;
    for (const NodeId node : members.nodes) {
      if (receiving_.contains({node, "set_bind"})) graph.join({node, "set_bind"}, stack);
      for (const std::string_view name : kBindOutputs) {
        if (!sending_.contains({node, name})) continue;
        graph.join(stack, {node, name});
        takes_part = true;
      }
    }
    if (takes_part) graph.waiting.try_emplace(stack, 0);
  }
}

/// Kahn's order over fields and nodes: what nothing unfinished leads to comes next.
std::vector<NodeId> EventReader::in_order() const {
  OrderGraph graph;
  for (const NodeId node : nodes_) {
    const EventNodeInfo& info = *find_event_node(graph_, scripts_, node);
    graph.waiting.try_emplace({node, ""}, 0);
    for (const std::string_view name : info.outputs) graph.join({node, ""}, {node, name});
    for (const std::string_view name : info.inputs) {
      if (receiving_.contains({node, name}) && find_field_index(info.outputs, name) < 0) graph.join({node, name}, {node, ""});
    }
  }
  join_stacks(graph);
  for (const GraphRoute& route : graph_.routes()) {
    const EventField from{route.from, route.from_field}, to{route.to, route.to_field};
    if (sending_.contains(from) && receiving_.contains(to)) graph.join(from, to);
  }
  return graph.nodes_in_order();
}

}  // namespace

void read_events(SceneContext& context) {
  if (context.graph.routes().empty() && context.chooses.empty() && context.scene.bound_viewpoint_now == kSceneNoSlot) return;
  add_set_bind_slots(context);
  const std::map<NodeId, int> subjects = find_subjects(context);
  const std::vector<EventField> drawn = context.slots.routed_fields();
  const EventFlow flow = find_event_flow(context.graph, context.scripts, drawn, context.dynamic, keys(subjects));
  report_unfollowed(context, flow);
  EventReader(context, flow).run(subjects);
}

}  // namespace plugc
