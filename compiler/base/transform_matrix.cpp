#include "base/transform_matrix.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace plugc {

glm::dmat4 rotation_matrix(const glm::dvec4& rotation) {
  const glm::dvec3 axis(rotation);
  const double length = glm::length(axis);
  if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(rotation.w)) return glm::dmat4(1.0);
  return glm::rotate(glm::dmat4(1.0), rotation.w, axis / length);
}

glm::dmat4 transform_matrix(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale,
                            const glm::dvec4& scale_orientation, const glm::dvec3& center) {
  const glm::dmat4 stretch = rotation_matrix(scale_orientation);
  const glm::dmat4 one(1.0);
  return glm::translate(one, translation + center) * rotation_matrix(rotation) * stretch * glm::scale(one, scale) *
         glm::transpose(stretch) * glm::translate(one, -center);
}

}  // namespace plugc
