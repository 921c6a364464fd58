#pragma once
// Convex solids, and where several of them overlap: how much of a box is in view, or in a light's cone.

#include <span>
#include <vector>

#include "base/box.h"

namespace plugc {

/// May be open towards infinity (a view without its far end): then it lacks the planes there, and its faces end somewhere.
struct Hull {
  std::vector<std::vector<glm::dvec3>> faces;  ///< Convex, flat, in either winding.
  std::vector<glm::dvec4> planes;              ///< Inside: dot(plane, vec4(point, 1)) >= 0.
  bool flat = false;                           ///< Has no inside, so nothing's face can end in it.
};

/// A box in a space of its own, which `matrix` takes to that of the hull. Without faces when it is no usable box.
Hull hull_of(const Box& box, const glm::dmat4& matrix);

/// What a projection shows between its left, right, lower and upper planes, from the eye on (orthographic: from its near plane
/// on). Faces end at the far plane.
Hull view_hull(const glm::dmat4& world_to_eye, const glm::dmat4& projection);

/// The corners of what all hulls have in common; none when that is nothing.
std::vector<glm::dvec3> common_points(std::span<const Hull* const> hulls);

}  // namespace plugc
