// X3D 4.1, 7.2.2: of each kind of bindable nodes one is bound at a time, at the start the first that is met outside of Inlines.
// Where no event can bind another, that is the end of it. Else all of them are drawn by what one slot says, the number of the
// one that is bound: a stack, evaluated with the other events, writes it, and values that the renderer wants of the bound one
// are chosen by it.

#include "scene/scene_bindings.h"

#include <algorithm>
#include <utility>

#include "scene/scene_fog.h"

namespace plugc {
namespace {

BindStack& stack_of(SceneContext& context, BindKind kind) {
  return context.stacks[static_cast<std::size_t>(kind)];
}

/// The slot that holds what the bound one of the stack has; `otherwise` while none is bound.
std::uint32_t choose(SceneContext& context, BindKind kind, SlotType type, std::uint32_t otherwise,
                     const std::vector<std::uint32_t>& choices) {
  const BindStack& stack = stack_of(context, kind);
  const auto& slots = context.scene.slots;
  const std::uint32_t chosen = stack.first < 0 ? otherwise : choices[static_cast<std::size_t>(stack.first)];
  std::vector<double> values = slots[chosen].values;
  values.resize(component_count(type));
  SceneEventNode node;
  node.kind = EventKind::choose;
  node.inputs = {bound_index(context, kind), otherwise};
  node.inputs.insert(node.inputs.end(), choices.begin(), choices.end());
  node.outputs = {context.slots.own(type, std::move(values))};
  context.chooses.push_back(node);
  return node.outputs[0];
}

std::vector<std::uint32_t> slots_of(SceneContext& context, BindKind kind, std::string_view field) {
  std::vector<std::uint32_t> slots;
  for (const NodeId node : stack_of(context, kind).nodes) slots.push_back(context.slots.slot(node, field));
  return slots;
}

/// In layers where the first that may be seen is.
void choose_layers(SceneContext& context, SceneFog& fog) {
  const std::vector<NodeId>& nodes = stack_of(context, BindKind::fog).nodes;
  const auto seen = std::ranges::find_if(nodes, [&](NodeId node) { return may_show(context, node); });
  fog.volumetric = seen != nodes.end() && context.graph.boolean(*seen, "volumetric");
  for (const NodeId node : nodes) report_other_depth(context, node, fog.volumetric);
  if (!fog.volumetric) return;
  const std::uint32_t down = context.slots.constant(SlotType::vec3, {0, -1, 0});
  const std::uint32_t none = context.slots.constant(SlotType::float_, {0});
  fog.direction = choose(context, BindKind::fog, SlotType::vec3, down, slots_of(context, BindKind::fog, "volumetricDirection"));
  fog.start =
      choose(context, BindKind::fog, SlotType::float_, none, slots_of(context, BindKind::fog, "volumetricVisibilityStart"));
}

bool limits_sight(const SceneContext& context, NodeId navigation_info) {
  return context.graph.number(navigation_info, "visibilityLimit") > 0 ||
         context.slots.may_change(navigation_info, "visibilityLimit");
}

}  // namespace

void find_changing_stacks(SceneContext& context) {
  for (const auto& [node, field] : context.live) {
    if (field != "set_bind") continue;
    if (const auto kind = bind_kind(context.graph, node)) stack_of(context, *kind).changes = true;
  }
}

void note_bindable(SceneContext& context, NodeId node, int transform, bool may_be_first) {
  const auto kind = bind_kind(context.graph, node);
  if (!kind) return;
  BindStack& stack = stack_of(context, *kind);
  const bool is_first = may_be_first && stack.first < 0;
  if (!is_first && !stack.changes) return;
  const bool is_known = !stack.known.insert(node).second;
  if (is_known && *kind != BindKind::viewpoint) return;
  if (is_first) stack.first = static_cast<int>(stack.nodes.size());
  stack.nodes.push_back(is_known ? NodeId() : node);
  stack.transforms.push_back(transform);
}

std::uint32_t bound_index(SceneContext& context, BindKind kind) {
  BindStack& stack = stack_of(context, kind);
  if (stack.index == kSceneNoSlot) stack.index = context.slots.own(SlotType::int_, {static_cast<double>(stack.first)});
  return stack.index;
}

std::uint32_t bound_sky_color(SceneContext& context, std::uint32_t otherwise) {
  return choose(context, BindKind::background, SlotType::vec3, otherwise, slots_of(context, BindKind::background, "skyColor"));
}

int add_changing_fog(SceneContext& context) {
  const BindStack& stack = stack_of(context, BindKind::fog);
  SlotTable& slots = context.slots;
  std::vector<std::uint32_t> exponential;
  for (const NodeId node : stack.nodes)
    exponential.push_back(
        slots.constant(SlotType::float_, {context.graph.string(node, "fogType") == "EXPONENTIAL" ? 1.0 : 0.0}));
  const bool all_alike = std::ranges::all_of(exponential, [&](std::uint32_t slot) { return slot == exponential[0]; });
  const bool first_is = context.scene.slots[exponential[0]].values[0] != 0;
  SceneFog fog;
  fog.kind = !all_alike ? FogKind::either : first_is ? FogKind::exponential : FogKind::linear;
  fog.transform = stack.transforms[static_cast<std::size_t>(std::max(stack.first, 0))];
  const std::uint32_t none = slots.constant(SlotType::float_, {0}), black = slots.constant(SlotType::vec3, {0, 0, 0});
  fog.color = choose(context, BindKind::fog, SlotType::vec3, black, slots_of(context, BindKind::fog, "color"));
  fog.visibility_range =
      choose(context, BindKind::fog, SlotType::float_, none, slots_of(context, BindKind::fog, "visibilityRange"));
  if (!all_alike) fog.exponential = choose(context, BindKind::fog, SlotType::float_, none, exponential);
  choose_layers(context, fog);
  context.scene.fogs.push_back(fog);
  return static_cast<int>(context.scene.fogs.size() - 1);
}

void add_changing_headlight(SceneContext& context) {
  add_headlight(context, NodeId());
  SceneLight& light = context.scene.lights.back();
  light.on = choose(context, BindKind::navigation_info, SlotType::bool_, light.on,
                    slots_of(context, BindKind::navigation_info, "headlight"));
}

std::uint32_t visibility_limit(SceneContext& context, NodeId first) {
  const BindStack& stack = stack_of(context, BindKind::navigation_info);
  const auto limits = [&](NodeId node) { return limits_sight(context, node); };
  if (!stack.changes) return first.valid() && limits(first) ? context.slots.slot(first, "visibilityLimit") : kSceneNoSlot;
  if (std::ranges::none_of(stack.nodes, limits)) return kSceneNoSlot;
  return choose(context, BindKind::navigation_info, SlotType::float_, context.slots.constant(SlotType::float_, {0}),
                slots_of(context, BindKind::navigation_info, "visibilityLimit"));
}

void add_set_bind_slots(SceneContext& context) {
  for (const BindStack& stack : context.stacks) {
    for (const NodeId node : stack.nodes) {
      if (node.valid() && context.live.contains({node, "set_bind"})) context.slots.declared_slot(node, "set_bind");
    }
  }
}

SceneEventNode make_stack_node(const SceneContext& context, const BindStack& stack) {
  SceneEventNode node;
  node.kind = EventKind::bind_stack;
  node.subject = stack.first;
  node.outputs = {stack.index};
  const auto slot_of = [&](NodeId one, std::string_view field) {
    return context.slots.find(one, field).value_or(kSceneNoSlot);
  };
  for (const NodeId one : stack.nodes) node.inputs.push_back(slot_of(one, "set_bind"));
  for (const std::string_view field : {"isBound", "bindTime"}) {
    for (const NodeId one : stack.nodes) node.outputs.push_back(slot_of(one, field));
  }
  return node;
}

}  // namespace plugc
