#pragma once
// Matrices of X3D's rotations and Transform nodes, in double.

#include <glm/glm.hpp>

namespace plugc {

/// Object space of a Transform node to its parent's space: T * C * R * SR * S * -SR * -C (X3D 4.1, 10.4.4).
glm::dmat4 transform_matrix(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale,
                            const glm::dvec4& scale_orientation, const glm::dvec3& center);
/// Axis and angle; the identity for a zero axis.
glm::dmat4 rotation_matrix(const glm::dvec4& rotation);

}  // namespace plugc
