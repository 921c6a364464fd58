#pragma once
// Texture coordinates that a light or a viewpoint projects, for shapes whose vertex shader is an author's: it reads them as the
// mesh's own, so they are computed here, vertex by vertex.

#include <vector>

#include "runtime/gl/mesh.h"
#include "runtime/uniforms.h"

namespace plugc {

/// What the GPU holds of one shape's projected coordinates.
struct ProjectedCoords {
  gl::VertexArray vertex_array;
  std::vector<gl::ExtraStream> streams;  ///< As PackedShape::projected_coords.
  std::vector<glm::dmat4> matrices;      ///< Object space to coordinates, as the streams were computed with.
};

/// Computes them again where the projection or the shape has moved. `attributes` are those of the shape's program.
void update_projected_coords(const gl::Functions& functions, const gl::Mesh& mesh, const PackedMesh& packed,
                             const flatbuffers::Vector<const PackedBinding*>& bindings, const gl::Attributes& attributes,
                             const UniformInputs& inputs, ProjectedCoords& coords);

}  // namespace plugc
