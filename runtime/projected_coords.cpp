// s, t, r and q are what the projector's matrix makes of the vertex, undivided, so that they may be interpolated.

#include "runtime/projected_coords.h"

#include <utility>

#include "runtime/mesh_vertices.h"

namespace plugc {
namespace {

/// Zeros for a mesh without positions, which is drawn like any other.
std::vector<float> project(const MeshVertices& vertices, const glm::dmat4& to_coords) {
  std::vector<float> values(std::size_t{vertices.mesh.vertex_count()} * 4);
  const PackedStream* const stream = find_stream(vertices.mesh, PackedSemantic::position);
  if (stream == nullptr) return values;
  for (std::uint32_t i = 0; i < vertices.mesh.vertex_count(); ++i) {
    const glm::dvec4 coord = to_coords * glm::dvec4(read_vertex(vertices, *stream, i), 1);
    for (std::uint32_t c = 0; c < 4; ++c) values[std::size_t{i} * 4 + c] = finite_float(coord[static_cast<int>(c)]);
  }
  return values;
}

void make_streams(const gl::Functions& functions, const gl::Mesh& mesh, const PackedMesh& packed,
                  const flatbuffers::Vector<const PackedBinding*>& bindings, const gl::Attributes& attributes,
                  ProjectedCoords& coords) {
  for (const PackedBinding* binding : bindings)
    coords.streams.push_back({PackedSemantic::tex_coord, binding->uniform(), gl::make_stream_buffer(functions)});
  coords.matrices.resize(coords.streams.size());
  coords.vertex_array = gl::make_vertex_array(functions, mesh, packed, coords.streams, attributes);
}

}  // namespace

ProjectedCoords* find_projected_coords(ProjectedCoordsPool& pool, std::pair<std::uint32_t, std::uint32_t> use,
                                       const PackedMesh& mesh, std::uint32_t units, Messages& messages) {
  const auto [found, added] = pool.by_use.try_emplace(use);
  std::optional<ProjectedCoords>& coords = found->second;
  if (!added) return coords ? &*coords : nullptr;
  const std::uint64_t bytes = std::uint64_t{mesh.vertex_count()} * units * sizeof(glm::vec4);
  if (bytes > pool.bytes_left) {
    messages.add("the scene's projected texture coordinates need more memory than they get: the last are not projected");
    return nullptr;
  }
  pool.bytes_left -= bytes;
  return &coords.emplace();
}

void update_projected_coords(const gl::Functions& functions, const gl::Mesh& mesh, const PackedMesh& packed,
                             const LiveMesh* live, const flatbuffers::Vector<const PackedBinding*>& bindings,
                             const gl::Attributes& attributes, const UniformInputs& inputs, ProjectedCoords& coords) {
  if (!coords.vertex_array) make_streams(functions, mesh, packed, bindings, attributes, coords);
  const std::uint32_t version = live == nullptr ? 0 : live->version;
  const bool same_vertices = std::exchange(coords.version, version) == version;
  for (std::size_t i = 0; i < coords.streams.size(); ++i) {
    const glm::dmat4 to_coords =
        projector_matrix(*bindings.Get(static_cast<std::uint32_t>(i)), inputs) * inputs.object_to_world;
    if (same_vertices && coords.matrices[i] == to_coords) continue;
    gl::write_stream(functions, coords.streams[i].buffer, project({packed, vertex_bytes(packed, live)}, to_coords));
    coords.matrices[i] = to_coords;
  }
}

}  // namespace plugc
