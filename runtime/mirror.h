#pragma once
// Flat mirrors: what somebody sees in one.

#include <optional>

#include "runtime/world.h"

namespace plugc {

/// A mirror where it stands: a corner, and the sides that meet there. World space.
struct Mirror {
  glm::dvec3 corner{0}, right{0}, up{0};
};
Mirror place_mirror(const PackedWindow& window, const glm::dmat4& object_to_world);

/// The view of the viewer's mirror image, through the mirror, which just fills it. What is nearer to the mirror than `distance`
/// lies before its near plane; its far plane is behind all of `bounds`. From whichever side he looks; nullopt where he sees it
/// edge-on, or where it has no area.
std::optional<View> view_in_mirror(const Mirror& mirror, const View& viewer, double distance, const Box& bounds);

}  // namespace plugc
