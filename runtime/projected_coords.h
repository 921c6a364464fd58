#pragma once
// Texture coordinates that a light or a viewpoint projects, for shapes whose vertex shader is an author's: it reads them as the
// mesh's own, so they are computed here, vertex by vertex.

#include <optional>
#include <vector>

#include "runtime/gl/mesh.h"
#include "runtime/uniforms.h"

namespace plugc {

/// What the GPU holds of the projected coordinates of one shape, for one program.
struct ProjectedCoords {
  gl::VertexArray vertex_array;
  std::vector<gl::ExtraStream> streams;  ///< As PackedShape::projected_coords.
  /// Object space to coordinates, as the streams were computed with; none: not yet.
  std::vector<std::optional<glm::dmat4>> matrices;
  std::uint32_t version = 0;  ///< LiveMesh::version, likewise.
};

/// Computes them again where the projection, the shape or its vertices have moved. `live`: the mesh, where events change it.
/// `attributes` are those of the program.
void update_projected_coords(const gl::Functions& functions, const gl::Mesh& mesh, const PackedMesh& packed,
                             const LiveMesh* live, const flatbuffers::Vector<const PackedBinding*>& bindings,
                             const gl::Attributes& attributes, const UniformInputs& inputs, ProjectedCoords& coords);

}  // namespace plugc
