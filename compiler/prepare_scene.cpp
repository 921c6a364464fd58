// Meshes are shared by geometry node and texture coordinates, images by file, recipes by value.

#include "prepare_scene.h"

#include <algorithm>
#include <map>
#include <memory>

#include "base/limits.h"
#include "compose/check_fields.h"
#include "image/load_images.h"
#include "mesh/live_vertices.h"
#include "mesh/mesh.h"
#include "mesh/tangents.h"
#include "mesh/unit_coords.h"
#include "prepare_backdrop.h"
#include "prepare_shadows.h"
#include "scene/shadow_volumes.h"
#include "shadow_geometry.h"
#include "still_shadows.h"

namespace plugc {
namespace {

std::vector<UnitCoords> unit_coords(const SceneShape& shape) {
  std::vector<UnitCoords> units;
  for (const TextureUse& use : shape.textures) {
    if (units.size() == kMaxTexCoordSets) break;  // no program reads coordinates of so many textures
    units.push_back({use.coord, use.coord == VertexCoord::own ? use.unit : 0});
  }
  return are_plain(units) ? std::vector<UnitCoords>() : units;
}

void prepare_meshes(const NodeGraph& graph, SceneParts& parts, MeshCache& made, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < parts.scene.shapes.size(); ++i) {
    if (parts.scene.shapes[i].part != ScenePart::world) continue;
    const NodeId geometry = parts.scene.shapes[i].geometry;
    const auto shared = [&](Mesh mesh) { return share_mesh(made, std::move(mesh), graph[geometry].type_span, diagnostics); };
    const auto [plain, added] = made.by_node.try_emplace({geometry, {}});
    if (added) {
      if (auto mesh = make_mesh(graph, geometry, diagnostics, parts.scene.vertex_fields))
        plain->second = shared(std::move(*mesh));
    }
    parts.shapes[i].mesh = plain->second;
    const std::vector<UnitCoords> units = unit_coords(parts.scene.shapes[i]);
    if (plain->second == nullptr || units.empty()) continue;
    const auto [found, is_new] = made.by_node.try_emplace({geometry, units});
    if (is_new) found->second = shared(with_unit_coords(*plain->second, units));
    parts.shapes[i].mesh = found->second;
  }
}

/// Faces that are neither filled nor hatched (X3D 4.1, FillProperties) are not there, and cast no shadow; hatches cast none.
void prepare_fill(SceneParts& parts) {
  for (std::size_t i = 0; i < parts.scene.shapes.size(); ++i) {
    SceneShape& shape = parts.scene.shapes[i];
    std::shared_ptr<const Mesh>& mesh = parts.shapes[i].mesh;
    if (mesh == nullptr || mesh->topology != Topology::triangles || shape.style.filled) continue;
    shape.casts_shadow = false;
    if (shape.style.hatch == 0) mesh = nullptr;
  }
}

std::shared_ptr<const LiveVertices> with_tangent_unit(const LiveVertices& live, std::size_t unit) {
  auto result = std::make_shared<LiveVertices>(live);
  result->tangent_unit = static_cast<int>(unit);
  return result;
}

std::shared_ptr<const Mesh> add_tangents(const Mesh& mesh, std::size_t unit) {
  auto result = std::make_shared<Mesh>(mesh);
  result->tangents = make_tangents(mesh, mesh.tex_coords[unit]);
  if (mesh.live != nullptr && !result->tangents.empty()) result->live = with_tangent_unit(*mesh.live, unit);
  return result;
}

/// Meshes with a normal map get tangents, each for the coordinates that the map is read with, unless their author wrote some.
void prepare_tangents(const NodeGraph& graph, SceneParts& parts, MeshCache& made, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < parts.scene.shapes.size(); ++i) {
    const auto& textures = parts.scene.shapes[i].textures;
    const auto map = std::ranges::find(textures, TextureRole::normal, &TextureUse::role);
    std::shared_ptr<const Mesh>& mesh = parts.shapes[i].mesh;
    if (mesh == nullptr || !mesh->tangents.empty() || map == textures.end() || mesh->tex_coords.empty()) continue;
    const auto unit = std::min(static_cast<std::size_t>(map - textures.begin()), mesh->tex_coords.size() - 1);
    const auto [found, added] = made.with_tangents.try_emplace({mesh, unit}, nullptr);
    const Span& place = graph[parts.scene.shapes[i].geometry].type_span;
    if (added && take_vertices(made.budget, mesh->positions.size(), place, diagnostics))
      found->second = add_tangents(*mesh, unit);
    if (found->second != nullptr) mesh = found->second;
  }
}

void prepare_effect_code(const Scene& scene, PreparedScene& prepared, Diagnostics& diagnostics) {
  const auto outline_all = [&](const std::vector<SceneEffect>& authors, std::vector<EffectCode>& codes) {
    for (const SceneEffect& author : authors) {
      codes.push_back(make_effect_code(author, diagnostics));
      check_fields(scene, author, codes.back(), diagnostics);
    }
  };
  outline_all(scene.effects, prepared.effects);
  outline_all(scene.shaders, prepared.shaders);
}

/// By texture coordinate unit: some q is not 1, or will not be.
std::vector<bool> projective_units(const Mesh& mesh) {
  std::vector<bool> projective;
  for (const std::vector<glm::vec4>& coords : mesh.tex_coords) {
    const auto unit = static_cast<unsigned>(projective.size());
    projective.push_back(fed_width(mesh, unit) == 4 ||
                         std::ranges::any_of(coords, [](const glm::vec4& coord) { return coord.w != 1.0F; }));
  }
  return projective;
}

bool has_translucent_colors(const Mesh& mesh) {
  return std::ranges::any_of(mesh.colors, [](const glm::vec4& color) { return color.a < 1; });
}

/// What only all of a mesh's vertices tell.
struct MeshFacts {
  bool translucent_colors = false;
  std::vector<bool> projective;  ///< By texture coordinate unit.
};

/// Of each mesh once: many shapes may share one.
std::map<const Mesh*, MeshFacts> find_mesh_facts(const SceneParts& parts) {
  std::map<const Mesh*, MeshFacts> facts;
  for (const ShapePlan& plan : parts.shapes) {
    const auto [known, added] = facts.try_emplace(plan.mesh.get());
    if (added && plan.mesh != nullptr) known->second = {has_translucent_colors(*plan.mesh), projective_units(*plan.mesh)};
  }
  return facts;
}

Primitive primitive_of(const Mesh& mesh) {
  switch (mesh.topology) {
    case Topology::points: return Primitive::points;
    case Topology::lines: return Primitive::lines;
    case Topology::triangles: break;
  }
  return Primitive::triangles;
}

/// X3D 4.1, 12.2.3: as alphaMode says, else alpha between 0 and 1 blends and alpha that is all or nothing is tested.
AlphaUse shape_alpha(const SceneParts& parts, const SceneShape& shape, const MeshFacts& mesh) {
  if (shape.alpha_mode == AlphaMode::opaque) return AlphaUse::opaque;
  if (shape.alpha_mode == AlphaMode::mask) return AlphaUse::tested;
  if (shape.alpha_mode == AlphaMode::blend) return AlphaUse::blended;
  if (mesh.translucent_colors) return AlphaUse::blended;
  AlphaUse use = AlphaUse::opaque;
  for (const int material : {shape.material, shape.back_material}) {
    if (material < 0) continue;
    const Slot& transparency = parts.scene.slots[parts.scene.materials[static_cast<std::size_t>(material)].transparency];
    if (transparency.routed || transparency.values[0] > 0) return AlphaUse::blended;
  }
  for (const TextureUse& texture : shape.textures) {
    if (texture.role != TextureRole::main) continue;
    const auto& image = parts.images[static_cast<std::size_t>(texture.texture)];
    if (image != nullptr) use = std::max(use, image->alpha);
  }
  return use;
}

/// Recipes, each once.
class RecipeList {
 public:
  explicit RecipeList(std::vector<StateRecipe>& recipes) : recipes_(recipes) {}

  int add(const Recipe& recipe, int fuller) {
    const auto [found, added] = known_.try_emplace(recipe, static_cast<int>(recipes_.size()));
    if (added) recipes_.push_back({recipe, fuller});
    if (fuller < 0) recipes_[static_cast<std::size_t>(found->second)].fuller = -1;  // some shape needs it for itself
    return found->second;
  }

 private:
  std::vector<StateRecipe>& recipes_;
  std::map<Recipe, int> known_;
};

ShapeFacts shape_facts(const PreparedScene& prepared, const SceneShape& shape, const Mesh& mesh, const MeshFacts& of_mesh,
                       AlphaUse alpha) {
  const bool shader_has_geometry =
      shape.shader >= 0 && prepared.shaders[static_cast<std::size_t>(shape.shader)].has_geometry_main;
  return {.has_normals = !mesh.normals.empty(),
          .has_colors = !mesh.colors.empty(),
          .solid = mesh.solid,
          .alpha_test = alpha == AlphaUse::tested,
          .projective = of_mesh.projective,
          .primitive = primitive_of(mesh),
          .has_fog_coords = !mesh.fog_coords.empty(),
          .has_tangents = !mesh.tangents.empty(),
          .shader_has_geometry = shader_has_geometry};
}

/// Which depth passes there are in a scene, or for a shape.
struct DepthPasses {
  bool flat = false;  ///< Of directional and spot lights.
  bool of_point_lights = false;
  bool cut_near = false;  ///< Some point light's `projectionNear` may be other than 0.
};

bool may_cut_near(const Slot& near) {
  return near.routed || near.values[0] != 0;
}

DepthPasses depth_passes(const Scene& scene) {
  DepthPasses passes;
  for (const SceneShadowMap& map : scene.shadow_maps) {
    if (map.update == ShadowUpdate::none) continue;
    const bool point = scene.lights[static_cast<std::size_t>(map.light)].kind == LightKind::point;
    (point ? passes.of_point_lights : passes.flat) = true;
    if (point) passes.cut_near = passes.cut_near || may_cut_near(scene.slots[map.near]);
  }
  return passes;
}

/// A ComposedShader that discards fragments: which ones, only the whole of it knows, so its own program draws the depths, too.
/// It writes no distances, so the map of a point light shows it without holes.
bool draws_its_depths(const Recipe& recipe, const std::vector<EffectCode>& shaders) {
  return recipe.shader >= 0 && shaders[static_cast<std::size_t>(recipe.shader)].discards;
}

/// The programs of all states of a shape: first those with most in them, which others are reductions of.
void plan_variants(ShapeStates states, const DepthPasses& passes, const PreparedScene& prepared, RecipeList& recipes,
                   ShapePlan& plan) {
  const std::vector<EffectCode>& effects = prepared.effects;
  plan.variants.resize(states.recipes.size());
  for (const bool reduced : {false, true}) {
    for (std::size_t i = 0; i < states.recipes.size(); ++i) {
      const StateRecipe& wanted = states.recipes[i];
      if ((wanted.fuller >= 0) != reduced) continue;
      const PlannedVariant fuller = reduced ? plan.variants[static_cast<std::size_t>(wanted.fuller)] : PlannedVariant();
      plan.variants[i].program = recipes.add(wanted.recipe, fuller.program);
      PlannedVariant& variant = plan.variants[i];
      if (passes.flat) {
        variant.depth_program = draws_its_depths(wanted.recipe, prepared.shaders)
                                    ? variant.program
                                    : recipes.add(make_depth_recipe(wanted.recipe, effects), fuller.depth_program);
      }
      if (passes.of_point_lights) {
        Recipe depth = make_depth_recipe(wanted.recipe, effects, true);
        depth.cut_near = passes.cut_near;
        variant.point_depth_program = recipes.add(depth, fuller.point_depth_program);
      }
    }
  }
  plan.switches = std::move(states.switches);
  plan.states = std::move(states.states);
}

/// The programs that turn depths into moments, for the maps that keep them.
void plan_maps(SceneParts& parts, RecipeList& recipes) {
  for (const SceneShadowMap& map : parts.scene.shadow_maps) {
    MapPlan plan;
    if (keeps_moments(map.method)) {
      const auto [moments, blur] = make_map_recipes(map.method);
      plan = {recipes.add(moments, -1), recipes.add(blur, -1)};
    }
    parts.maps.push_back(plan);
  }
}

void plan_screen_effects(SceneParts& parts, RecipeList& recipes) {
  for (const SceneScreenEffect& effect : parts.scene.screen_effects)
    parts.screen_programs.push_back(recipes.add(make_screen_recipe(effect), -1));
}

/// By shape.
std::vector<AlphaUse> prepare_alpha(SceneParts& parts, const std::map<const Mesh*, MeshFacts>& meshes) {
  std::vector<AlphaUse> alpha;
  for (std::size_t i = 0; i < parts.shapes.size(); ++i) {
    alpha.push_back(shape_alpha(parts, parts.scene.shapes[i], meshes.at(parts.shapes[i].mesh.get())));
    parts.shapes[i].blended = alpha.back() == AlphaUse::blended;
  }
  return alpha;
}

void prepare_recipes(PreparedScene& prepared, const std::map<const Mesh*, MeshFacts>& meshes,
                     const std::vector<AlphaUse>& alpha) {
  SceneParts& parts = prepared.parts;
  RecipeList recipes(prepared.recipes);
  const DepthPasses passes = needs_casters(parts.scene) ? depth_passes(parts.scene) : DepthPasses();
  for (std::size_t i = 0; i < parts.scene.shapes.size(); ++i) {
    const SceneShape& shape = parts.scene.shapes[i];
    ShapePlan& plan = parts.shapes[i];
    if (plan.mesh == nullptr) continue;
    const ShapeFacts facts = shape_facts(prepared, shape, *plan.mesh, meshes.at(plan.mesh.get()), alpha[i]);
    plan_variants(make_shape_states(parts.scene, shape, facts, prepared.effects),
                  casts_shadow(parts, i) ? passes : DepthPasses(), prepared, recipes, plan);
  }
  plan_maps(parts, recipes);
  plan_screen_effects(parts, recipes);
}

}  // namespace

PreparedScene prepare_scene(const NodeGraph& graph, Scene scene, PreparedFor purpose, FileAccess& files,
                            Diagnostics& diagnostics, MeshCache& meshes, KnownImages* images) {
  PreparedScene prepared;
  SceneParts& parts = prepared.parts;
  parts.scene = std::move(scene);
  parts.shapes.resize(parts.scene.shapes.size());
  const auto detail = purpose == PreparedFor::checking ? ImageDetail::facts : ImageDetail::pixels;
  parts.images = load_images(graph, parts.scene, files, diagnostics, detail, images);
  drop_missing_textures(parts.scene, parts.images);
  // from here textures have their final numbers, which those of texture coordinates follow
  prepare_meshes(graph, parts, meshes, diagnostics);
  prepare_fill(parts);
  prepare_backdrop(graph, parts, meshes.budget, diagnostics);
  prepare_tangents(graph, parts, meshes, diagnostics);
  prepare_effect_code(parts.scene, prepared, diagnostics);
  mark_author_visible_maps(prepared.effects, prepared.shaders, parts.scene);
  mark_maps_of_other_light(prepared.effects, parts.scene);
  const std::map<const Mesh*, MeshFacts> facts = find_mesh_facts(parts);
  const std::vector<AlphaUse> alpha = prepare_alpha(parts, facts);
  replace_untraceable_maps(graph, prepared.effects, alpha, parts, diagnostics);
  parts.blended_shapes_cast = has_shadow_volumes(graph, parts.scene);
  if (purpose != PreparedFor::library) drop_impossible_shadows(prepared.effects, parts);
  prepare_recipes(prepared, facts, alpha);
  return prepared;
}

}  // namespace plugc
