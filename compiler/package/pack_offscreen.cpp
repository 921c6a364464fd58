#include "package/pack_offscreen.h"

#include <algorithm>

#include "package/pack_bindings.h"
#include "package/pack_texture.h"

namespace plugc {
namespace {

std::unique_ptr<PackedRenderedTextureT> pack_rendered_texture(const SceneRenderedTexture& texture) {
  auto packed = std::make_unique<PackedRenderedTextureT>();
  packed->kind = static_cast<PackedRenderedKind>(texture.kind);
  packed->width = texture.width;
  packed->height = texture.height;
  packed->update = static_cast<PackedShadowUpdate>(texture.update);
  packed->viewpoint = texture.viewpoint;
  packed->own_scene = texture.own_scene;
  packed->background_color = texture.background_color;
  packed->rendering_slots = texture.rendering_slots;
  packed->viewing_slots = texture.viewing_slots;
  packed->projection_slots = texture.projection_slots;
  packed->in_mirror = texture.in_mirror;
  packed->distance_from_shape = texture.distance_from_shape;
  packed->own_backdrop = texture.own_backdrop;
  for (const SlotLoan& loan : texture.loans) packed->loans.emplace_back(loan.from, loan.to);
  return packed;
}

}  // namespace

void pack_rendered_textures(const Scene& scene, PackedSceneT& packed) {
  for (const SceneRenderedTexture& texture : scene.rendered_textures)
    packed.rendered_textures.push_back(pack_rendered_texture(texture));
  for (const SceneTexture& texture : scene.textures) {
    if (texture.rendered < 0) continue;
    PackedRenderedTextureT& rendered = *packed.rendered_textures[static_cast<std::size_t>(texture.rendered)];
    rendered.wrap_s = static_cast<PackedWrap>(texture.wrap_s);
    rendered.wrap_t = static_cast<PackedWrap>(texture.wrap_t);
    rendered.minification = static_cast<PackedFilter>(texture.minification);
    rendered.magnification = static_cast<PackedFilter>(texture.magnification);
    rendered.border = pack_border(texture);
  }
}

void pack_screen_effects(const SceneParts& parts, const Packed& where, PackedSceneT& packed) {
  const SceneShape none;
  for (std::size_t i = 0; i < parts.screen_programs.size(); ++i) {
    const SceneScreenEffect& effect = parts.scene.screen_effects[i];
    const auto index = static_cast<std::size_t>(parts.screen_programs[i]);
    if (where.programs[index] == kNothing) continue;
    packed.screen_effects.push_back(std::make_unique<PackedScreenEffectT>());
    PackedScreenEffectT& added = *packed.screen_effects.back();
    added.name = effect.label;
    added.program = where.programs[index];
    added.bindings = pack_bindings(parts.programs[index], {parts.scene, none, where.textures, where.fog_planes});
    added.enabled = effect.enabled;
    added.needs_depth = effect.needs_depth;
    added.transform = effect.transform;
  }
}

}  // namespace plugc
