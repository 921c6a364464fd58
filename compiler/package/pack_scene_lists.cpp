#include "package/pack_scene_lists.h"

namespace plugc {

void pack_slots(const Scene& scene, PackedSceneT& packed) {
  for (std::size_t i = 0; i < scene.slots.size(); ++i) {
    const Slot& slot = scene.slots[i];
    packed.slots.emplace_back(static_cast<std::uint32_t>(packed.slot_values.size()), slot.count,
                              static_cast<PackedValueType>(slot.type));
    packed.slot_values.insert(packed.slot_values.end(), slot.values.begin(), slot.values.end());
    if (slot.name.empty()) continue;
    auto name = std::make_unique<PackedSlotNameT>();
    name->slot = static_cast<std::uint32_t>(i);
    name->name = slot.name;
    name->dynamic = slot.dynamic;
    packed.slot_names.push_back(std::move(name));
  }
}

std::unique_ptr<PackedLightT> pack_light(const SceneLight& light) {
  auto packed = std::make_unique<PackedLightT>();
  packed->kind = static_cast<PackedLightKind>(light.kind);
  packed->headlight = light.headlight;
  packed->transform = light.transform;
  packed->on = light.on;
  packed->color = light.color;
  packed->intensity = light.intensity;
  packed->ambient_intensity = light.ambient_intensity;
  packed->location = light.location;
  packed->direction = light.direction;
  packed->attenuation = light.attenuation;
  packed->radius = light.radius;
  packed->cut_off_angle = light.cut_off_angle;
  packed->beam_width = light.beam_width;
  packed->shadow_intensity = light.shadow_intensity;
  packed->name = light.label;
  return packed;
}

std::unique_ptr<PackedShadowMapT> pack_shadow_map(const SceneShadowMap& map) {
  auto packed = std::make_unique<PackedShadowMapT>();
  packed->light = static_cast<std::uint32_t>(map.light);
  packed->size = map.size;
  packed->update = static_cast<PackedShadowUpdate>(map.update);
  packed->method = static_cast<PackedShadowMethod>(map.method);
  packed->method_written = map.method_written;
  packed->size_written = map.size_written;
  if (const auto& choice = map.choice) {
    packed->choice = std::make_unique<PackedShadowChoiceT>();
    packed->choice->budget = choice->budget;
    packed->choice->error = choice->error;
    packed->choice->views = choice->views;
    packed->choice->traced_truth = choice->traced_truth;
  }
  packed->scale_written = map.scale_written;
  packed->bias_written = map.bias_written;
  packed->scale = map.scale;
  packed->bias = map.bias;
  packed->near = map.near;
  packed->far = map.far;
  packed->up = map.up;
  packed->angle = map.angle;
  packed->rectangle = map.rectangle;
  packed->location = map.location;
  packed->author_visible = map.author_visible;
  packed->other_light = map.other_light;
  return packed;
}

std::unique_ptr<PackedViewpointT> pack_viewpoint(const SceneViewpoint& viewpoint) {
  auto packed = std::make_unique<PackedViewpointT>();
  packed->name = viewpoint.name;
  packed->description = viewpoint.description;
  packed->transform = viewpoint.transform;
  packed->orthographic = viewpoint.orthographic;
  packed->position = viewpoint.position;
  packed->orientation = viewpoint.orientation;
  packed->field_of_view = viewpoint.field_of_view;
  packed->direction = viewpoint.direction;
  packed->up = viewpoint.up;
  packed->field_is_vertical = viewpoint.field_is_vertical;
  return packed;
}

}  // namespace plugc
