#include "package/pack_shape.h"

#include <algorithm>
#include <tuple>

#include "compose/castle_names.h"
#include "package/pack_bindings.h"
#include "package/pack_style.h"

namespace plugc {
namespace {

/// Whether the shape's vertices lie where its mesh says.
bool has_known_bounds(const Recipe& recipe, const ValidRecipe& program) {
  const bool has_geometry = std::ranges::any_of(program.targets, [](const TargetProgram& target) {
    const auto& stages = target.program.stages();
    return std::ranges::find(stages, ShaderStage::geometry, &StageText::stage) != stages.end();
  });
  if (has_geometry) return false;
  const bool moves_vertices =
      std::ranges::any_of(program.targets, [](const TargetProgram& target) { return target.composed.moves_vertices; });
  return recipe.shader < 0 && !moves_vertices;
}

PackedVariantT pack_variant(const SceneParts& parts, const PlannedVariant& planned, const BindingContext& context,
                            const Packed& packed) {
  PackedVariantT variant;
  variant.program = packed.programs[static_cast<std::size_t>(planned.program)];
  variant.bindings = pack_bindings(parts.programs[static_cast<std::size_t>(planned.program)], context);
  const auto pack_depth = [&](int recipe, std::int32_t& program, std::vector<PackedBinding>& bindings) {
    if (recipe < 0 || packed.programs[static_cast<std::size_t>(recipe)] == kNothing) return;
    program = static_cast<std::int32_t>(packed.programs[static_cast<std::size_t>(recipe)]);
    bindings = pack_bindings(parts.programs[static_cast<std::size_t>(recipe)], context);
  };
  pack_depth(planned.depth_program, variant.depth_program, variant.depth_bindings);
  pack_depth(planned.point_depth_program, variant.point_depth_program, variant.point_depth_bindings);
  return variant;
}

bool are_equal(const std::vector<PackedBinding>& a, const std::vector<PackedBinding>& b) {
  return std::ranges::equal(a, b, [](const PackedBinding& x, const PackedBinding& y) {
    return std::tuple(x.uniform(), x.a(), x.b(), x.scale(), x.source()) ==
           std::tuple(y.uniform(), y.a(), y.b(), y.scale(), y.source());
  });
}

bool are_equal(const PackedVariantT& a, const PackedVariantT& b) {
  return a.program == b.program && a.depth_program == b.depth_program && a.point_depth_program == b.point_depth_program &&
         are_equal(a.bindings, b.bindings) && are_equal(a.depth_bindings, b.depth_bindings) &&
         are_equal(a.point_depth_bindings, b.point_depth_bindings);
}

PackedSwitch pack_switch(const Scene& scene, const ShapeSwitch& one) {
  if (one.of_light) return {static_cast<std::uint32_t>(one.index), PackedSwitchKind::light};
  return {scene.effects[static_cast<std::size_t>(one.index)].enabled, PackedSwitchKind::slot};
}

/// The shape's programs, each once, and which it is drawn with in which state. A state whose program is not valid, even with
/// no effect in it, has the first that is.
void pack_variants(const SceneParts& parts, std::size_t index, const Packed& where, PackedShapeT& packed) {
  const ShapePlan& plan = parts.shapes[index];
  const BindingContext context{parts.scene, parts.scene.shapes[index], where.textures, where.fog_planes};
  std::vector<PackedVariantT> variants;
  std::vector<std::uint8_t> numbers;  // by planned variant
  for (const PlannedVariant& planned : plan.variants) {
    const bool valid = where.programs[static_cast<std::size_t>(planned.program)] != kNothing;
    std::size_t number = 0;
    if (valid) {
      PackedVariantT variant = pack_variant(parts, planned, context, where);
      const auto same = std::ranges::find_if(variants, [&](const PackedVariantT& known) { return are_equal(known, variant); });
      number = static_cast<std::size_t>(same - variants.begin());
      if (number == variants.size()) variants.push_back(std::move(variant));
    }
    numbers.push_back(static_cast<std::uint8_t>(number));
  }
  packed.program = variants.front().program;
  packed.bindings = std::move(variants.front().bindings);
  packed.depth_program = variants.front().depth_program;
  packed.depth_bindings = std::move(variants.front().depth_bindings);
  packed.point_depth_program = variants.front().point_depth_program;
  packed.point_depth_bindings = std::move(variants.front().point_depth_bindings);
  if (variants.size() == 1) return;
  for (const ShapeSwitch& one : plan.switches) packed.switches.push_back(pack_switch(parts.scene, one));
  for (const std::uint8_t state : plan.states) packed.states.push_back(numbers[state]);
  for (std::size_t i = 1; i < variants.size(); ++i)
    packed.variants.push_back(std::make_unique<PackedVariantT>(std::move(variants[i])));
}

bool all_bounds_known(const SceneParts& parts, const ShapePlan& plan) {
  return std::ranges::all_of(plan.variants, [&](const PlannedVariant& variant) {
    const ValidRecipe& program = parts.programs[static_cast<std::size_t>(variant.program)];
    return program.targets.empty() || has_known_bounds(program.used, program);
  });
}

/// Sets of texture coordinates that some program of the shape reads.
std::uint32_t units_read(const SceneParts& parts, const ShapePlan& plan) {
  std::uint32_t units = 0;
  for (const PlannedVariant& variant : plan.variants)
    units = std::max(units, coordinate_units(parts.programs[static_cast<std::size_t>(variant.program)]));
  return units;
}

bool is_of_mirror(const Scene& scene, int texture) {
  if (texture < 0) return false;
  const int rendered = scene.textures[static_cast<std::size_t>(texture)].rendered;
  return rendered >= 0 && scene.rendered_textures[static_cast<std::size_t>(rendered)].in_mirror;
}

bool has_field_of_mirror(const Scene& scene, const SceneEffect& effect) {
  return std::ranges::any_of(effect.fields, [&](const ShaderField& field) {
    return std::ranges::any_of(field.textures, [&](int texture) { return is_of_mirror(scene, texture); });
  });
}

/// Whether something on the shape takes it for a flat mirror.
bool is_mirror(const Scene& scene, const SceneShape& shape) {
  if (shape.part != ScenePart::world) return false;
  const auto by_texture = [&](const TextureUse& use) {
    return use.generator == CoordGenerator::mirror_plane || is_of_mirror(scene, use.texture);
  };
  const auto by_effect = [&](int effect) {
    return has_field_of_mirror(scene, scene.effects[static_cast<std::size_t>(effect)]);
  };
  return std::ranges::any_of(shape.textures, by_texture) || std::ranges::any_of(shape.effects, by_effect) ||
         (shape.shader >= 0 && has_field_of_mirror(scene, scene.shaders[static_cast<std::size_t>(shape.shader)]));
}

std::unique_ptr<PackedWindow> pack_mirror(const Mesh& mesh, MirrorWindows& windows) {
  const auto [known, added] = windows.try_emplace(&mesh);
  if (added) known->second = mirror_window(mesh);
  const std::optional<MirrorWindow>& window = known->second;
  const auto pack = [](const glm::dvec3& vector) { return PackedVec3(vector.x, vector.y, vector.z); };
  return window ? std::make_unique<PackedWindow>(pack(window->corner), pack(window->right), pack(window->up)) : nullptr;
}

}  // namespace

std::uint32_t coordinate_units(const ValidRecipe& program) {
  std::uint32_t units = 0;
  for (const TargetProgram& target : program.targets) {
    for (const ReflectedVariable& attribute : target.program.attributes()) {
      if (!attribute.name.starts_with("castle_MultiTexCoord")) continue;
      const int unit = find_castle_name(attribute.name).value_or(CastleName{}).number;
      units = std::max(units, static_cast<std::uint32_t>(unit + 1));
    }
  }
  return units;
}

void pack_map_programs(const SceneParts& parts, std::size_t map, const Packed& where, PackedShadowMapT& packed) {
  const MapPlan plan = map < parts.maps.size() ? parts.maps[map] : MapPlan();
  if (plan.moments_program < 0) return;
  const SceneShape none;
  const BindingContext context{parts.scene, none, where.textures, where.fog_planes, static_cast<int>(map)};
  const auto pack = [&](int program, std::int32_t& index, std::vector<PackedBinding>& bindings) {
    index = static_cast<std::int32_t>(where.programs[static_cast<std::size_t>(program)]);
    bindings = pack_bindings(parts.programs[static_cast<std::size_t>(program)], context);
  };
  pack(plan.moments_program, packed.moments_program, packed.moments_bindings);
  pack(plan.blur_program, packed.blur_program, packed.blur_bindings);
}

std::unique_ptr<PackedShapeT> pack_shape(const SceneParts& parts, std::size_t index, std::uint32_t mesh, const Packed& where) {
  const SceneShape& shape = parts.scene.shapes[index];
  const ShapePlan& plan = parts.shapes[index];
  auto packed = std::make_unique<PackedShapeT>();
  packed->name = shape.name;
  packed->transform = shape.transform;
  packed->mesh = mesh;
  pack_variants(parts, index, where, *packed);
  packed->cull_back = plan.mesh->solid;
  packed->front_cw = !plan.mesh->ccw;
  packed->own_scene_of = shape.own_scene_of;
  packed->background = shape.background;
  packed->wireframe = shape.shading == Shading::wireframe;
  packed->blended = plan.blended;
  packed->blend_source = static_cast<PackedBlendFactor>(shape.blend.source);
  packed->blend_destination = static_cast<PackedBlendFactor>(shape.blend.destination);
  packed->bounds_known = all_bounds_known(parts, plan);
  if (!packed->bounds_known && shape.bounds) {
    packed->bounds_known = true;  // an author's word is believed
    packed->bounds_min = std::make_unique<PackedVec3>(shape.bounds->min.x, shape.bounds->min.y, shape.bounds->min.z);
    packed->bounds_max = std::make_unique<PackedVec3>(shape.bounds->max.x, shape.bounds->max.y, shape.bounds->max.z);
  }
  const Recipe& recipe = parts.programs[static_cast<std::size_t>(plan.variants.front().program)].used;
  pack_style(shape, recipe.point_size, *packed);
  if (is_mirror(parts.scene, shape)) packed->mirror = pack_mirror(*plan.mesh, where.mirrors);
  packed->layer = shape.part == ScenePart::world ? PackedLayer::world : PackedLayer::backdrop;
  packed->projected_coords =
      pack_projected_coords({parts.scene, shape, where.textures, where.fog_planes}, units_read(parts, plan));
  for (const ReceivedShadow& shadow : shape.receives) packed->receives.push_back(static_cast<std::uint32_t>(shadow.shadow_map));
  return packed;
}

}  // namespace plugc
