#pragma once
// Tangents for normal maps.

#include "mesh/mesh.h"

namespace plugc {

/// For each vertex the direction in which `s` of these texture coordinates grows, unit length, at a right angle to the normal;
/// `w` is 1 where `t` grows along cross(normal, tangent) and -1 where it grows against it (glTF 2.0, 3.7.2.1, has the same
/// form). A mesh that is no triangles, or has no normals, gets none. Where the coordinates say nothing any direction along the
/// surface will do.
std::vector<glm::vec4> make_tangents(const Mesh& mesh, const std::vector<glm::vec4>& tex_coords);

}  // namespace plugc
