#pragma once
// Brings LoadedScene::world up to date.

#include "runtime/loaded_scene.h"

namespace plugc {

/// Places what the view of a scene shows: of the one that rendered texture `own_scene_of` has of its own, or of the world (-1).
void place_scene(LoadedScene& scene, std::int32_t own_scene_of = -1);

/// Turns what has to face the viewer, and chooses levels of detail. True where something may stand elsewhere now, the camera
/// too.
bool place_for_viewer(LoadedScene& scene, const View& camera);

/// The eye that `look()` gives, with everything placed for it.
View settled_camera(LoadedScene& scene, const auto& look) {
  const View camera = look();
  return place_for_viewer(scene, camera) ? look() : camera;
}

}  // namespace plugc
