#include "mesh/tangents.h"

#include "base/vertex_tangents.h"

namespace plugc {

std::vector<glm::vec4> make_tangents(const Mesh& mesh, const std::vector<glm::vec4>& tex_coords) {
  if (mesh.topology != Topology::triangles || mesh.normals.empty()) return {};
  return vertex_tangents({mesh.indices, mesh.positions, mesh.normals, tex_coords});
}

}  // namespace plugc
