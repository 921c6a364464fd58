// Follows every index of a package that has passed FlatBuffers' verifier, list by list, and stops at the first that leads
// nowhere. The verifier guarantees that every offset is good and every required list there, but knows nothing of what the
// numbers mean.
// A Place is a chain of (word, index) on the stack, turned into text only when something is wrong: a large scene is checked
// without making a string.
// No honest package shares a list between two owners, so all lists together fit into the buffer. visit() counts them, so
// that a small buffer whose lists overlap cannot keep us busy for ever.

#include <fmt/format.h>

#include <set>

#include "base/limits.h"
#include "package/package_file.h"

namespace plugc {
namespace {

constexpr std::uint32_t kSpirvMagic = 0x07230203;

/// Where we are: `scene 0, shape 3, binding 1`.
struct Place {
  const Place* outer = nullptr;
  const char* word = "";
  std::size_t index = 0;
};

std::string to_text(const Place& place) {
  const std::string here = fmt::format("{} {}", place.word, place.index);
  return place.outer == nullptr ? here : to_text(*place.outer) + ", " + here;
}

template <typename Enum>
bool is_enumerator(Enum value) {
  return value <= Enum::MAX;
}

/// An index into a list of `size`, or -1 for none.
bool is_index_or_none(std::int32_t index, std::size_t size) {
  return index == -1 || (index >= 0 && static_cast<std::size_t>(index) < size);
}

/// The first error, and how many bytes of lists may still be visited.
struct PackageCheck {
  const Package& package;
  std::size_t bytes_left;
  std::string error;

  /// Notes that `what` is wrong at `place`; returns false, so that a check reads `ok || check.fail(...)`.
  bool fail(const Place& place, std::string_view what) {
    error = fmt::format("{}: {}", to_text(place), what);
    return false;
  }

  bool require_index(const Place& place, const char* what, std::size_t index, std::size_t size) {
    return index < size || fail(place, fmt::format("{} {} does not exist, there are {}", what, index, size));
  }

  /// Calls `function(element, place)` for every element until one returns false.
  template <typename T, typename Function>
  bool each(const Place* outer, const char* word, const flatbuffers::Vector<T>& list, Function function) {
    const std::size_t bytes = list.size() * flatbuffers::IndirectHelper<T>::element_stride;
    if (bytes > bytes_left) return fail({outer, word, 0}, "its list overlaps others");
    bytes_left -= bytes;
    for (flatbuffers::uoffset_t i = 0; i < list.size(); ++i) {
      if (!function(list.Get(i), Place{outer, word, i})) return false;
    }
    return true;
  }
};

// ---- programs ----

bool check_origin(PackageCheck& check, const PackedLineOrigin& origin, const Place& place) {
  return origin.line() == 0 || check.require_index(place, "source", origin.source(), check.package.sources()->size());
}

bool check_stage(PackageCheck& check, const PackedStage& stage, PackedTarget target, const Place& place) {
  if (!is_enumerator(stage.kind())) return check.fail(place, "its kind is unknown");
  if (stage.text()->size() == 0 || stage.text()->size() > kMaxStageBytes)
    return check.fail(place, "its text is empty or too long");
  const bool has_spirv = stage.spirv()->size() != 0 && stage.spirv()->Get(0) == kSpirvMagic;
  if (target == PackedTarget::spirv && !has_spirv) return check.fail(place, "its SPIR-V does not start with the magic number");
  return check.each(&place, "origin", *stage.origins(),
                    [&](const PackedLineOrigin* origin, const Place& at) { return check_origin(check, *origin, at); });
}

bool check_target_program(PackageCheck& check, const PackedTargetProgram& program, const Place& place) {
  if (!is_enumerator(program.target())) return check.fail(place, "its target is unknown");
  int last_kind = -1;
  const auto check_in_order = [&](const PackedStage* stage, const Place& at) {
    const int kind = static_cast<int>(stage->kind());
    if (kind <= last_kind) return check.fail(at, "stages are out of pipeline order");
    last_kind = kind;
    return check_stage(check, *stage, program.target(), at);
  };
  if (!check.each(&place, "stage", *program.stages(), check_in_order)) return false;
  const bool has_vertex = program.stages()->size() != 0 && program.stages()->Get(0)->kind() == PackedStageKind::vertex;
  return has_vertex || check.fail(place, "it has no vertex stage");
}

bool check_uniform(PackageCheck& check, const PackedUniform& uniform, const Place& place) {
  if (uniform.name()->size() == 0) return check.fail(place, "it has no name");
  if (!is_enumerator(uniform.type())) return check.fail(place, "its type is unknown");
  return uniform.count() != 0 || check.fail(place, "its array has no elements");
}

bool check_attribute(PackageCheck& check, const PackedAttribute& attribute, const Place& place) {
  if (attribute.name()->size() == 0) return check.fail(place, "it has no name");
  return is_enumerator(attribute.semantic()) || check.fail(place, "its semantic is unknown");
}

bool check_program(PackageCheck& check, const PackedProgram& program, const Place& place) {
  std::set<PackedTarget> seen;
  const auto check_target = [&](const PackedTargetProgram* target, const Place& at) {
    if (!seen.insert(target->target()).second) return check.fail(at, "its target is there twice");
    return check_target_program(check, *target, at);
  };
  if (program.targets()->size() == 0) return check.fail(place, "it has no target");
  return check.each(&place, "target", *program.targets(), check_target) &&
         check.each(&place, "uniform", *program.uniforms(),
                    [&](const PackedUniform* uniform, const Place& at) { return check_uniform(check, *uniform, at); }) &&
         check.each(&place, "attribute", *program.attributes(),
                    [&](const PackedAttribute* attribute, const Place& at) { return check_attribute(check, *attribute, at); });
}

// ---- geometry and pixels ----

bool is_aligned(const void* data, std::size_t alignment) {
  return reinterpret_cast<std::uintptr_t>(data) % alignment == 0;
}

std::uint32_t corners(PackedTopology topology) {
  switch (topology) {
    case PackedTopology::triangles: return 3;
    case PackedTopology::lines: return 2;
    case PackedTopology::points: return 1;
  }
  return 1;
}

bool check_stream(PackageCheck& check, const PackedStream& stream, std::uint32_t stride, const Place& place) {
  if (!is_enumerator(stream.semantic())) return check.fail(place, "its semantic is unknown");
  if (stream.components() < 1 || stream.components() > 4) return check.fail(place, "it has not 1 to 4 components");
  const std::uint64_t end = std::uint64_t{stream.offset()} + stream.components() * sizeof(float);
  const bool fits = stream.offset() % sizeof(float) == 0 && end <= stride;
  return fits || check.fail(place, fmt::format("bytes {} to {} do not fit into a vertex of {}", stream.offset(), end, stride));
}

bool check_vertices(PackageCheck& check, const PackedMesh& mesh, const Place& place) {
  if (mesh.stride() % sizeof(float) != 0) return check.fail(place, "its stride is no multiple of 4");
  const std::uint64_t bytes = std::uint64_t{mesh.vertex_count()} * mesh.stride();
  if (mesh.vertices()->size() != bytes) {
    return check.fail(place, fmt::format("its vertices take {} bytes, not {}", mesh.vertices()->size(), bytes));
  }
  if (mesh.vertex_count() != 0 && mesh.stride() == 0) return check.fail(place, "its vertices have no bytes");
  return mesh.vertices()->size() == 0 || is_aligned(mesh.vertices()->data(), 16) ||
         check.fail(place, "its vertices are not aligned");
}

bool check_mesh(PackageCheck& check, const PackedMesh& mesh, const Place& place) {
  if (!is_enumerator(mesh.topology())) return check.fail(place, "its topology is unknown");
  if (mesh.bounds_min() == nullptr || mesh.bounds_max() == nullptr) return check.fail(place, "it has no bounds");
  if (!check_vertices(check, mesh, place)) return false;
  if (mesh.indices()->size() % corners(mesh.topology()) != 0) return check.fail(place, "its last primitive is cut short");
  return check.each(&place, "stream", *mesh.streams(), [&](const PackedStream* stream, const Place& at) {
    return check_stream(check, *stream, mesh.stride(), at);
  }) && check.each(&place, "index", *mesh.indices(), [&](std::uint32_t index, const Place& at) {
    return check.require_index(at, "vertex", index, mesh.vertex_count());
  });
}

bool check_image(PackageCheck& check, const PackedImage& image, const Place& place) {
  const auto is_side = [](std::uint32_t side) { return side >= 1 && side <= kMaxImageSide; };
  if (!is_side(image.width()) || !is_side(image.height()) || !is_side(image.depth())) {
    return check.fail(place,
                      fmt::format("its size {} x {} x {} is out of range", image.width(), image.height(), image.depth()));
  }
  if (image.channels() < 1 || image.channels() > 4) return check.fail(place, "it has not 1 to 4 channels");
  const std::uint64_t bytes = std::uint64_t{image.width()} * image.height() * image.depth() * image.channels();
  if (image.pixels()->size() != bytes) {
    return check.fail(place, fmt::format("its pixels take {} bytes, not {}", image.pixels()->size(), bytes));
  }
  return is_aligned(image.pixels()->data(), 16) || check.fail(place, "its pixels are not aligned");
}

bool check_texture(PackageCheck& check, const PackedTexture& texture, const Place& place) {
  if (!is_enumerator(texture.wrap_s()) || !is_enumerator(texture.wrap_t()) || !is_enumerator(texture.wrap_r()))
    return check.fail(place, "its wrap mode is unknown");
  // Only minification may use mipmaps.
  const bool good_filters = is_enumerator(texture.minification()) && texture.magnification() <= PackedFilter::linear;
  if (!good_filters) return check.fail(place, "its filter is unknown");
  return check.require_index(place, "image", texture.image(), check.package.images()->size());
}

// ---- scenes ----

/// A scene's lists, at hand for all that points into them.
struct SceneCheck {
  PackageCheck& check;
  const PackedScene& scene;

  /// `field` may name a slot with at least `numbers` numbers, or none.
  bool slot(const Place& place, const char* field, std::uint32_t index, std::uint32_t numbers) {
    return index == kNoSlot || present_slot(place, field, index, numbers);
  }

  bool present_slot(const Place& place, const char* field, std::uint32_t index, std::uint32_t numbers) {
    if (index >= scene.slots()->size())
      return check.fail(place, fmt::format("{} is slot {}, which does not exist", field, index));
    const PackedSlot& slot = *scene.slots()->Get(index);
    const std::uint64_t held = std::uint64_t{slot.count()} * component_count(slot.type());
    return held >= numbers ||
           check.fail(place, fmt::format("{} is slot {}, which has {} numbers, not {}", field, index, held, numbers));
  }

  bool transform(const Place& place, std::int32_t index) {
    return is_index_or_none(index, scene.transforms()->size()) ||
           check.fail(place, fmt::format("transform {} does not exist", index));
  }
};

bool check_slot(SceneCheck& scene, const PackedSlot& slot, const Place& place) {
  if (!is_enumerator(slot.type())) return scene.check.fail(place, "its type is unknown");
  const std::uint64_t end = slot.first() + std::uint64_t{slot.count()} * component_count(slot.type());
  const std::size_t available = scene.scene.slot_values()->size();
  return end <= available || scene.check.fail(place, fmt::format("it ends at value {} of {}", end, available));
}

bool check_slots(SceneCheck& scene, const Place& place) {
  PackageCheck& check = scene.check;
  const auto& values = *scene.scene.slot_values();
  if (values.size() != 0 && !is_aligned(values.data(), alignof(double)))
    return check.fail(place, "its slot values are not aligned");
  return check.each(&place, "slot", *scene.scene.slots(), [&](const PackedSlot* slot, const Place& at) {
    return check_slot(scene, *slot, at);
  }) && check.each(&place, "slot name", *scene.scene.slot_names(), [&](const PackedSlotName* name, const Place& at) {
    return scene.present_slot(at, "it", name->slot(), 0);
  });
}

bool check_transform(SceneCheck& scene, const PackedTransform& transform, const Place& place) {
  if (!is_index_or_none(transform.parent(), place.index)) {
    return scene.check.fail(place, fmt::format("its parent {} does not come before it", transform.parent()));
  }
  return scene.slot(place, "translation", transform.translation(), 3) &&
         scene.slot(place, "rotation", transform.rotation(), 4) && scene.slot(place, "scale", transform.scale(), 3) &&
         scene.slot(place, "scale orientation", transform.scale_orientation(), 4) &&
         scene.slot(place, "center", transform.center(), 3) && scene.slot(place, "switch", transform.switch_slot(), 1);
}

bool check_light(SceneCheck& scene, const PackedLight& light, const Place& place) {
  if (!is_enumerator(light.kind())) return scene.check.fail(place, "its kind is unknown");
  return scene.transform(place, light.transform()) && scene.slot(place, "on", light.on(), 1) &&
         scene.slot(place, "color", light.color(), 3) && scene.slot(place, "intensity", light.intensity(), 1) &&
         scene.slot(place, "ambient intensity", light.ambient_intensity(), 1) &&
         scene.slot(place, "location", light.location(), 3) && scene.slot(place, "direction", light.direction(), 3) &&
         scene.slot(place, "attenuation", light.attenuation(), 3) && scene.slot(place, "radius", light.radius(), 1) &&
         scene.slot(place, "cut off angle", light.cut_off_angle(), 1) && scene.slot(place, "beam width", light.beam_width(), 1);
}

bool check_shadow_map(SceneCheck& scene, const PackedShadowMap& map, const Place& place) {
  PackageCheck& check = scene.check;
  if (map.size() < 1 || map.size() > kMaxShadowMapSide)
    return check.fail(place, fmt::format("its size {} is out of range", map.size()));
  if (!is_enumerator(map.update())) return check.fail(place, "its update mode is unknown");
  return check.require_index(place, "light", map.light(), scene.scene.lights()->size()) &&
         scene.slot(place, "scale", map.scale(), 1) && scene.slot(place, "bias", map.bias(), 1) &&
         scene.slot(place, "near", map.near(), 1) && scene.slot(place, "far", map.far(), 1) &&
         scene.slot(place, "up", map.up(), 3) && scene.slot(place, "angle", map.angle(), 1) &&
         scene.slot(place, "rectangle", map.rectangle(), 4) && scene.slot(place, "location", map.location(), 3);
}

bool check_texture_transform(SceneCheck& scene, const PackedTextureTransform& transform, const Place& place) {
  return scene.slot(place, "translation", transform.translation(), 2) &&
         scene.slot(place, "rotation", transform.rotation(), 1) && scene.slot(place, "scale", transform.scale(), 2) &&
         scene.slot(place, "center", transform.center(), 2);
}

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
    case PackedSource::texture_matrix:
      return check.require_index(place, "texture transform", binding.a(), scene.scene.texture_transforms()->size());
    case PackedSource::viewpoint_projector_matrix:
      return check.require_index(place, "projector", binding.a(), scene.scene.projectors()->size());
    case PackedSource::shadow_map:
      return check.require_index(place, "shadow map", binding.a(), scene.scene.shadow_maps()->size()) &&
             check.require_index(place, "element", binding.b(), uniform.count());
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
    case PackedSource::model_view_matrix:
    case PackedSource::projection_matrix:
    case PackedSource::model_view_projection_matrix:
    case PackedSource::normal_matrix:
    case PackedSource::camera_matrix:
    case PackedSource::camera_inverse_matrix:
    case PackedSource::camera_rotation_matrix:
    case PackedSource::camera_rotation_inverse_matrix: return true;
  }
  return check.fail(place, "its source is unknown");
}

bool check_binding(SceneCheck& scene, const PackedBinding& binding, const PackedProgram& program, const Place& place) {
  if (!scene.check.require_index(place, "uniform", binding.uniform(), program.uniforms()->size())) return false;
  const PackedUniform& uniform = *program.uniforms()->Get(binding.uniform());
  const bool feeds_sampler = binding.source() == PackedSource::texture || binding.source() == PackedSource::shadow_map;
  if (feeds_sampler != (component_count(uniform.type()) == 0)) {
    return scene.check.fail(place, fmt::format("its source does not fit the uniform `{}`", uniform.name()->string_view()));
  }
  return check_operands(scene, binding, uniform, place);
}

bool check_bindings(SceneCheck& scene, const char* word, const flatbuffers::Vector<const PackedBinding*>& bindings,
                    std::int32_t program, const Place& place) {
  const auto& programs = *scene.check.package.programs();
  return scene.check.each(&place, word, bindings, [&](const PackedBinding* binding, const Place& at) {
    if (program < 0) return scene.check.fail(at, "the shape has no depth program");
    return check_binding(scene, *binding, *programs.Get(static_cast<std::uint32_t>(program)), at);
  });
}

bool check_programs(SceneCheck& scene, const ShapePrograms& use, const Place& place) {
  PackageCheck& check = scene.check;
  const std::size_t count = check.package.programs()->size();
  if (!check.require_index(place, "program", use.program, count) ||
      !check_bindings(scene, "binding", *use.bindings, static_cast<std::int32_t>(use.program), place)) {
    return false;
  }
  if (!is_index_or_none(use.depth_program, count))
    return check.fail(place, fmt::format("depth program {} does not exist", use.depth_program));
  return check_bindings(scene, "depth binding", *use.depth_bindings, use.depth_program, place);
}

bool check_switch(SceneCheck& scene, const PackedSwitch& one, const Place& place) {
  if (!is_enumerator(one.kind())) return scene.check.fail(place, "its kind is unknown");
  return one.kind() == PackedSwitchKind::slot
             ? scene.present_slot(place, "it", one.index(), 1)
             : scene.check.require_index(place, "light", one.index(), scene.scene.lights()->size());
}

/// Every combination of the switches must lead to programs.
bool check_states(SceneCheck& scene, const PackedShape& shape, const Place& place) {
  constexpr std::uint32_t kMaxSwitches = 8;
  PackageCheck& check = scene.check;
  const std::uint32_t switches = shape.switches()->size();
  if (switches > kMaxSwitches) return check.fail(place, fmt::format("it has {} switches", switches));
  const std::uint32_t needed = switches == 0 ? 0 : 1U << switches;
  if (shape.states()->size() != needed)
    return check.fail(place, fmt::format("it has {} states, not {}", shape.states()->size(), needed));
  const std::uint32_t variants = shape.variants()->size();
  return check.each(&place, "switch", *shape.switches(), [&](const PackedSwitch* one, const Place& at) {
    return check_switch(scene, *one, at);
  }) && check.each(&place, "variant", *shape.variants(), [&](const PackedVariant*, const Place& at) {
    return check_programs(scene, shape_programs(shape, static_cast<std::uint8_t>(at.index + 1)), at);
  }) && check.each(&place, "state", *shape.states(), [&](std::uint8_t variant, const Place& at) {
    return variant <= variants || check.fail(at, fmt::format("variant {} does not exist, there are {}", variant, variants));
  });
}

bool check_shape(SceneCheck& scene, const PackedShape& shape, const Place& place) {
  PackageCheck& check = scene.check;
  if (!is_enumerator(shape.blend_source()) || !is_enumerator(shape.blend_destination())) {
    return check.fail(place, "its blend factor is unknown");
  }
  return scene.transform(place, shape.transform()) &&
         check.require_index(place, "mesh", shape.mesh(), check.package.meshes()->size()) &&
         check_programs(scene, shape_programs(shape, 0), place) && check_states(scene, shape, place) &&
         check.each(&place, "receives", *shape.receives(), [&](std::uint32_t map, const Place& at) {
           return check.require_index(at, "shadow map", map, scene.scene.shadow_maps()->size());
         });
}

bool check_viewpoint(SceneCheck& scene, const PackedViewpoint& viewpoint, const Place& place) {
  return scene.transform(place, viewpoint.transform()) && scene.slot(place, "position", viewpoint.position(), 3) &&
         scene.slot(place, "orientation", viewpoint.orientation(), 4) &&
         scene.slot(place, "field of view", viewpoint.field_of_view(), viewpoint.orthographic() ? 4 : 1);
}

bool check_scene(PackageCheck& check, const PackedScene& packed, const Place& place) {
  SceneCheck scene{check, packed};
  // Slots first: whatever names one asks how many numbers it has.
  return check_slots(scene, place) &&
         check.each(
             &place, "transform", *packed.transforms(),
             [&](const PackedTransform* transform, const Place& at) { return check_transform(scene, *transform, at); }) &&
         check.each(&place, "light", *packed.lights(),
                    [&](const PackedLight* light, const Place& at) { return check_light(scene, *light, at); }) &&
         check.each(&place, "shadow map", *packed.shadow_maps(),
                    [&](const PackedShadowMap* map, const Place& at) { return check_shadow_map(scene, *map, at); }) &&
         check.each(&place, "texture transform", *packed.texture_transforms(),
                    [&](const PackedTextureTransform* transform, const Place& at) {
                      return check_texture_transform(scene, *transform, at);
                    }) &&
         check.each(&place, "shape", *packed.shapes(),
                    [&](const PackedShape* shape, const Place& at) { return check_shape(scene, *shape, at); }) &&
         check.each(
             &place, "viewpoint", *packed.viewpoints(),
             [&](const PackedViewpoint* viewpoint, const Place& at) { return check_viewpoint(scene, *viewpoint, at); }) &&
         check.each(
             &place, "projector", *packed.projectors(),
             [&](const PackedViewpoint* viewpoint, const Place& at) { return check_viewpoint(scene, *viewpoint, at); }) &&
         scene.slot(place, "background color", packed.background_color(), 3);
}

}  // namespace

std::uint32_t component_count(PackedValueType type) {
  switch (type) {
    case PackedValueType::bool_:
    case PackedValueType::int_:
    case PackedValueType::float_: return 1;
    case PackedValueType::vec2: return 2;
    case PackedValueType::vec3: return 3;
    case PackedValueType::vec4:
    case PackedValueType::rotation: return 4;
    case PackedValueType::mat3: return 9;
    case PackedValueType::mat4: return 16;
  }
  return 0;
}

std::uint32_t component_count(PackedUniformType type) {
  switch (type) {
    case PackedUniformType::bool_:
    case PackedUniformType::int_:
    case PackedUniformType::float_: return 1;
    case PackedUniformType::vec2:
    case PackedUniformType::ivec2: return 2;
    case PackedUniformType::vec3:
    case PackedUniformType::ivec3: return 3;
    case PackedUniformType::vec4:
    case PackedUniformType::ivec4: return 4;
    case PackedUniformType::mat3: return 9;
    case PackedUniformType::mat4: return 16;
    case PackedUniformType::sampler2D:
    case PackedUniformType::sampler3D:
    case PackedUniformType::samplerCube:
    case PackedUniformType::sampler2DShadow:
    case PackedUniformType::samplerCubeShadow: return 0;
  }
  return 0;
}

std::string check_package(const Package& package, std::size_t buffer_size) {
  PackageCheck check{package, buffer_size, {}};
  check.each(nullptr, "program", *package.programs(),
             [&](const PackedProgram* program, const Place& at) { return check_program(check, *program, at); }) &&
      check.each(nullptr, "mesh", *package.meshes(),
                 [&](const PackedMesh* mesh, const Place& at) { return check_mesh(check, *mesh, at); }) &&
      check.each(nullptr, "image", *package.images(),
                 [&](const PackedImage* image, const Place& at) { return check_image(check, *image, at); }) &&
      check.each(nullptr, "texture", *package.textures(),
                 [&](const PackedTexture* texture, const Place& at) { return check_texture(check, *texture, at); }) &&
      check.each(nullptr, "scene", *package.scenes(),
                 [&](const PackedScene* scene, const Place& at) { return check_scene(check, *scene, at); });
  return check.error;
}

}  // namespace plugc
