// A ray that comes to the eye from the mirror comes, before the mirror, from where the eye's image behind it looks along the
// straight line. So the picture in the mirror is what the image sees through the mirror as through a window. Its own axes are
// the viewer's, mirrored (x twice, so that they stay right-handed): eye space means the same on both sides, for fog, say.
// The projection looks straight through the window, whatever the axes: then the near plane lies in the mirror.

#include "runtime/mirror.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace plugc {
namespace {

constexpr double kEdgeOn = 1e-9;        // the least sine of the angle between a look and the mirror
constexpr double kNearestShare = 1e-6;  // of the image's distance: some near plane a perspective must have
// What is behind the far plane is cut, and effects may move shapes out of their boxes: so many times the reach. Rays that are
// parallel still have 17 of 24 bits of depth for what is in the boxes; others lose nothing.
constexpr double kBeyond = 100;

/// Of unit length, on the viewer's side.
std::optional<glm::dvec3> normal_to_viewer(const Mirror& mirror, const View& viewer) {
  const glm::dvec3 across = glm::cross(mirror.right, mirror.up);
  const double area = glm::length(across);
  if (!(area > 0) || !std::isfinite(area)) return std::nullopt;
  const glm::dvec3 to_viewer =
      is_orthographic(viewer) ? glm::dvec3(viewer.eye_to_world[2]) : glm::dvec3(viewer.eye_to_world[3]) - mirror.corner;
  const double side = glm::dot(across / area, to_viewer);
  if (!(std::abs(side) > kEdgeOn * glm::length(to_viewer))) return std::nullopt;
  return side < 0 ? -across / area : across / area;
}

View mirror_image(const View& viewer, const glm::dvec3& on_mirror, const glm::dvec3& normal) {
  const auto mirrored = [&](const glm::dvec3& direction) { return direction - 2 * glm::dot(direction, normal) * normal; };
  const glm::dvec3 eye(viewer.eye_to_world[3]);
  return look_along(on_mirror + mirrored(eye - on_mirror), mirrored(-glm::dvec3(viewer.eye_to_world[2])),
                    mirrored(glm::dvec3(viewer.eye_to_world[1])));
}

/// Of the mirror's corners, in a space where it lies across z: left, bottom, right, top.
glm::dvec4 extents(const Mirror& mirror, const glm::dmat4& to_space) {
  const std::array<glm::dvec3, 4> corners = {mirror.corner, mirror.corner + mirror.right, mirror.corner + mirror.up,
                                             mirror.corner + mirror.right + mirror.up};
  glm::dvec2 low(to_space * glm::dvec4(corners[0], 1));
  glm::dvec2 high = low;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec2 place(to_space * glm::dvec4(corner, 1));
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  return {low, high};
}

/// How far from the eye any of it may be.
double reach_of(const Box& bounds, const glm::dvec3& eye) {
  double reach = 0;
  if (bounds.empty()) return reach;
  for (const glm::dvec3& corner : corners(bounds)) reach = std::max(reach, glm::length(corner - eye));
  return reach;
}

glm::dmat4 through_window(const glm::dvec4& window, double away, double distance, double reach) {
  const double near = std::max(away + distance, away * kNearestShare);
  const glm::dvec4 at_near = window * (near / away);
  return glm::frustum(at_near.x, at_near.z, at_near.y, at_near.w, near, std::max(reach, near) * kBeyond);
}

/// Rays along `look`, which is not straight through the window: what lies away from it is moved sideways.
glm::dmat4 along_through_window(const glm::dvec4& window, const glm::dvec3& look, double away, double distance, double reach) {
  glm::dmat4 shear(1.0);
  shear[2] = glm::dvec4(-look.x / look.z, -look.y / look.z, 1, 0);
  shear[3] = glm::dvec4(-look.x / look.z * away, -look.y / look.z * away, 0, 1);
  const double near = away + distance;
  const double far = near + std::max({reach - near, std::abs(near), std::abs(reach)}) * kBeyond;
  return glm::ortho(window.x, window.z, window.y, window.w, near, far) * shear;
}

}  // namespace

Mirror place_mirror(const PackedWindow& window, const glm::dmat4& object_to_world) {
  const auto vector = [&](const PackedVec3& packed, double w) {
    return glm::dvec3(object_to_world * glm::dvec4(packed.x(), packed.y(), packed.z(), w));
  };
  return {vector(window.corner(), 1), vector(window.right(), 0), vector(window.up(), 0)};
}

std::optional<View> view_in_mirror(const Mirror& mirror, const View& viewer, double distance, const Box& bounds) {
  const auto normal = normal_to_viewer(mirror, viewer);
  if (!normal) return std::nullopt;
  View image = mirror_image(viewer, mirror.corner, *normal);
  const glm::dvec3 eye(image.eye_to_world[3]);
  const View straight = look_along(eye, *normal, mirror.up);
  const glm::dvec4 window = extents(mirror, straight.world_to_eye);
  const double away = glm::dot(mirror.corner - eye, *normal);
  const double reach = reach_of(bounds, eye);
  glm::dmat4 turn = straight.world_to_eye * image.eye_to_world;
  turn[3] = glm::dvec4(0, 0, 0, 1);  // both stand at the same place
  if (is_orthographic(viewer))
    image.projection = along_through_window(window, -glm::dvec3(turn[2]), away, distance, reach) * turn;
  else
    image.projection = through_window(window, away, distance, reach) * turn;
  return image;
}

}  // namespace plugc
