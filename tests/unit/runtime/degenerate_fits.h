#pragma once
// Boxes that no projection can be fitted to as to others: without an extent, without an end, without a number.

#include <limits>
#include <vector>

#include "runtime/projection.h"

namespace plugc::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline PlacedBox box(const glm::dvec3& low, const glm::dvec3& high) {
  return {{low, high}, glm::dmat4(1.0)};
}

inline std::vector<FitInput> degenerate_fit_inputs() {
  const PlacedBox unit = box(glm::dvec3(-1), glm::dvec3(1));
  return {
      {},
      {{box({0, 0, 0}, {0, 0, 0})}, {box({0, 0, 0}, {0, 0, 0})}},
      {{box({0, -1, -1}, {0, 1, 1})}, {box({0, -1, -1}, {0, 1, 1})}},
      {{box({-1, 0, -1}, {1, 0, 1})}, {box({-1, 0, -1}, {1, 0, 1})}},
      {{box({-1, -1, 0}, {1, 1, 0})}, {box({-1, -1, 0}, {1, 1, 0})}},
      {{box(glm::dvec3(-1e30), glm::dvec3(1e30))}, {box(glm::dvec3(-1e30), glm::dvec3(1e30))}},
      {{box(glm::dvec3(1e-38), glm::dvec3(2e-38))}, {box(glm::dvec3(1e-38), glm::dvec3(2e-38))}},
      {{box(glm::dvec3(-kInfinity), glm::dvec3(kInfinity))}, {box(glm::dvec3(kNan), glm::dvec3(kNan))}},
      {{{unit.box, glm::dmat4(0.0)}}, {{unit.box, glm::dmat4(kNan)}}},
  };
}

/// Directions and places that are none.
inline std::vector<glm::dvec3> degenerate_vectors() {
  return {{0, -1, 0}, {0, 0, 0}, {1e-320, 0, 0}, {1e300, 0, 1e300}, {kNan, 0, 0}, {kInfinity, 1, 0}};
}

}  // namespace plugc::test
