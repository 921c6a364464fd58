#pragma once
// Rotations as X3D has them, axis and angle in radians, to and from unit quaternions.

#include <cmath>
#include <span>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace plugc {

/// Of four numbers. An axis of no length turns nothing.
inline glm::dquat to_quaternion(std::span<const double> rotation) {
  const glm::dvec3 axis(rotation[0], rotation[1], rotation[2]);
  const double length = glm::length(axis);
  return length > 0 && std::isfinite(length) ? glm::angleAxis(rotation[3], axis / length) : glm::dquat(1, 0, 0, 0);
}

inline std::vector<double> axis_and_angle(const glm::dquat& rotation) {
  const glm::dquat unit = glm::normalize(rotation);
  const glm::dvec3 axis = glm::axis(unit);
  return {axis.x, axis.y, axis.z, glm::angle(unit)};
}

}  // namespace plugc
