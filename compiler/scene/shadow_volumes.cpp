#include "scene/shadow_volumes.h"

#include <algorithm>

namespace plugc {
namespace {

bool has_volumes(const NodeGraph& graph, const SceneLight& light) {
  return light.node.valid() && (graph.boolean(light.node, "shadowVolumes") || graph.boolean(light.node, "kambiShadows"));
}

bool is_main(const NodeGraph& graph, const SceneLight& light) {
  return light.node.valid() &&
         (graph.boolean(light.node, "shadowVolumesMain") || graph.boolean(light.node, "kambiShadowsMain"));
}

}  // namespace

bool has_shadow_volumes(const NodeGraph& graph, const Scene& scene) {
  const auto any = [&](auto has) {
    return std::ranges::any_of(scene.lights, [&](const SceneLight& light) { return has(graph, light); });
  };
  return any(is_main) && any(has_volumes);
}

void cast_for_volumes(const NodeGraph& graph, Scene& scene) {
  if (!has_shadow_volumes(graph, scene)) return;
  for (SceneLight& light : scene.lights) light.casts_on_all = light.casts_on_all || has_volumes(graph, light);
}

}  // namespace plugc
