#include "base/placed_box.h"

#include <algorithm>
#include <cmath>

namespace plugc {

std::optional<glm::dvec4> front_of(const PlacedBox& placed, const glm::dvec4& light) {
  const glm::dvec3 size = placed.box.size();
  const double thin = kThinnest * std::max({size.x, size.y, size.z});
  const int axis = size.x <= thin ? 0 : size.y <= thin ? 1 : size.z <= thin ? 2 : -1;
  if (axis < 0 || !placed.known) return std::nullopt;
  const glm::dmat3 axes(placed.to_world);
  glm::dvec3 normal = glm::cross(axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
  const double length = glm::length(normal);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const glm::dvec3 center(placed.to_world * glm::dvec4(placed.box.center(), 1));
  if (glm::dot(normal, glm::dvec3(light) - center * light.w) < 0) normal = -normal;
  return glm::dvec4(normal, -glm::dot(normal, center)) / length;
}

}  // namespace plugc
