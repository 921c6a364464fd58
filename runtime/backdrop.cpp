// The shapes of the backdrop lie at a distance of 1 around the eye. They are drawn at the far plane whatever the camera's depth
// range, so that they need no depth range of their own and hide nothing.

#include "runtime/backdrop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/gl/pass.h"

namespace plugc {
namespace {

constexpr double kDefaultFieldOfView = std::numbers::pi / 4;  // X3D 4.1, 23.4.6

/// `field` is the smaller of both ways.
glm::dmat4 perspective(double field, double aspect) {
  constexpr double kNear = 0.1, kFar = 10;  // any will do
  const double half_height = std::tan(field / 2) / std::min(aspect, 1.0);
  const double half_width = half_height * aspect;
  return glm::frustum(-kNear * half_width, kNear * half_width, -kNear * half_height, kNear * half_height, kNear, kFar);
}

}  // namespace

glm::dmat4 rotation_of(const glm::dmat4& matrix) {
  return look_along(glm::dvec3(0), -glm::dvec3(matrix[2]), glm::dvec3(matrix[1])).eye_to_world;
}

View backdrop_view(const View& camera) {
  View view = camera;
  view.world_to_eye[3] = view.eye_to_world[3] = glm::dvec4(0, 0, 0, 1);
  const bool orthographic = camera.projection[3][3] == 1.0;
  if (orthographic) view.projection = perspective(kDefaultFieldOfView, camera.projection[1][1] / camera.projection[0][0]);
  return view;
}

std::uint32_t draw_backdrop(const gl::Functions& gl, LoadedScene& scene, Pass& pass, Messages& messages) {
  const View view = backdrop_view(pass.view);
  Pass around{view, false, pass.shadows, pass.shadow_views, {}};
  around.bound_viewpoint = pass.bound_viewpoint;
  around.target_size = pass.target_size;
  std::uint32_t drawn = 0;
  gl::set_far_away(gl, true);
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) {
    if (scene.shape(i).layer() == PackedLayer::backdrop && scene.world.shape_visible[i])
      drawn += draw_shape(gl, scene, around, i, messages) ? 1 : 0;
  }
  gl::set_far_away(gl, false);
  pass.programs.merge(around.programs);
  return drawn;
}

}  // namespace plugc
