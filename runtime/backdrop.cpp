// The shapes of the backdrop lie at a distance of 1 around the eye. They are drawn at the far plane whatever the camera's depth
// range, so that they need no depth range of their own and hide nothing.

#include "runtime/backdrop.h"

#include "runtime/gl/pass.h"
#include "runtime/perspective.h"

namespace plugc {

View backdrop_view(const View& camera) {
  View view = camera;
  view.world_to_eye[3] = view.eye_to_world[3] = glm::dvec4(0, 0, 0, 1);
  if (!is_orthographic(camera)) return view;
  constexpr double kNear = 0.1, kFar = 10;  // any will do
  view.projection = perspective(kDefaultFieldOfView, camera.projection[1][1] / camera.projection[0][0], kNear, kFar);
  return view;
}

std::uint32_t draw_backdrop(const gl::Functions& gl, LoadedScene& scene, Pass& pass, std::int32_t of, Messages& messages) {
  const View view = backdrop_view(pass.view);
  Pass around{.view = view, .shadows = pass.shadows, .shadow_views = pass.shadow_views};
  around.bound_viewpoint = pass.bound_viewpoint;
  around.target_size = pass.target_size;
  std::uint32_t drawn = 0;
  gl::set_far_away(gl, true);
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) {
    const PackedShape& shape = scene.shape(i);
    const bool is_there = of >= 0 || scene.world.shape_visible[i];  // one of a texture's own stands in no scene
    if (shape.layer() == PackedLayer::backdrop && shape.own_scene_of() == of && is_there)
      drawn += draw_shape(gl, scene, around, i, messages) ? 1 : 0;
  }
  gl::set_far_away(gl, false);
  pass.programs.merge(around.programs);
  return drawn;
}

}  // namespace plugc
