#include "runtime/place_scene.h"

namespace plugc {
namespace {

/// Notes which slots placing reads.
void place_anew(LoadedScene& scene, const Viewer* viewer) {
  scene.slots.set_watching(true);
  scene.world = place(*scene.package, *scene.packed, scene.slots, viewer, scene.placed_scene, &scene.live_meshes);
  scene.slots.set_watching(false);
  if (scene.placed_scene < 0) scene.world.framed = scene.framed;
}

}  // namespace

void place_scene(LoadedScene& scene, std::int32_t own_scene_of) {
  const bool moved = update_live_meshes(scene.live_meshes, scene.slots);
  if (!moved && scene.placed_revision == scene.slots.watched_revision() && scene.placed_scene == own_scene_of) return;
  scene.placed_scene = own_scene_of;
  place_anew(scene, nullptr);
  scene.placed_revision = scene.slots.watched_revision();
  scene.placed_for.reset();
}

bool place_for_viewer(LoadedScene& scene, const View& camera) {
  if (!depends_on_viewer(*scene.packed)) return false;
  const Viewer viewer{glm::dvec3(camera.eye_to_world[3]), glm::dvec3(camera.eye_to_world[1]),
                      glm::dvec3(camera.eye_to_world[2])};
  if (scene.placed_for == viewer) return false;
  place_anew(scene, &viewer);
  scene.placed_for = viewer;
  return true;
}

}  // namespace plugc
