// Meshes are shared by geometry node, images by file, recipes by value.

#include "prepare_scene.h"

#include <algorithm>
#include <map>
#include <memory>

#include "compose/check_fields.h"
#include "image/load_images.h"
#include "mesh/mesh.h"

namespace plugc {
namespace {

void prepare_meshes(const NodeGraph& graph, SceneParts& parts, Diagnostics& diagnostics) {
  std::map<NodeId, std::shared_ptr<const Mesh>> made;
  for (std::size_t i = 0; i < parts.scene.shapes.size(); ++i) {
    const NodeId geometry = parts.scene.shapes[i].geometry;
    const auto [found, added] = made.try_emplace(geometry);
    if (added) {
      if (auto mesh = make_mesh(graph, geometry, diagnostics)) found->second = std::make_shared<const Mesh>(std::move(*mesh));
    }
    parts.shapes[i].mesh = found->second;
  }
}

void prepare_effect_code(const Scene& scene, PreparedScene& prepared, Diagnostics& diagnostics) {
  const auto outline_all = [&](const std::vector<SceneEffect>& authors, std::vector<EffectCode>& codes) {
    for (const SceneEffect& author : authors) {
      codes.push_back(make_effect_code(author, diagnostics));
      check_fields(author, codes.back(), diagnostics);
    }
  };
  outline_all(scene.effects, prepared.effects);
  outline_all(scene.shaders, prepared.shaders);
}

Primitive primitive_of(const Mesh& mesh) {
  switch (mesh.topology) {
    case Topology::points: return Primitive::points;
    case Topology::lines: return Primitive::lines;
    case Topology::triangles: break;
  }
  return Primitive::triangles;
}

/// X3D 4.1, 12.2.3: alpha between 0 and 1 blends, alpha that is all or nothing is tested.
AlphaUse shape_alpha(const SceneParts& parts, const SceneShape& shape) {
  AlphaUse use = AlphaUse::opaque;
  if (shape.material >= 0) {
    const Slot& transparency = parts.scene.slots[parts.scene.materials[static_cast<std::size_t>(shape.material)].transparency];
    if (transparency.routed || transparency.values[0] > 0) return AlphaUse::blended;
  }
  for (const TextureUse& texture : shape.textures) {
    use = std::max(use, alpha_use(*parts.images[static_cast<std::size_t>(texture.texture)]));
  }
  return use;
}

void prepare_recipes(PreparedScene& prepared) {
  SceneParts& parts = prepared.parts;
  std::map<Recipe, int> known;
  const auto recipe_index = [&](const Recipe& recipe) {
    const auto [found, added] = known.try_emplace(recipe, static_cast<int>(prepared.recipes.size()));
    if (added) prepared.recipes.push_back(recipe);
    return found->second;
  };
  for (std::size_t i = 0; i < parts.scene.shapes.size(); ++i) {
    const SceneShape& shape = parts.scene.shapes[i];
    ShapePlan& plan = parts.shapes[i];
    if (plan.mesh == nullptr) continue;
    const AlphaUse alpha = shape_alpha(parts, shape);
    plan.blended = alpha == AlphaUse::blended;
    const bool shader_has_geometry =
        shape.shader >= 0 && prepared.shaders[static_cast<std::size_t>(shape.shader)].has_geometry_main;
    const ShapeFacts facts{!plan.mesh->normals.empty(), !plan.mesh->colors.empty(), plan.mesh->solid,
                           alpha == AlphaUse::tested,   primitive_of(*plan.mesh),   shader_has_geometry};
    const Recipe recipe = make_recipe(parts.scene, shape, facts, prepared.effects);
    plan.program = recipe_index(recipe);
    const bool casts =
        shape.casts_shadow && !plan.blended && !parts.scene.shadow_maps.empty() && plan.mesh->topology == Topology::triangles;
    if (casts) plan.depth_program = recipe_index(make_depth_recipe(recipe, prepared.effects));
  }
}

}  // namespace

PreparedScene prepare_scene(const NodeGraph& graph, Scene scene, FileAccess& files, Diagnostics& diagnostics) {
  PreparedScene prepared;
  SceneParts& parts = prepared.parts;
  parts.scene = std::move(scene);
  parts.shapes.resize(parts.scene.shapes.size());
  prepare_meshes(graph, parts, diagnostics);
  parts.images = load_images(graph, parts.scene, files, diagnostics);
  drop_missing_textures(parts.scene, parts.images);
  prepare_effect_code(parts.scene, prepared, diagnostics);
  prepare_recipes(prepared);
  return prepared;
}

}  // namespace plugc
