#include "shadows/map_footprint.h"

#include <cmath>

namespace plugc {
namespace {

glm::dvec3 any_tangent(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, axis));
}

/// How the map coordinate changes along a direction at a point: the derivative of a quotient.
glm::dvec2 derivative(const MapProjection& map, const glm::dvec3& point, const glm::dvec3& direction) {
  const glm::dvec4 at = map.world_to_texture * glm::dvec4(point, 1);
  const glm::dvec4 step = map.world_to_texture * glm::dvec4(direction, 0);
  return (glm::dvec2(step) - glm::dvec2(at) * (step.w / at.w)) / at.w * map.size;
}

}  // namespace

glm::dvec2 MapProjection::texel(const glm::dvec3& point) const {
  const glm::dvec4 at = world_to_texture * glm::dvec4(point, 1);
  return glm::dvec2(at) / at.w * size;
}

glm::dmat2 texels_per_pixel(const MapProjection& map, const CameraRays& rays, const TruthPixel& pixel, double x, double y) {
  const auto texel = [&](double dx, double dy) { return map.texel(rays.on_plane(x + dx, y + dy, pixel.point, pixel.normal)); };
  return {texel(0.5, 0) - texel(-0.5, 0), texel(0, 0.5) - texel(0, -0.5)};
}

glm::dvec3 moved_in_map(const MapProjection& map, const TruthPixel& pixel, const glm::dvec2& texels) {
  const glm::dvec3 first = any_tangent(pixel.normal);
  const glm::dvec3 second = glm::cross(pixel.normal, first);
  const glm::dmat2 texels_per_length(derivative(map, pixel.point, first), derivative(map, pixel.point, second));
  const glm::dvec2 lengths = glm::inverse(texels_per_length) * texels;
  return pixel.point + lengths.x * first + lengths.y * second;
}

}  // namespace plugc
