// Möller and Trumbore, 1997: the ray in coordinates of the triangle's edges.

#include "support/brute_force.h"

namespace plugc {
namespace {

std::optional<double> distance_to(const Triangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction) {
  const glm::dvec3 ab = triangle.b - triangle.a;
  const glm::dvec3 ac = triangle.c - triangle.a;
  const glm::dvec3 p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return std::nullopt;
  const glm::dvec3 from_a = origin - triangle.a;
  const double u = glm::dot(from_a, p) / determinant;
  if (!(u >= 0 && u <= 1)) return std::nullopt;
  const glm::dvec3 q = glm::cross(from_a, ab);
  const double v = glm::dot(direction, q) / determinant;
  if (!(v >= 0 && u + v <= 1)) return std::nullopt;
  return glm::dot(ac, q) / determinant;
}

}  // namespace

std::optional<Hit> first_hit(const std::vector<Triangle>& triangles, const glm::dvec3& origin, const glm::dvec3& direction,
                             double from, double to) {
  std::optional<Hit> nearest;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::optional<double> distance = distance_to(triangles[i], origin, direction);
    if (distance && *distance > from && *distance < (nearest ? nearest->distance : to)) nearest = Hit{*distance, i};
  }
  return nearest;
}

bool is_blocked(const std::vector<Triangle>& triangles, const glm::dvec3& origin, const glm::dvec3& direction, double from,
                double to, std::uint32_t ignored) {
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (i == ignored) continue;
    const std::optional<double> distance = distance_to(triangles[i], origin, direction);
    if (distance && *distance > from && *distance < to) return true;
  }
  return false;
}

}  // namespace plugc
