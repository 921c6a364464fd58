// Fog and LocalFog (X3D 4.1, clause 24). A rendered texture may show the world in another fog than the picture. The world's
// shapes have one program each, so while such a texture is drawn the values of its fog stand in the place of the world's; where
// their types differ, the type is a value, too. Whether it lies in layers is no value: a program has the one depth or the
// other.

#include "scene/scene_fog.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace plugc {

namespace {

FogKind read_kind(const NodeGraph& graph, NodeId fog) {
  return graph.string(fog, "fogType") == "EXPONENTIAL" ? FogKind::exponential : FogKind::linear;
}

/// One that hides nothing, until one as `like` lends it its values.
int add_clear_fog(SceneContext& context, NodeId like) {
  SceneFog fog;
  fog.kind = read_kind(context.graph, like);
  fog.color = context.slots.own(SlotType::vec3, {1, 1, 1});
  fog.visibility_range = context.slots.own(SlotType::float_, {0});
  fog.volumetric = context.graph.boolean(like, "volumetric");
  if (fog.volumetric) {
    fog.direction = context.slots.own(SlotType::vec3, {0, -1, 0});
    fog.start = context.slots.own(SlotType::float_, {0});
  }
  context.scene.fogs.push_back(fog);
  return static_cast<int>(context.scene.fogs.size() - 1);
}

struct OwnFog {
  SceneRenderedTexture* texture = nullptr;
  NodeId node;
};

std::vector<OwnFog> own_fogs(SceneContext& context) {
  std::vector<OwnFog> found;
  for (SceneRenderedTexture& texture : context.scene.rendered_textures) {
    if (texture.own_scene || !context.graph.has_field(texture.node, "fog")) continue;
    const NodeId fog = context.graph.child(texture.node, "fog");
    if (context.graph.is(fog, "Fog")) found.push_back({&texture, fog});
  }
  return found;
}

}  // namespace

bool may_show(const SceneContext& context, NodeId fog) {
  return context.graph.number(fog, "visibilityRange") > 0 || context.slots.may_change(fog, "visibilityRange");
}

void report_other_depth(SceneContext& context, NodeId fog, bool volumetric) {
  if (context.graph.boolean(fog, "volumetric") == volumetric || !may_show(context, fog)) return;
  context.diagnostics.report(
      DiagnosticId::not_drawn, context.graph[fog].type_span,
      fmt::format("this fog is drawn with `volumetric {}`, as the one whose place it takes", volumetric ? "TRUE" : "FALSE"));
}

int add_fog(SceneContext& context, NodeId node, int transform) {
  SlotTable& slots = context.slots;
  if (!may_show(context, node)) return -1;
  SceneFog fog;
  fog.kind = read_kind(context.graph, node);
  fog.transform = transform;
  fog.color = slots.slot(node, "color");
  fog.visibility_range = slots.slot(node, "visibilityRange");
  fog.volumetric = context.graph.boolean(node, "volumetric");
  if (fog.volumetric) {
    fog.direction = slots.slot(node, "volumetricDirection");
    fog.start = slots.slot(node, "volumetricVisibilityStart");
  }
  context.scene.fogs.push_back(fog);
  return static_cast<int>(context.scene.fogs.size() - 1);
}

void lend_own_fogs(SceneContext& context, std::optional<int>& bound) {
  const NodeGraph& graph = context.graph;
  const std::vector<OwnFog> own = own_fogs(context);
  if (own.empty()) return;
  if (bound.value_or(-1) < 0) bound = add_clear_fog(context, own.front().node);
  SceneFog& world = context.scene.fogs[static_cast<std::size_t>(*bound)];
  const bool differ = std::ranges::any_of(own, [&](const OwnFog& fog) { return read_kind(graph, fog.node) != world.kind; });
  if (differ && world.kind != FogKind::either) {
    world.exponential = context.slots.own(SlotType::float_, {world.kind == FogKind::exponential ? 1.0 : 0.0});
    world.kind = FogKind::either;
  }
  for (const OwnFog& fog : own) {
    std::vector<SlotLoan>& loans = fog.texture->loans;
    loans.push_back({context.slots.slot(fog.node, "color"), world.color});
    loans.push_back({context.slots.slot(fog.node, "visibilityRange"), world.visibility_range});
    report_other_depth(context, fog.node, world.volumetric);
    if (world.volumetric) {
      loans.push_back({context.slots.slot(fog.node, "volumetricDirection"), world.direction});
      loans.push_back({context.slots.slot(fog.node, "volumetricVisibilityStart"), world.start});
    }
    if (!differ) continue;
    const double exponential = read_kind(graph, fog.node) == FogKind::exponential ? 1 : 0;
    loans.push_back({context.slots.constant(SlotType::float_, {exponential}), world.exponential});
  }
}

}  // namespace plugc
