#include "runtime/place_scene.h"

namespace plugc {

void place_scene(LoadedScene& scene, std::int32_t own_scene_of) {
  if (scene.placed_revision == scene.slots.revision() && scene.placed_scene == own_scene_of) return;
  scene.world = place(*scene.package, *scene.packed, scene.slots, nullptr, own_scene_of);
  scene.placed_revision = scene.slots.revision();
  scene.placed_scene = own_scene_of;
  scene.placed_for.reset();
}

bool place_for_viewer(LoadedScene& scene, const View& camera) {
  if (!depends_on_viewer(*scene.packed)) return false;
  const Viewer viewer{glm::dvec3(camera.eye_to_world[3]), glm::dvec3(camera.eye_to_world[1]),
                      glm::dvec3(camera.eye_to_world[2])};
  if (scene.placed_for == viewer) return false;
  scene.world = place(*scene.package, *scene.packed, scene.slots, &viewer, scene.placed_scene);
  scene.placed_for = viewer;
  return true;
}

}  // namespace plugc
