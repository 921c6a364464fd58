// s, t, r and q are what the projector's matrix makes of the vertex, undivided, so that they may be interpolated.

#include "runtime/projected_coords.h"

#include <cstring>
#include <utility>

namespace plugc {
namespace {

glm::dvec3 vertex_position(const PackedMesh& mesh, std::span<const std::uint8_t> vertices, const PackedStream& stream,
                           std::uint32_t vertex) {
  float position[3] = {0, 0, 0};
  std::memcpy(position, vertices.data() + std::size_t{vertex} * mesh.stride() + stream.offset(),
              sizeof(float) * std::min<std::size_t>(stream.components(), 3));
  return {position[0], position[1], position[2]};
}

std::vector<float> project(const PackedMesh& mesh, std::span<const std::uint8_t> vertices, const glm::dmat4& to_coords) {
  std::vector<float> values;
  for (const PackedStream* stream : *mesh.streams()) {
    if (stream->semantic() != PackedSemantic::position) continue;
    values.reserve(std::size_t{mesh.vertex_count()} * 4);
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
      const glm::dvec4 coord = to_coords * glm::dvec4(vertex_position(mesh, vertices, *stream, i), 1);
      for (int c = 0; c < 4; ++c) values.push_back(finite_float(coord[c]));
    }
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
    gl::write_stream(functions, coords.streams[i].buffer, project(packed, vertex_bytes(packed, live), to_coords));
    coords.matrices[i] = to_coords;
  }
}

}  // namespace plugc
