#pragma once
// Tangents for normal maps.

#include "mesh/mesh.h"

namespace plugc {

/// Along `s` of these texture coordinates: see vertex_tangents(). A mesh that is no triangles, or has no normals, gets none.
std::vector<glm::vec4> make_tangents(const Mesh& mesh, const std::vector<glm::vec4>& tex_coords);

}  // namespace plugc
