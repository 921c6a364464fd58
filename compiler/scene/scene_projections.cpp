// What lights and viewpoints project onto shapes: shadow maps that authors use as textures, and texture coordinates. Both
// name their light or viewpoint, and where that stands is known only when the whole scene has been walked.
// A map whose light shines on the shape darkens that light there (thesis, 9.2); on other shapes, and in uniforms, it is a
// texture that compares.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "scene/scene_context.h"

namespace plugc {
namespace {

/// The light where it stands first; one that stands nowhere shines on nothing, and is added.
int light_of(SceneContext& context, NodeId node) {
  const auto& lights = context.scene.lights;
  const auto found = std::ranges::find(lights, node, &SceneLight::node);
  return found == lights.end() ? add_light(context, node, -1) : static_cast<int>(found - lights.begin());
}

/// From which of its places a light that stands in several would project is left open by the specification.
void report_several_places(SceneContext& context, NodeId light) {
  const auto places = std::ranges::count(context.scene.lights, light, &SceneLight::node);
  if (places < 2) return;
  context.diagnostics.report(
      DiagnosticId::light_in_several_places, context.graph[light].type_span,
      fmt::format("this `{}` stands in {} places, and a shadow map or texture coordinates name it: they take the first",
                  context.graph[light].info->name, places));
}

void finish_projector(SceneContext& context, NodeId node, SceneProjector& projector) {
  if (context.graph.is(node, "X3DLightNode")) {
    projector.shadow_map = projection_of_light(context, light_of(context, node));
    return;
  }
  const auto& viewpoints = context.scene.viewpoints;
  const auto standing = std::ranges::find(viewpoints, node, &SceneViewpoint::node);
  const auto own = context.own_viewpoints.find(node);
  const int transform = own == context.own_viewpoints.end() ? -1 : own->second;
  projector.viewpoint = standing == viewpoints.end() ? read_viewpoint(context, node, transform) : *standing;
}

/// The map that a GeneratedShadowMap node makes; -1 when it is never drawn, which is reported.
int finish_map(SceneContext& context, NodeId node) {
  const NodeId light = context.graph.child(node, "light");
  if (!context.graph.is(light, "X3DLightNode")) {
    context.diagnostics.report(DiagnosticId::shadow_map_update_none, context.graph[node].type_span,
                               "a `GeneratedShadowMap` without `light` is never drawn, so it shadows nothing");
    return -1;
  }
  return shadow_map_of_node(context, node, light_of(context, light));
}

bool is_lit(const Scene& scene, const SceneShape& shape) {
  return shape.shader < 0 && shape.material >= 0 &&
         scene.materials[static_cast<std::size_t>(shape.material)].lighting != Lighting::unlit;
}

/// The map that the shape has as a texture counts, not the one that its light has for all.
void receive_through(SceneShape& shape, const ReceivedShadow& shadow) {
  const auto known = std::ranges::find(shape.receives, shadow.light, &ReceivedShadow::light);
  if (known == shape.receives.end())
    shape.receives.push_back(shadow);
  else
    *known = shadow;
}

/// Takes the maps of lights that shine on the shape out of its textures, into their lights. A map with effects of its own
/// stays a texture: they would find no other place.
void move_maps_into_lights(Scene& scene, SceneShape& shape) {
  if (!is_lit(scene, shape)) return;
  std::erase_if(shape.textures, [&](const TextureUse& use) {
    const SceneTexture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
    const bool compares = texture.kind == TextureKind::shadow_2d || texture.kind == TextureKind::shadow_cube;
    if (texture.shadow_map < 0 || !compares || !texture.effects.empty()) return false;
    const int index = scene.shadow_maps[static_cast<std::size_t>(texture.shadow_map)].light;
    if (std::ranges::find(shape.lights, index) == shape.lights.end()) return false;
    receive_through(shape, {index, texture.shadow_map, texture.compare});
    return true;
  });
}

/// With the method `vsm` an author reads the two moments, with any other the depths.
void show_moments(Scene& scene) {
  for (SceneTexture& texture : scene.textures) {
    if (texture.shadow_map < 0 || texture.kind != TextureKind::shadow_2d) continue;
    if (scene.shadow_maps[static_cast<std::size_t>(texture.shadow_map)].method != ShadowMethod::vsm) continue;
    texture.kind = TextureKind::image_2d;
    texture.moments = true;
  }
}

/// The lights that project something, each once.
std::set<NodeId> projecting_lights(const SceneContext& context) {
  std::set<NodeId> lights;
  for (const SceneTexture& texture : context.scene.textures) {
    if (context.graph.is(texture.node, "GeneratedShadowMap")) lights.insert(context.graph.child(texture.node, "light"));
  }
  for (const auto& [node, index] : context.projectors) lights.insert(node);
  std::erase_if(lights, [&](NodeId node) { return !context.graph.is(node, "X3DLightNode"); });
  return lights;
}

}  // namespace

int projector_index(SceneContext& context, NodeId node) {
  const bool projects =
      context.graph.is(node, "X3DLightNode") || context.graph.is(node, "Viewpoint") || context.graph.is(node, "OrthoViewpoint");
  if (!projects) return -1;
  const auto [found, added] = context.projectors.try_emplace(node, static_cast<int>(context.scene.projectors.size()));
  if (added) context.scene.projectors.emplace_back();
  return found->second;
}

void finish_projections(SceneContext& context) {
  Scene& scene = context.scene;
  for (const NodeId light : projecting_lights(context)) report_several_places(context, light);
  for (SceneTexture& texture : scene.textures) {
    if (context.graph.is(texture.node, "GeneratedShadowMap")) texture.shadow_map = finish_map(context, texture.node);
  }
  // from here a light that has a map has it, and projects through the same frustum
  for (const auto& [node, index] : context.projectors) {
    SceneProjector projector;
    finish_projector(context, node, projector);
    scene.projectors[static_cast<std::size_t>(index)] = std::move(projector);
  }
  for (SceneShape& shape : scene.shapes) move_maps_into_lights(scene, shape);
  show_moments(scene);
}

}  // namespace plugc
