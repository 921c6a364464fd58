// Shapes: what feeds the uniforms of their programs, and the programs of their states.

#include "base/limits.h"
#include "package/package_file_check.h"

namespace plugc {
namespace {

/// Whether what a binding reads exists.
bool check_operands(SceneCheck& scene, const PackedBinding& binding, const PackedUniform& uniform, const Place& place) {
  PackageCheck& check = scene.check;
  switch (binding.source()) {
    case PackedSource::slot:
    case PackedSource::slot_scaled: return scene.present_slot(place, "a", binding.a(), component_count(uniform.type()));
    case PackedSource::slot_product:
      return scene.present_slot(place, "a", binding.a(), component_count(uniform.type())) &&
             scene.slot(place, "b", binding.b(), 1);
    case PackedSource::color_and_transparency:
    case PackedSource::color_and_alpha: return scene.slot(place, "a", binding.a(), 3) && scene.slot(place, "b", binding.b(), 1);
    case PackedSource::shadow_intensity: return scene.slot(place, "a", binding.a(), 1);
    case PackedSource::texture:
      return check.require_index(place, "texture", binding.a(), check.package.textures()->size()) &&
             check.require_index(place, "element", binding.b(), uniform.count());
    case PackedSource::fog_visibility_range:
      return scene.present_slot(place, "a", binding.a(), 1) &&
             check.require_index(place, "transform", binding.b(), scene.scene.transforms()->size() + 1);
    case PackedSource::rendered_texture: {
      const auto* textures = scene.scene.rendered_textures();
      return check.require_index(place, "rendered texture", binding.a(), textures == nullptr ? 0 : textures->size()) &&
             check.require_index(place, "element", binding.b(), uniform.count());
    }
    case PackedSource::texture_matrix:
      return check.require_index(place, "texture transform", binding.a(), scene.scene.texture_transforms()->size());
    case PackedSource::viewpoint_projector_matrix:
      return check.require_index(place, "projector", binding.a(), scene.scene.projectors()->size()) &&
             check.require_index(place, "viewpoint", binding.b(), scene.scene.viewpoints()->size() + 1);
    case PackedSource::shadow_map:
    case PackedSource::shadow_moments:
    case PackedSource::shadow_depths:
    case PackedSource::shadow_unblurred:
    case PackedSource::shadow_map_greater:
      return check.require_index(place, "shadow map", binding.a(), scene.scene.shadow_maps()->size()) &&
             check.require_index(place, "element", binding.b(), uniform.count());
    case PackedSource::shadow_depth_plane:
    case PackedSource::shadow_depth_line:
    case PackedSource::projector_matrix:
    case PackedSource::light_view_projection_matrix:
      return check.require_index(place, "shadow map", binding.a(), scene.scene.shadow_maps()->size());
    case PackedSource::light_position:
    case PackedSource::light_spot_direction:
    case PackedSource::light_spot_cos_cutoff:
    case PackedSource::light_spot_cutoff:
    case PackedSource::light_beam_width:
    case PackedSource::light_radius:
    case PackedSource::light_color:
    case PackedSource::light_ambient_color:
    case PackedSource::light_attenuation:
    case PackedSource::light_on: return check.require_index(place, "light", binding.a(), scene.scene.lights()->size());
    case PackedSource::clip_plane: {
      const std::size_t planes = scene.scene.clip_planes() == nullptr ? 0 : scene.scene.clip_planes()->size();
      return check.require_index(place, "clip plane", binding.a(), planes);
    }
    case PackedSource::fog_plane: {
      const std::size_t planes = scene.scene.fog_planes() == nullptr ? 0 : scene.scene.fog_planes()->size();
      return check.require_index(place, "fog plane", binding.a(), planes);
    }
    case PackedSource::model_view_matrix:
    case PackedSource::projection_matrix:
    case PackedSource::model_view_projection_matrix:
    case PackedSource::normal_matrix:
    case PackedSource::camera_matrix:
    case PackedSource::camera_inverse_matrix:
    case PackedSource::camera_rotation_matrix:
    case PackedSource::camera_rotation_inverse_matrix:
    case PackedSource::depth_pass_range:
    case PackedSource::screen_color:
    case PackedSource::screen_depth:
    case PackedSource::screen_width:
    case PackedSource::screen_height:
    case PackedSource::target_size:
    case PackedSource::mirror_projector_matrix: return true;
  }
  return check.fail(place, "its source is unknown");
}

bool feeds_sampler(PackedSource source) {
  return source == PackedSource::texture || source == PackedSource::shadow_map || source == PackedSource::shadow_map_greater ||
         source == PackedSource::shadow_moments || source == PackedSource::shadow_depths ||
         source == PackedSource::shadow_unblurred || source == PackedSource::rendered_texture ||
         source == PackedSource::screen_color || source == PackedSource::screen_depth;
}

/// Whether the source is there meanwhile: nobody may read what he draws into, or what nobody has drawn.
bool is_there(PackedSource source, Drawn drawn) {
  switch (source) {
    case PackedSource::screen_color:
    case PackedSource::screen_width:
    case PackedSource::screen_height: return drawn == Drawn::screen_effect || drawn == Drawn::screen_effect_with_depth;
    case PackedSource::screen_depth: return drawn == Drawn::screen_effect_with_depth;
    case PackedSource::shadow_depths: return drawn == Drawn::moments;
    case PackedSource::shadow_unblurred: return drawn == Drawn::blur;
    default: return true;
  }
}

bool check_binding(SceneCheck& scene, Drawn drawn, const PackedBinding& binding, const PackedProgram& program,
                   const Place& place) {
  if (!scene.check.require_index(place, "uniform", binding.uniform(), program.uniforms()->size())) return false;
  const PackedUniform& uniform = *program.uniforms()->Get(binding.uniform());
  if (feeds_sampler(binding.source()) != (component_count(uniform.type()) == 0)) {
    return scene.check.fail(place, fmt::format("its source does not fit the uniform `{}`", uniform.name()->string_view()));
  }
  if (!is_there(binding.source(), drawn)) return scene.check.fail(place, "its source is not there for what is drawn");
  return check_operands(scene, binding, uniform, place);
}

}  // namespace

bool check_bindings(SceneCheck& scene, Drawn drawn, const char* word, const flatbuffers::Vector<const PackedBinding*>& bindings,
                    std::int32_t program, const Place& place) {
  const auto& programs = *scene.check.package.programs();
  return scene.check.each(&place, word, bindings, [&](const PackedBinding* binding, const Place& at) {
    if (program < 0) return scene.check.fail(at, "there is no program that it could feed");
    return check_binding(scene, drawn, *binding, *programs.Get(static_cast<std::uint32_t>(program)), at);
  });
}

namespace {

/// Coordinates that are computed for a vertex shader, each in a buffer of its own.
bool check_projected_coord(SceneCheck& scene, const PackedShape& shape, const PackedBinding& coord, const Place& place) {
  PackageCheck& check = scene.check;
  if (!check.require_index(place, "unit", coord.uniform(), kMaxTexCoordSets)) return false;
  const auto before = static_cast<flatbuffers::uoffset_t>(place.index) - 1;
  if (place.index != 0 && shape.projected_coords()->Get(before)->uniform() >= coord.uniform())
    return check.fail(place, "it is out of order");
  if (coord.source() == PackedSource::projector_matrix)
    return check.require_index(place, "shadow map", coord.a(), scene.scene.shadow_maps()->size());
  if (coord.source() == PackedSource::mirror_projector_matrix) return true;
  if (coord.source() != PackedSource::viewpoint_projector_matrix) return check.fail(place, "nothing projects it");
  return check.require_index(place, "projector", coord.a(), scene.scene.projectors()->size()) &&
         check.require_index(place, "viewpoint", coord.b(), scene.scene.viewpoints()->size() + 1);
}

bool check_programs(SceneCheck& scene, const ShapePrograms& use, const Place& place) {
  PackageCheck& check = scene.check;
  const std::size_t count = check.package.programs()->size();
  if (!check.require_index(place, "program", use.program, count) ||
      !check_bindings(scene, Drawn::shape, "binding", *use.bindings, static_cast<std::int32_t>(use.program), place)) {
    return false;
  }
  if (!is_index_or_none(use.depth_program, count))
    return check.fail(place, fmt::format("depth program {} does not exist", use.depth_program));
  if (!is_index_or_none(use.point_depth_program, count))
    return check.fail(place, fmt::format("point depth program {} does not exist", use.point_depth_program));
  if (use.point_depth_program >= 0 && use.point_depth_bindings == nullptr)
    return check.fail(place, "its point depth program has no bindings");
  return check_bindings(scene, Drawn::shape, "depth binding", *use.depth_bindings, use.depth_program, place) &&
         (use.point_depth_bindings == nullptr || check_bindings(scene, Drawn::shape, "point depth binding",
                                                                *use.point_depth_bindings, use.point_depth_program, place));
}

bool check_switch(SceneCheck& scene, const PackedSwitch& one, const Place& place) {
  if (!is_enumerator(one.kind())) return scene.check.fail(place, "its kind is unknown");
  return one.kind() == PackedSwitchKind::slot
             ? scene.present_slot(place, "it", one.index(), 1)
             : scene.check.require_index(place, "light", one.index(), scene.scene.lights()->size());
}

/// Every combination of the switches must lead to programs.
bool check_states(SceneCheck& scene, const PackedShape& shape, const Place& place) {
  constexpr std::uint32_t kMaxSwitches = 8, kMaxVariants = 255;  // states are bytes
  PackageCheck& check = scene.check;
  const std::uint32_t switches = shape.switches()->size();
  if (switches > kMaxSwitches) return check.fail(place, fmt::format("it has {} switches", switches));
  const std::uint32_t needed = switches == 0 ? 0 : 1U << switches;
  if (shape.states()->size() != needed)
    return check.fail(place, fmt::format("it has {} states, not {}", shape.states()->size(), needed));
  const std::uint32_t variants = shape.variants()->size();
  if (variants > kMaxVariants) return check.fail(place, fmt::format("it has {} variants", variants));
  return check.each(&place, "switch", *shape.switches(), [&](const PackedSwitch* one, const Place& at) {
    return check_switch(scene, *one, at);
  }) && check.each(&place, "variant", *shape.variants(), [&](const PackedVariant*, const Place& at) {
    return check_programs(scene, shape_programs(shape, static_cast<std::uint8_t>(at.index + 1)), at);
  }) && check.each(&place, "state", *shape.states(), [&](std::uint8_t variant, const Place& at) {
    return variant <= variants || check.fail(at, fmt::format("variant {} does not exist, there are {}", variant, variants));
  });
}

}  // namespace

bool check_shape(SceneCheck& scene, const PackedShape& shape, const Place& place) {
  PackageCheck& check = scene.check;
  if (!is_enumerator(shape.blend_source()) || !is_enumerator(shape.blend_destination())) {
    return check.fail(place, "its blend factor is unknown");
  }
  if ((shape.bounds_min() == nullptr) != (shape.bounds_max() == nullptr))
    return check.fail(place, "its bounds have one corner alone");
  const auto* textures = scene.scene.rendered_textures();
  if (!is_index_or_none(shape.own_scene_of(), textures == nullptr ? 0 : textures->size()))
    return check.fail(place, fmt::format("rendered texture {} does not exist", shape.own_scene_of()));
  if (!is_enumerator(shape.layer())) return check.fail(place, "its layer is unknown");
  return check.charge(place, *shape.name()) && scene.transform(place, shape.transform()) &&
         scene.slot(place, "line width", shape.line_width(), 1) && scene.slot(place, "alpha cutoff", shape.alpha_cutoff(), 1) &&
         scene.slot(place, "blend color", shape.blend_color(), 3) &&
         scene.slot(place, "blend transparency", shape.blend_transparency(), 1) &&
         check.require_index(place, "mesh", shape.mesh(), check.package.meshes()->size()) &&
         check_programs(scene, shape_programs(shape, 0), place) && check_states(scene, shape, place) &&
         (shape.projected_coords() == nullptr || check.each(&place, "projected coordinates", *shape.projected_coords(),
                                                            [&](const PackedBinding* coord, const Place& at) {
                                                              return check_projected_coord(scene, shape, *coord, at);
                                                            })) &&
         check.each(&place, "receives", *shape.receives(), [&](std::uint32_t map, const Place& at) {
           return check.require_index(at, "shadow map", map, scene.scene.shadow_maps()->size());
         });
}

}  // namespace plugc
