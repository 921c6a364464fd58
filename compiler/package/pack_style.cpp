// Table by table: what a castle_ name of a style means for a shape.

#include "package/pack_style.h"

namespace plugc {
namespace {

std::optional<PackedBinding> bind_slot(std::uint32_t uniform, std::uint32_t slot) {
  if (slot == kSceneNoSlot) return std::nullopt;
  return PackedBinding(uniform, slot, 0, 1, PackedSource::slot);
}

std::optional<PackedBinding> bind_back(std::uint32_t uniform, CastleSource source, const BindingContext& context) {
  constexpr float kShininessScale = 128;
  if (context.shape.back_material < 0) return std::nullopt;
  const SceneMaterial& back = context.scene.materials[static_cast<std::size_t>(context.shape.back_material)];
  switch (source) {
    case CastleSource::back_diffuse_alpha:
      return PackedBinding(uniform, back.diffuse, back.transparency, 1, PackedSource::color_and_transparency);
    case CastleSource::back_unlit_color:
      return PackedBinding(uniform, back.emissive, back.transparency, 1, PackedSource::color_and_transparency);
    case CastleSource::back_ambient:
      return PackedBinding(uniform, back.ambient_color, back.ambient, 1, PackedSource::slot_product);
    case CastleSource::back_specular: return bind_slot(uniform, back.specular);
    case CastleSource::back_emissive: return bind_slot(uniform, back.emissive);
    case CastleSource::back_shininess:
      return PackedBinding(uniform, back.shininess, 0, kShininessScale, PackedSource::slot_scaled);
    case CastleSource::back_metallic: return bind_slot(uniform, back.metallic);
    case CastleSource::back_roughness: return bind_slot(uniform, back.roughness);
    default: return std::nullopt;
  }
}

}  // namespace

std::optional<PackedBinding> bind_style(std::uint32_t uniform, const CastleName& name, const BindingContext& context) {
  const SceneStyle& style = context.shape.style;
  const auto& planes = context.shape.clip_planes;
  switch (name.source) {
    case CastleSource::alpha_cutoff: return bind_slot(uniform, context.shape.alpha_cutoff);
    case CastleSource::point_size: return bind_slot(uniform, style.point_size);
    case CastleSource::point_size_least: return bind_slot(uniform, style.point_least);
    case CastleSource::point_size_most: return bind_slot(uniform, style.point_most);
    case CastleSource::point_falloff: return bind_slot(uniform, style.point_falloff);
    case CastleSource::hatch_color: return bind_slot(uniform, style.hatch_color);
    case CastleSource::target_size: return PackedBinding(uniform, 0, 0, 1, PackedSource::target_size);
    case CastleSource::clip_plane: {
      const auto number = static_cast<std::size_t>(name.number);
      if (number >= planes.size()) return std::nullopt;
      return PackedBinding(uniform, static_cast<std::uint32_t>(planes[number]), 0, 1, PackedSource::clip_plane);
    }
    default: return bind_back(uniform, name.source, context);
  }
}

void pack_style(const SceneShape& shape, bool sized_points, PackedShapeT& packed) {
  packed.line_width = shape.style.line_width;
  packed.alpha_cutoff = shape.alpha_cutoff;
  packed.blend_color = shape.blend.color;
  packed.blend_transparency = shape.blend.transparency;
  packed.sized_points = sized_points;
}

void pack_clip_planes(const Scene& scene, PackedSceneT& packed) {
  for (const SceneClipPlane& plane : scene.clip_planes)
    packed.clip_planes.emplace_back(plane.transform, plane.plane, plane.enabled);
}

}  // namespace plugc
