// A scene's own lists: slots, transforms, lights, shadow maps, viewpoints.

#include "base/limits.h"
#include "package/package_file_check.h"

namespace plugc {
namespace {

/// The value behind a slot's last.
std::uint64_t end_of(const SceneCheck& scene, std::size_t index) {
  return scene.scene.slots()->Get(static_cast<flatbuffers::uoffset_t>(index))->first() +
         scene.slot_size(static_cast<std::uint32_t>(index));
}

/// Each lies behind the one before, so that no two share values, and all together are no more than there are values.
bool check_slot(SceneCheck& scene, const PackedSlot& slot, const Place& place) {
  if (!is_enumerator(slot.type())) return scene.check.fail(place, "its type is unknown");
  if (place.index != 0 && slot.first() < end_of(scene, place.index - 1))
    return scene.check.fail(place, fmt::format("it begins at value {}, in the slot before", slot.first()));
  const std::uint64_t end = end_of(scene, place.index);
  const std::size_t available = scene.scene.slot_values()->size();
  return end <= available || scene.check.fail(place, fmt::format("it ends at value {} of {}", end, available));
}

bool check_slots(SceneCheck& scene, const Place& place) {
  PackageCheck& check = scene.check;
  const auto& values = *scene.scene.slot_values();
  if (values.size() != 0 && !is_aligned(values.data(), alignof(double)))
    return check.fail(place, "its slot values are not aligned");
  return check.charge(place, values) &&
         check.each(&place, "slot", *scene.scene.slots(),
                    [&](const PackedSlot* slot, const Place& at) { return check_slot(scene, *slot, at); }) &&
         check.each(&place, "slot name", *scene.scene.slot_names(), [&](const PackedSlotName* name, const Place& at) {
           return check.charge(at, *name->name()) && scene.present_slot(at, "it", name->slot(), 0);
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
  return scene.check.charge(place, *light.name()) && scene.transform(place, light.transform()) &&
         scene.slot(place, "on", light.on(), 1) && scene.slot(place, "color", light.color(), 3) &&
         scene.slot(place, "intensity", light.intensity(), 1) &&
         scene.slot(place, "ambient intensity", light.ambient_intensity(), 1) &&
         scene.slot(place, "location", light.location(), 3) && scene.slot(place, "direction", light.direction(), 3) &&
         scene.slot(place, "attenuation", light.attenuation(), 3) && scene.slot(place, "radius", light.radius(), 1) &&
         scene.slot(place, "cut off angle", light.cut_off_angle(), 1) &&
         scene.slot(place, "beam width", light.beam_width(), 1) &&
         scene.slot(place, "shadow intensity", light.shadow_intensity(), 1);
}

bool check_shadow_map(SceneCheck& scene, const PackedShadowMap& map, const Place& place) {
  PackageCheck& check = scene.check;
  if (map.size() < 1 || map.size() > kMaxShadowMapSide)
    return check.fail(place, fmt::format("its size {} is out of range", map.size()));
  if (!is_enumerator(map.update())) return check.fail(place, "its update mode is unknown");
  if (!is_enumerator(map.method())) return check.fail(place, "its method is unknown");
  if (keeps_moments(map.method()) && map.size() > kMaxMomentMapSide)
    return check.fail(place, fmt::format("its size {} is out of range for moments", map.size()));
  return check.require_index(place, "light", map.light(), scene.scene.lights()->size()) &&
         scene.slot(place, "scale", map.scale(), 1) && scene.slot(place, "bias", map.bias(), 1) &&
         scene.slot(place, "near", map.near(), 1) && scene.slot(place, "far", map.far(), 1) &&
         scene.slot(place, "up", map.up(), 3) && scene.slot(place, "angle", map.angle(), 1) &&
         scene.slot(place, "rectangle", map.rectangle(), 4) && scene.slot(place, "location", map.location(), 3);
}

/// A map that keeps moments has the programs that make them, and no other map has any.
bool check_map_programs(SceneCheck& scene, const PackedShadowMap& map, const Place& place) {
  PackageCheck& check = scene.check;
  const std::size_t count = check.package.programs()->size();
  for (const std::int32_t program : {map.moments_program(), map.blur_program()}) {
    if ((program >= 0) != keeps_moments(map.method()) || !is_index_or_none(program, count))
      return check.fail(place, fmt::format("program {} does not fit its method", program));
  }
  return check_bindings(scene, Drawn::moments, "moments binding", *map.moments_bindings(), map.moments_program(), place) &&
         check_bindings(scene, Drawn::blur, "blur binding", *map.blur_bindings(), map.blur_program(), place);
}

bool check_billboard(SceneCheck& scene, const PackedBillboard& billboard, const Place& place) {
  return scene.check.require_index(place, "transform", billboard.transform(), scene.scene.transforms()->size()) &&
         scene.present_slot(place, "axis", billboard.axis(), 3);
}

bool check_clip_plane(SceneCheck& scene, const PackedClipPlane& plane, const Place& place) {
  return scene.transform(place, plane.transform()) && scene.present_slot(place, "plane", plane.plane(), 4) &&
         scene.present_slot(place, "enabled", plane.enabled(), 1);
}

bool check_fog_plane(SceneCheck& scene, const PackedFogPlane& plane, const Place& place) {
  return scene.transform(place, plane.transform()) && scene.present_slot(place, "direction", plane.direction(), 3) &&
         scene.present_slot(place, "start", plane.start(), 1);
}

bool check_lod_level(SceneCheck& scene, const PackedLodLevel& level, const Place& place) {
  const bool is_range = level.from() >= 0 && level.from() <= level.to();  // false for NaN
  if (!is_range) return scene.check.fail(place, fmt::format("{} to {} is no range", level.from(), level.to()));
  return scene.check.require_index(place, "transform", level.transform(), scene.scene.transforms()->size()) &&
         scene.present_slot(place, "center", level.center(), 3);
}

bool check_texture_transform(SceneCheck& scene, const PackedTextureTransform& transform, const Place& place) {
  return scene.slot(place, "translation", transform.translation(), 2) &&
         scene.slot(place, "rotation", transform.rotation(), 1) && scene.slot(place, "scale", transform.scale(), 2) &&
         scene.slot(place, "center", transform.center(), 2);
}

bool check_viewpoint(SceneCheck& scene, const PackedViewpoint& viewpoint, const Place& place) {
  return scene.check.charge(place, *viewpoint.name()) && scene.check.charge(place, *viewpoint.description()) &&
         scene.transform(place, viewpoint.transform()) && scene.slot(place, "position", viewpoint.position(), 3) &&
         scene.slot(place, "orientation", viewpoint.orientation(), 4) &&
         scene.slot(place, "direction", viewpoint.direction(), 3) && scene.slot(place, "up", viewpoint.up(), 3) &&
         scene.slot(place, "field of view", viewpoint.field_of_view(), viewpoint.orthographic() ? 4 : 1);
}

}  // namespace

bool check_scene(PackageCheck& check, const PackedScene& packed, const Place& place) {
  SceneCheck scene{check, packed};
  // Slots first: whatever names one asks how many numbers it has.
  return check_slots(scene, place) &&
         check.each(
             &place, "transform", *packed.transforms(),
             [&](const PackedTransform* transform, const Place& at) { return check_transform(scene, *transform, at); }) &&
         (packed.billboards() == nullptr ||
          check.each(&place, "billboard", *packed.billboards(),
                     [&](const PackedBillboard* one, const Place& at) { return check_billboard(scene, *one, at); })) &&
         (packed.clip_planes() == nullptr ||
          check.each(&place, "clip plane", *packed.clip_planes(),
                     [&](const PackedClipPlane* plane, const Place& at) { return check_clip_plane(scene, *plane, at); })) &&
         (packed.fog_planes() == nullptr ||
          check.each(&place, "fog plane", *packed.fog_planes(),
                     [&](const PackedFogPlane* plane, const Place& at) { return check_fog_plane(scene, *plane, at); })) &&
         (packed.lod_levels() == nullptr ||
          check.each(&place, "level of detail", *packed.lod_levels(),
                     [&](const PackedLodLevel* one, const Place& at) { return check_lod_level(scene, *one, at); })) &&
         check.each(&place, "light", *packed.lights(),
                    [&](const PackedLight* light, const Place& at) { return check_light(scene, *light, at); }) &&
         check.each(&place, "shadow map", *packed.shadow_maps(),
                    [&](const PackedShadowMap* map, const Place& at) {
                      return check_shadow_map(scene, *map, at) && check_map_programs(scene, *map, at);
                    }) &&
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
         (packed.viewpoints()->size() == 0 || is_index_or_none(packed.bound_viewpoint(), packed.viewpoints()->size()) ||
          check.fail(place, fmt::format("its bound viewpoint {} does not exist", packed.bound_viewpoint()))) &&
         check_offscreen(scene, place) && scene.slot(place, "background color", packed.background_color(), 3) &&
         scene.slot(place, "visibility limit", packed.visibility_limit(), 1) &&
         scene.slot(place, "bound viewpoint", packed.bound_viewpoint_now(), 1) &&
         scene.slot(place, "bound background", packed.bound_background(), 1) && check_events(scene, place) &&
         check_live_meshes(scene, place);
}

}  // namespace plugc
