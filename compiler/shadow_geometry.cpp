// A shape's program holds the effects of its lights and textures beside its own. One that finds no marker of its plug in the
// code of its light or texture gets its call in the shape's, so a light's `vertex_object_space_change` moves every shape that
// the light reaches, and a `main` of any of them makes a geometry stage. (Depth passes have no lights, so there it moves
// nothing; what is seen is elsewhere all the same.)

#include "shadow_geometry.h"

#include <algorithm>

namespace plugc {
namespace {

bool any_effect(const Scene& scene, const SceneShape& shape, const std::vector<EffectCode>& effects, auto predicate) {
  const auto any_of_list = [&](const std::vector<int>& list) {
    return std::ranges::any_of(list, [&](int effect) { return predicate(effects[static_cast<std::size_t>(effect)]); });
  };
  const auto of_light = [&](int light) { return any_of_list(scene.lights[static_cast<std::size_t>(light)].effects); };
  const auto of_texture = [&](const TextureUse& use) {
    return any_of_list(scene.textures[static_cast<std::size_t>(use.texture)].effects);
  };
  return any_of_list(shape.effects) || std::ranges::any_of(shape.lights, of_light) ||
         std::ranges::any_of(shape.textures, of_texture);
}

}  // namespace

bool casts_shadow(const SceneParts& parts, std::size_t index) {
  const ShapePlan& plan = parts.shapes[index];
  return parts.scene.shapes[index].casts_shadow && (!plan.blended || parts.blended_shapes_cast) && plan.mesh != nullptr &&
         plan.mesh->topology == Topology::triangles;
}

bool may_move_vertices(const Scene& scene, const SceneShape& shape, const std::vector<EffectCode>& effects) {
  const auto moves = [](const EffectCode& code) { return code.moves_vertices || code.has_geometry_main; };
  return shape.shader >= 0 || any_effect(scene, shape, effects, moves);
}

bool may_cut_holes(const Scene& scene, const SceneShape& shape, const std::vector<EffectCode>& effects) {
  return any_effect(scene, shape, effects, [](const EffectCode& code) { return code.discards; });
}

bool lays_alpha_elsewhere(const SceneParts& parts, const SceneShape& shape) {
  return std::ranges::any_of(shape.textures, [&](const TextureUse& use) {
    const auto& image = parts.images[static_cast<std::size_t>(use.texture)];
    const bool has_alpha = image != nullptr && image->channels % 2 == 0;
    return has_alpha && (use.unit != 0 || use.transform >= 0 || use.generator != CoordGenerator::none);
  });
}

}  // namespace plugc
