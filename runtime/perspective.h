#pragma once
// The projection of a Viewpoint.

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace plugc {

inline constexpr double kDefaultFieldOfView = std::numbers::pi / 4;  // X3D 4.1, 23.4.6

/// `field` is the smaller of both ways, in radians, or, where it `is_vertical`, the height; `aspect` is width / height.
inline glm::dmat4 perspective(double field, double aspect, double near, double far, bool is_vertical = false) {
  double half_height = std::tan(field / 2);
  if (aspect < 1 && !is_vertical) half_height /= aspect;
  return glm::frustum(-near * half_height * aspect, near * half_height * aspect, -near * half_height, near * half_height, near,
                      far);
}

}  // namespace plugc
