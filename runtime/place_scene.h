#pragma once
// Brings LoadedScene::world up to date.

#include "runtime/loaded_scene.h"

namespace plugc {

/// Places what the view of a scene shows: of the one that rendered texture `own_scene_of` has of its own, or of the world (-1).
void place_scene(LoadedScene& scene, std::int32_t own_scene_of = -1);

/// Turns what has to face the viewer. True where something may stand elsewhere now, the camera too.
bool turn_billboards(LoadedScene& scene, const View& camera);

/// The eye that `look()` gives, with everything turned to it.
View settled_camera(LoadedScene& scene, const auto& look) {
  const View camera = look();
  return turn_billboards(scene, camera) ? look() : camera;
}

}  // namespace plugc
