#pragma once
// Axis-aligned boxes in double.

#include <array>
#include <limits>

#include <glm/glm.hpp>

namespace plugc {

/// Empty (min > max) until it is extended.
struct Box {
  glm::dvec3 min = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 max = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  glm::dvec3 center() const { return 0.5 * min + 0.5 * max; }
  glm::dvec3 size() const { return max - min; }
};

inline Box join(const Box& a, const Box& b) {
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}
inline Box intersect(const Box& a, const Box& b) {
  return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

inline std::array<glm::dvec3, 8> corners(const Box& box) {
  std::array<glm::dvec3, 8> all{};
  for (int i = 0; i < 8; ++i) {
    all[static_cast<std::size_t>(i)] = {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                                        (i & 4) != 0 ? box.max.z : box.min.z};
  }
  return all;
}

/// Beyond this, and for NaN, a length cannot be drawn: floats end soon after, and their squares long before.
inline constexpr double kLargestLength = 1e30;
/// Below this, squares and reciprocals leave the range of floats.
inline constexpr double kSmallestLength = 1e-30;

/// The box around a box seen through an affine matrix; empty when a corner is no usable number.
inline Box transformed(const Box& box, const glm::dmat4& matrix) {
  Box result;
  if (box.empty()) return result;
  for (const glm::dvec3& corner : corners(box)) {
    const glm::dvec3 point(matrix * glm::dvec4(corner, 1.0));
    for (int axis = 0; axis < 3; ++axis) {
      if (!(point[axis] >= -kLargestLength && point[axis] <= kLargestLength)) return {};
    }
    result.min = glm::min(result.min, point);
    result.max = glm::max(result.max, point);
  }
  return result;
}

}  // namespace plugc
