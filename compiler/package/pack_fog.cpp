#include "package/pack_fog.h"

namespace plugc {

std::optional<PackedBinding> bind_fog_plane(std::uint32_t uniform, const CastleName& name, const BindingContext& context) {
  if (name.source != CastleSource::fog_plane || context.shape.fog < 0) return std::nullopt;
  const std::uint32_t plane = context.fog_planes[static_cast<std::size_t>(context.shape.fog)];
  if (plane == UINT32_MAX) return std::nullopt;
  return PackedBinding(uniform, plane, 0, 1, PackedSource::fog_plane);
}

std::vector<std::uint32_t> pack_fog_planes(const Scene& scene, PackedSceneT& packed) {
  std::vector<std::uint32_t> planes(scene.fogs.size(), UINT32_MAX);
  for (std::size_t i = 0; i < scene.fogs.size(); ++i) {
    const SceneFog& fog = scene.fogs[i];
    if (!fog.volumetric) continue;
    planes[i] = static_cast<std::uint32_t>(packed.fog_planes.size());
    packed.fog_planes.emplace_back(fog.transform, fog.direction, fog.start);
  }
  return planes;
}

}  // namespace plugc
