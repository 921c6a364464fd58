#include "runtime/measure/map_footprint.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/projection.h"

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

MapProjection MapProjection::at(const glm::dvec3& point) const {
  if (!cube) return *this;
  const glm::dvec3 way = point - light;
  const glm::dvec3 size_along = glm::abs(way);
  const int axis = size_along.x >= size_along.y && size_along.x >= size_along.z ? 0 : size_along.y >= size_along.z ? 1 : 2;
  glm::dvec3 direction(0);
  direction[axis] = way[axis] < 0 ? -1 : 1;
  View face = look_along(light, direction, axis == 1 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
  face.projection = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 2.0);
  return {plugc::world_to_texture(face), size, false, light};
}

glm::dvec2 MapProjection::texel(const glm::dvec3& point) const {
  const glm::dvec4 at = world_to_texture * glm::dvec4(point, 1);
  return glm::dvec2(at) / at.w * size;
}

glm::dmat2 texels_per_pixel(const MapProjection& map, const CameraRays& rays, const TruthPixel& pixel, double x, double y) {
  const MapProjection flat = map.at(pixel.point);
  const auto texel = [&](double dx, double dy) {
    return flat.texel(rays.on_plane(x + dx, y + dy, {pixel.point, pixel.normal}));
  };
  return {texel(0.5, 0) - texel(-0.5, 0), texel(0, 0.5) - texel(0, -0.5)};
}

glm::dvec3 moved_in_map(const MapProjection& map, const TruthPixel& pixel, const glm::dvec2& texels) {
  const glm::dvec3 first = any_tangent(pixel.normal);
  const glm::dvec3 second = glm::cross(pixel.normal, first);
  const MapProjection flat = map.at(pixel.point);
  const glm::dmat2 texels_per_length(derivative(flat, pixel.point, first), derivative(flat, pixel.point, second));
  const glm::dvec2 lengths = glm::inverse(texels_per_length) * texels;
  return pixel.point + lengths.x * first + lengths.y * second;
}

}  // namespace plugc
