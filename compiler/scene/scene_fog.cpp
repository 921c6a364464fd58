// Fog and LocalFog (X3D 4.1, clause 24).

#include "scene/scene_context.h"

namespace plugc {

int add_fog(SceneContext& context, NodeId node, int transform) {
  SlotTable& slots = context.slots;
  if (context.graph.number(node, "visibilityRange") <= 0 && !slots.may_change(node, "visibilityRange")) return -1;
  SceneFog fog;
  fog.kind = context.graph.string(node, "fogType") == "EXPONENTIAL" ? FogKind::exponential : FogKind::linear;
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

}  // namespace plugc
