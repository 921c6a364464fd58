// A scene of a dump: its slots, and what they place, light and look through.

#include "package/package_file_dump.h"

namespace plugc {
namespace {

void dump_slot(Text& text, const PackedScene& scene, std::size_t index) {
  const PackedSlot& packed = *scene.slots()->Get(static_cast<std::uint32_t>(index));
  const double* first = scene.slot_values()->data() + packed.first();
  const std::size_t numbers = std::size_t{packed.count()} * component_count(packed.type());
  line(text, "  slot {}: {}[{}] {}", index, word(EnumNamePackedValueType(packed.type())), packed.count(),
       fmt::join(first, first + numbers, " "));
}

void dump_slots(Text& text, const PackedScene& scene) {
  for (std::size_t i = 0; i < scene.slots()->size(); ++i) dump_slot(text, scene, i);
  for (const auto* name : *scene.slot_names())
    line(text, "  slot {} is {}{}", name->slot(), quoted(*name->name()), name->dynamic() ? ", the host may change it" : "");
}

void dump_transform(Text& text, const PackedTransform& transform, std::size_t index) {
  line(text, "  transform {}: parent {}, slots: translation {}, rotation {}, scale {}, scale orientation {}, center {}", index,
       transform.parent(), slot(transform.translation()), slot(transform.rotation()), slot(transform.scale()),
       slot(transform.scale_orientation()), slot(transform.center()));
  if (transform.switch_slot() != kNoSlot) line(text, "    while slot {} is {}", transform.switch_slot(), transform.choice());
}

void dump_billboards(Text& text, const PackedScene& scene) {
  if (scene.billboards() == nullptr) return;
  for (const PackedBillboard* one : *scene.billboards())
    line(text, "  transform {} turns to the viewer about slot {}", one->transform(), one->axis());
}

void dump_clip_planes(Text& text, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; scene.clip_planes() != nullptr && i < scene.clip_planes()->size(); ++i) {
    const PackedClipPlane& plane = *scene.clip_planes()->Get(i);
    line(text, "  clip plane {}: transform {}, slots: plane {}, enabled {}", i, plane.transform(), plane.plane(),
         plane.enabled());
  }
}

void dump_fog_planes(Text& text, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; scene.fog_planes() != nullptr && i < scene.fog_planes()->size(); ++i) {
    const PackedFogPlane& plane = *scene.fog_planes()->Get(i);
    line(text, "  fog plane {}: transform {}, slots: direction {}, start {}", i, plane.transform(), plane.direction(),
         plane.start());
  }
}

void dump_lod_levels(Text& text, const PackedScene& scene) {
  if (scene.lod_levels() == nullptr) return;
  for (const PackedLodLevel* one : *scene.lod_levels())
    line(text, "  transform {} is shown from {:g} to {:g} away from slot {}", one->transform(), one->from(), one->to(),
         one->center());
}

void dump_light(Text& text, const PackedLight& light, std::size_t index) {
  line(text, "  light {} {}: {}{}, transform {}", index, quoted(*light.name()), EnumNamePackedLightKind(light.kind()),
       light.headlight() ? " headlight" : "", light.transform());
  line(text, "    slots: on {}, color {}, intensity {}, ambient intensity {}, location {}, direction {}", slot(light.on()),
       slot(light.color()), slot(light.intensity()), slot(light.ambient_intensity()), slot(light.location()),
       slot(light.direction()));
  line(text, "    slots: attenuation {}, radius {}, cut off angle {}, beam width {}, shadow intensity {}",
       slot(light.attenuation()), slot(light.radius()), slot(light.cut_off_angle()), slot(light.beam_width()),
       slot(light.shadow_intensity()));
}

void dump_shadow_map(Text& text, const Package& package, const PackedShadowMap& map, std::size_t index) {
  line(text, "  shadow map {}: light {}, size {}, update {}, method {}{}{}{}", index, map.light(), map.size(),
       EnumNamePackedShadowUpdate(map.update()), EnumNamePackedShadowMethod(map.method()),
       map.scale_written() ? ", scale written" : "", map.bias_written() ? ", bias written" : "",
       map.author_visible() ? ", seen by authors" : "");
  line(text, "    slots: scale {}, bias {}, near {}, far {}, up {}, angle {}, rectangle {}, location {}", slot(map.scale()),
       slot(map.bias()), slot(map.near()), slot(map.far()), slot(map.up()), slot(map.angle()), slot(map.rectangle()),
       slot(map.location()));
  if (const PackedShadowChoice* choice = map.choice()) {
    line(text, "    chosen for at most {:.3g} % of wrong pixels: {:.3g} % in {} view{}, against {}", 100 * choice->budget(),
         100 * choice->error(), choice->views(), choice->views() == 1 ? "" : "s",
         choice->traced_truth() ? "traced shadows" : "the largest map");
  }
  if (map.moments_program() < 0) return;
  line(text, "    moments program {}", map.moments_program());
  dump_bindings(text, *map.moments_bindings(), *package.programs()->Get(static_cast<std::uint32_t>(map.moments_program())));
  line(text, "    blur program {}", map.blur_program());
  dump_bindings(text, *map.blur_bindings(), *package.programs()->Get(static_cast<std::uint32_t>(map.blur_program())));
}

void dump_texture_transform(Text& text, const PackedTextureTransform& transform, std::size_t index) {
  line(text, "  texture transform {}: slots: translation {}, rotation {}, scale {}, center {}", index,
       slot(transform.translation()), slot(transform.rotation()), slot(transform.scale()), slot(transform.center()));
}

void dump_viewpoint(Text& text, const char* word, const PackedViewpoint& viewpoint, std::size_t index) {
  line(text, "  {} {} {} {}: transform {}{}", word, index, quoted(*viewpoint.name()), quoted(*viewpoint.description()),
       viewpoint.transform(),
       viewpoint.orthographic()        ? ", orthographic"
       : viewpoint.field_is_vertical() ? ", by its height"
                                       : "");
  line(text, "    slots: position {}, orientation {}, field of view {}", slot(viewpoint.position()),
       slot(viewpoint.orientation()), slot(viewpoint.field_of_view()));
  if (viewpoint.direction() != kNoSlot || viewpoint.up() != kNoSlot)
    line(text, "    slots: direction {}, up {}", slot(viewpoint.direction()), slot(viewpoint.up()));
}

}  // namespace

void dump_scene(Text& text, const Package& package, const PackedScene& scene, std::size_t index) {
  line(text, "scene {} {}: background color slot {}", index, quoted(*scene.name()), slot(scene.background_color()));
  if (scene.visibility_limit() != kNoSlot) line(text, "  visibility limit slot {}", scene.visibility_limit());
  dump_slots(text, scene);
  each(*scene.transforms(), [&](const PackedTransform& transform, std::size_t i) { dump_transform(text, transform, i); });
  dump_billboards(text, scene);
  dump_clip_planes(text, scene);
  dump_fog_planes(text, scene);
  dump_lod_levels(text, scene);
  each(*scene.lights(), [&](const PackedLight& light, std::size_t i) { dump_light(text, light, i); });
  each(*scene.shadow_maps(), [&](const PackedShadowMap& map, std::size_t i) { dump_shadow_map(text, package, map, i); });
  each(*scene.texture_transforms(),
       [&](const PackedTextureTransform& transform, std::size_t i) { dump_texture_transform(text, transform, i); });
  each(*scene.shapes(), [&](const PackedShape& shape, std::size_t i) { dump_shape(text, package, shape, i); });
  each(*scene.viewpoints(),
       [&](const PackedViewpoint& viewpoint, std::size_t i) { dump_viewpoint(text, "viewpoint", viewpoint, i); });
  if (scene.viewpoints()->size() != 0 && scene.bound_viewpoint() != 0)
    line(text, "  bound viewpoint {}", scene.bound_viewpoint());
  each(*scene.projectors(),
       [&](const PackedViewpoint& viewpoint, std::size_t i) { dump_viewpoint(text, "projector", viewpoint, i); });
  dump_bindings_now(text, scene);
  dump_events(text, scene);
  if (scene.live_meshes() != nullptr)
    each(*scene.live_meshes(), [&](const PackedLiveMesh& live, std::size_t) { dump_live_mesh(text, live); });
  if (scene.rendered_textures() != nullptr)
    each(*scene.rendered_textures(),
         [&](const PackedRenderedTexture& texture, std::size_t i) { dump_rendered_texture(text, texture, i); });
  if (scene.screen_effects() != nullptr)
    each(*scene.screen_effects(),
         [&](const PackedScreenEffect& effect, std::size_t i) { dump_screen_effect(text, package, effect, i); });
}

}  // namespace plugc
