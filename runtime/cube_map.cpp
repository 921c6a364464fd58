// The largest distance only has to reach the last receiver: what casts from farther away shadows nobody. `projectionNear` is a
// distance too, so the fragments leave out what is nearer: near planes of the faces would be a cube, not a sphere.

#include "runtime/cube_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace plugc {
namespace {

constexpr double kMargin = 1.01;          // of the largest distance, beyond the last receiver
constexpr double kSmallestReach = 1e-30;  // below it, reciprocals leave the range of floats
constexpr double kLargestReach = 1e30;
constexpr double kFilterReach = 8;   // texels that a filter may look beyond an edge
constexpr double kNearShare = 1e-4;  // of the largest distance: some near plane a projection must have
constexpr double kDepthUnit = 1.0 / (1 << 24);

struct Axes {
  glm::dvec3 direction, up;
};

constexpr std::array<Axes, kCubeFaceCount> kFaces = {{{{1, 0, 0}, {0, -1, 0}},
                                                      {{-1, 0, 0}, {0, -1, 0}},
                                                      {{0, 1, 0}, {0, 0, 1}},
                                                      {{0, -1, 0}, {0, 0, -1}},
                                                      {{0, 0, 1}, {0, -1, 0}},
                                                      {{0, 0, -1}, {0, -1, 0}}}};

double farthest(const std::vector<PlacedBox>& boxes, const glm::dvec3& from) {
  double distance = 0;
  for (const PlacedBox& placed : boxes) {
    if (placed.box.empty()) continue;
    for (const glm::dvec3& corner : corners(placed.box))
      distance = std::max(distance, glm::length(glm::dvec3(placed.to_world * glm::dvec4(corner, 1)) - from));
  }
  return distance;
}

bool is_usable(const glm::dvec3& place) {
  return glm::all(glm::lessThanEqual(glm::abs(place), glm::dvec3(kLargestReach)));
}

}  // namespace

View fit_point_light(const LightFrame& light, const FitInput& input) {
  const glm::dvec3 place = is_usable(light.location) ? light.location : glm::dvec3(0);
  double reach = light.far > 0 ? light.far : kMargin * farthest(input.receivers, place);
  if (!(light.far > 0) && light.radius > 0) reach = std::min(reach, light.radius);
  if (!(reach >= kSmallestReach && reach <= kLargestReach)) reach = 1;
  View view;
  view.all_around = true;
  view.near = std::min(light.near, reach);
  view.far = reach;
  view.world_to_eye = glm::translate(glm::dmat4(1.0), -place);
  view.eye_to_world = glm::translate(glm::dmat4(1.0), place);
  view.projection = glm::scale(glm::dmat4(1.0), glm::dvec3(1 / reach));
  return view;
}

View cube_face(const View& map, unsigned face, double tangent) {
  View view = look_along(glm::dvec3(map.eye_to_world[3]), kFaces[face].direction, kFaces[face].up);
  const double reach = 1 / map.projection[0][0];
  const double near = reach * kNearShare;
  view.projection = glm::frustum(-near * tangent, near * tangent, -near * tangent, near * tangent, near, reach);
  return view;
}

bool face_is_read(const View& map, unsigned face, int size, const FitInput& input) {
  const View view = cube_face(map, face, 1 + 2 * kFilterReach / size);
  const glm::dmat4 world_to_clip = view.projection * view.world_to_eye;
  return std::ranges::any_of(input.receivers, [&](const PlacedBox& placed) {
    if (!placed.known) return true;
    return !placed.box.empty() && !outside_sideways(placed.box, world_to_clip * placed.to_world);
  });
}

glm::dvec4 depth_pass_range(const View& map, double scale, double bias) {
  return {map.projection[0][0], scale, bias * kDepthUnit, map.near * map.projection[0][0]};
}

}  // namespace plugc
