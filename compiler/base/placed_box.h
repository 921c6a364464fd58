#pragma once
// Boxes as shapes have them: each in a space of its own.

#include <optional>

#include "base/box.h"

namespace plugc {

/// A box in a space of its own: seen from a light it is fitted tighter than the world's box around it.
struct PlacedBox {
  Box box;
  glm::dmat4 to_world{1.0};
  bool known = true;  ///< False: its shape may leave it.
};

/// What is flatter has no thickness of its own, relative to its size or its distance.
inline constexpr double kThinnest = 1e-6;

/// The plane of a flat box, as a vector whose product with vec4(point, 1) is the distance in front: on the side of the light,
/// which is a direction towards it (w 0) or a place (w 1). None for a box that is not flat, or whose shape may leave it.
std::optional<glm::dvec4> front_of(const PlacedBox& placed, const glm::dvec4& light);

}  // namespace plugc
