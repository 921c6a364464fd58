// Only fogs in layers have a plane: the plane of one is found by counting those before it.

#include "package/pack_fog.h"

#include <algorithm>

namespace plugc {

std::optional<PackedBinding> bind_fog_plane(std::uint32_t uniform, const CastleName& name, const BindingContext& context) {
  if (name.source != CastleSource::fog_plane || context.shape.fog < 0) return std::nullopt;
  const auto& fogs = context.scene.fogs;
  if (!fogs[static_cast<std::size_t>(context.shape.fog)].volumetric) return std::nullopt;
  const auto before = std::ranges::count_if(fogs.begin(), fogs.begin() + context.shape.fog, &SceneFog::volumetric);
  return PackedBinding(uniform, static_cast<std::uint32_t>(before), 0, 1, PackedSource::fog_plane);
}

void pack_fog_planes(const Scene& scene, PackedSceneT& packed) {
  for (const SceneFog& fog : scene.fogs) {
    if (fog.volumetric) packed.fog_planes.emplace_back(fog.transform, fog.direction, fog.start);
  }
}

}  // namespace plugc
