// Text is added behind the fragment stage's main(), which becomes a function of another name: so the triangle is written by
// the very draw that makes the colour, discarded where that is, and no second pass has to match the first.
// The number of the shape comes from a uniform, and that from a slot, as every other number of a package does.

#include "runtime/measure/instrument.h"

#include <stdexcept>

namespace plugc {
namespace {

constexpr const char* kShapeUniform = "measured_shape";

std::uint32_t add_slot(PackedSceneT& scene, PackedValueType type, double value) {
  scene.slots.emplace_back(static_cast<std::uint32_t>(scene.slot_values.size()), 1, type);
  scene.slot_values.push_back(value);
  return static_cast<std::uint32_t>(scene.slots.size() - 1);
}

/// As slots hold it, or `fallback` where the field has no slot.
double value_of(const PackedSceneT& scene, std::uint32_t slot, double fallback) {
  return slot == kNoSlot ? fallback : scene.slot_values[scene.slots[slot].first()];
}

const Package& opened(const std::vector<std::uint8_t>& bytes) {
  const PackageView view = open_package(bytes);
  if (view.package == nullptr) throw std::runtime_error(view.error);
  return *view.package;
}

std::unique_ptr<PackageT> unpack(const std::vector<std::uint8_t>& bytes) {
  return std::unique_ptr<PackageT>(opened(bytes).UnPack());
}

std::uint32_t add_slot(PackedSceneT& scene, const glm::dvec3& value) {
  scene.slots.emplace_back(static_cast<std::uint32_t>(scene.slot_values.size()), 1, PackedValueType::vec3);
  scene.slot_values.insert(scene.slot_values.end(), {value.x, value.y, value.z});
  return static_cast<std::uint32_t>(scene.slots.size() - 1);
}

/// Of those, a fog's visibility counts transforms (from 1, as 0 is the world).
void make_room(std::vector<PackedBinding>& bindings) {
  for (PackedBinding& b : bindings) {
    if (b.source() == PackedSource::fog_visibility_range)
      b = PackedBinding(b.uniform(), b.a(), b.b() + 1, b.scale(), b.source());
  }
}

void make_room_in_bindings(PackedSceneT& scene) {
  for (auto& shape : scene.shapes) {
    make_room(shape->bindings);
    for (auto& variant : shape->variants) make_room(variant->bindings);
  }
  for (auto& effect : scene.screen_effects) make_room(effect->bindings);
}

/// Whatever hangs on a transform, or on the world, hangs on the next one.
void make_room_for_a_root(PackedSceneT& scene) {
  for (PackedTransform& t : scene.transforms) {
    t = PackedTransform(t.parent() + 1, t.translation(), t.rotation(), t.scale(), t.scale_orientation(), t.center(),
                        t.switch_slot(), t.choice());
  }
  const auto hang_on_next = [](auto& list) {
    for (auto& each : list) each->transform += 1;
  };
  for (auto& light : scene.lights) light->transform += light->headlight ? 0 : 1;
  hang_on_next(scene.shapes);
  hang_on_next(scene.viewpoints);
  hang_on_next(scene.projectors);
  hang_on_next(scene.screen_effects);
  for (PackedBillboard& b : scene.billboards) b = PackedBillboard(b.transform() + 1, b.axis());
  for (PackedLodLevel& level : scene.lod_levels)
    level = PackedLodLevel(level.transform() + 1, level.center(), level.from(), level.to());
  for (PackedClipPlane& plane : scene.clip_planes)
    plane = PackedClipPlane(plane.transform() + 1, plane.plane(), plane.enabled());
  for (PackedFogPlane& plane : scene.fog_planes)
    plane = PackedFogPlane(plane.transform() + 1, plane.direction(), plane.start());
  for (auto& node : scene.event_nodes) node->subject += node->kind == PackedEventKind::proximity_sensor ? 1 : 0;
  make_room_in_bindings(scene);
}

/// A new first transform, under which all roots hang.
void put_under_transform(PackedSceneT& scene, double scale, const glm::dvec3& offset) {
  make_room_for_a_root(scene);
  const PackedTransform root(-1, add_slot(scene, offset), kNoSlot, add_slot(scene, glm::dvec3(scale)), kNoSlot, kNoSlot,
                             kNoSlot, 0);
  scene.transforms.insert(scene.transforms.begin(), root);
}

void apply(PackedSceneT& scene, const Settings& settings) {
  for (auto& map : scene.shadow_maps) {
    if (settings.size) map->size = *settings.size;
    if (settings.scale) map->scale = add_slot(scene, PackedValueType::float_, *settings.scale);
    if (settings.bias) map->bias = add_slot(scene, PackedValueType::float_, *settings.bias);
    if (settings.projection_near) map->near = add_slot(scene, PackedValueType::float_, *settings.projection_near);
    if (settings.light_direction) scene.lights[map->light]->direction = add_slot(scene, *settings.light_direction);
  }
  if (settings.scene_scale || settings.scene_offset) {
    put_under_transform(scene, settings.scene_scale.value_or(1), settings.scene_offset.value_or(glm::dvec3(0)));
  }
}

void write_triangle(PackedStageT& stage) {
  const std::string main = "void main()";
  const std::size_t at = stage.text.rfind(main);
  if (stage.kind != PackedStageKind::fragment || at == std::string::npos) return;
  stage.text.replace(at, main.size(), "void measured_main()");
  stage.text += "\nuniform float " + std::string(kShapeUniform) +
                ";\nlayout(location = 1) out vec4 measured_triangle;\nvoid main()\n{\n  measured_main();\n"
                "  measured_triangle = vec4(" +
                kShapeUniform + ", float(gl_PrimitiveID), 0.0, " + std::to_string(kSeen) + ");\n}\n";
}

/// The number of the new uniform.
std::uint32_t write_triangle(PackedProgramT& program) {
  for (auto& target : program.targets) {
    for (auto& stage : target->stages) write_triangle(*stage);
  }
  auto uniform = std::make_unique<PackedUniformT>();
  uniform->name = kShapeUniform;
  uniform->type = PackedUniformType::float_;
  program.uniforms.push_back(std::move(uniform));
  return static_cast<std::uint32_t>(program.uniforms.size() - 1);
}

void number_shapes(PackageT& package) {
  PackedSceneT& scene = *package.scenes[0];
  std::vector<std::optional<std::uint32_t>> uniforms(package.programs.size());
  const auto number = [&](std::uint32_t program, std::vector<PackedBinding>& bindings, std::uint32_t slot) {
    if (!uniforms[program]) uniforms[program] = write_triangle(*package.programs[program]);
    bindings.emplace_back(*uniforms[program], slot, 0, 1.0F, PackedSource::slot);
  };
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    PackedShapeT& shape = *scene.shapes[i];
    const std::uint32_t slot = add_slot(scene, PackedValueType::float_, static_cast<double>(i));
    number(shape.program, shape.bindings, slot);
    for (auto& variant : shape.variants) number(variant->program, variant->bindings, slot);
  }
}

std::vector<std::uint32_t> separate_scales(PackedSceneT& scene) {
  std::vector<std::uint32_t> slots;
  for (auto& map : scene.shadow_maps)
    slots.push_back(map->scale = add_slot(scene, PackedValueType::float_, value_of(scene, map->scale, 0)));
  return slots;
}

std::vector<LightSlots> separate_lights(PackedSceneT& scene) {
  std::vector<LightSlots> lights;
  for (auto& light : scene.lights) {
    light->on = add_slot(scene, PackedValueType::bool_, value_of(scene, light->on, 1));
    light->intensity = add_slot(scene, PackedValueType::float_, value_of(scene, light->intensity, 1));
    light->ambient_intensity = add_slot(scene, PackedValueType::float_, 0);  // its shadow scales both terms alike
    lights.push_back({light->on, light->intensity});
  }
  return lights;
}

/// Where a shadow falls does not depend on how dark it is; only a whole one is told from light everywhere.
void darken_shadows(PackageT& package) {
  PackedSceneT& scene = *package.scenes[0];
  const auto darken = [&](const std::vector<PackedBinding>& bindings) {
    for (const PackedBinding& binding : bindings) {
      if (binding.source() == PackedSource::shadow_intensity) scene.slot_values[scene.slots[binding.a()].first()] = 1;
    }
  };
  for (const auto& shape : scene.shapes) {
    darken(shape->bindings);
    for (const auto& variant : shape->variants) darken(variant->bindings);
  }
}

}  // namespace

MeasurablePackage make_measurable(const std::vector<std::uint8_t>& bytes, const Settings& settings) {
  const std::unique_ptr<PackageT> package = unpack(bytes);
  PackedSceneT& scene = *package->scenes[0];
  apply(scene, settings);
  MeasurablePackage made;
  made.lights = separate_lights(scene);
  made.scales = separate_scales(scene);
  darken_shadows(*package);
  number_shapes(*package);
  made.bytes = write_package(*package);
  made.package = &opened(made.bytes);
  return made;
}

std::vector<std::uint8_t> with_settings(const std::vector<std::uint8_t>& bytes, const Settings& settings) {
  const std::unique_ptr<PackageT> package = unpack(bytes);
  apply(*package->scenes[0], settings);
  return write_package(*package);
}

}  // namespace plugc
