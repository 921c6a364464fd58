#pragma once
// Texture coordinates that a light or a viewpoint projects, for shapes whose vertex shader is an author's: it reads them as the
// mesh's own, so they are computed here, vertex by vertex.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/gl/mesh.h"
#include "runtime/messages.h"
#include "runtime/uniforms.h"

namespace plugc {

/// All of a scene together: shapes that share a mesh have coordinates of their own.
inline constexpr std::uint64_t kMaxProjectedBytes = std::uint64_t{2} << 30U;

/// What the GPU holds of the projected coordinates of one shape, for one program.
struct ProjectedCoords {
  gl::VertexArray vertex_array;
  std::vector<gl::ExtraStream> streams;  ///< As PackedShape::projected_coords.
  /// Object space to coordinates, as the streams were computed with; none: not yet.
  std::vector<std::optional<glm::dmat4>> matrices;
  std::uint32_t version = 0;  ///< LiveMesh::version, likewise.
};

struct ProjectedCoordsPool {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::optional<ProjectedCoords>> by_use;  ///< By shape and program.
  std::uint64_t bytes_left = kMaxProjectedBytes;
};

/// Those of a shape in a program, with place for so many units. Null where there is no memory left for them, which is reported.
ProjectedCoords* find_projected_coords(ProjectedCoordsPool& pool, std::pair<std::uint32_t, std::uint32_t> use,
                                       const PackedMesh& mesh, std::uint32_t units, Messages& messages);

/// Computes them again where the projection, the shape or its vertices have moved. `live`: the mesh, where events change it.
/// `attributes` are those of the program.
void update_projected_coords(const gl::Functions& functions, const gl::Mesh& mesh, const PackedMesh& packed,
                             const LiveMesh* live, const flatbuffers::Vector<const PackedBinding*>& bindings,
                             const gl::Attributes& attributes, const UniformInputs& inputs, ProjectedCoords& coords);

}  // namespace plugc
