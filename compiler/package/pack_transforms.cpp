// What few transforms have stands in lists beside them, which name the transform.

#include "package/pack_transforms.h"

namespace plugc {

void pack_transforms(const Scene& scene, PackedSceneT& packed) {
  for (std::size_t i = 0; i < scene.transforms.size(); ++i) {
    const SceneTransform& t = scene.transforms[i];
    const auto index = static_cast<std::uint32_t>(i);
    packed.transforms.emplace_back(t.parent, t.translation, t.rotation, t.scale, t.scale_orientation, t.center, t.switch_slot,
                                   t.choice);
    if (t.billboard_axis != kSceneNoSlot) packed.billboards.emplace_back(index, t.billboard_axis);
    if (t.lod_center != kSceneNoSlot) packed.lod_levels.emplace_back(index, t.lod_center, t.lod_from, t.lod_to);
  }
  for (const SceneTextureTransform& t : scene.texture_transforms)
    packed.texture_transforms.emplace_back(t.translation, t.rotation, t.scale, t.center);
}

}  // namespace plugc
