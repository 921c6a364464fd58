#pragma once
// Meshes as flat mirrors.

#include <optional>

#include "mesh/mesh.h"

namespace plugc {

/// A rectangle: a corner, and the sides that meet there. Object space.
struct MirrorWindow {
  glm::dvec3 corner{0}, right{0}, up{0};
};

/// The smallest upright rectangle around the mesh's faces in the plane that they lie in; where they are not flat, in the plane
/// of their mean direction through their middle. nullopt for a mesh without faces that have an area.
std::optional<MirrorWindow> mirror_window(const Mesh& mesh);

}  // namespace plugc
