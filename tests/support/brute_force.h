#pragma once
// Rays against a few triangles, one by one and in double: what must be true of a shadow, found without any of the code that
// draws it.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

namespace plugc {

struct Triangle {
  glm::dvec3 a, b, c;
};

struct Hit {
  double distance = 0;  ///< In lengths of the ray's direction.
  std::uint32_t triangle = 0;
};

/// The first triangle hit between the two distances, from either side.
std::optional<Hit> first_hit(const std::vector<Triangle>& triangles, const glm::dvec3& origin, const glm::dvec3& direction,
                             double from, double to);

/// Whether any triangle but `ignored` is hit between the two distances.
bool is_blocked(const std::vector<Triangle>& triangles, const glm::dvec3& origin, const glm::dvec3& direction, double from,
                double to, std::uint32_t ignored);

}  // namespace plugc
