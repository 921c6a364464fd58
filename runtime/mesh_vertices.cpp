#include "runtime/mesh_vertices.h"

#include <algorithm>
#include <cstring>

namespace plugc {

const PackedStream* find_stream(const PackedMesh& mesh, PackedSemantic semantic, std::uint32_t unit) {
  for (const PackedStream* stream : *mesh.streams()) {
    if (stream->semantic() == semantic && stream->unit() == unit) return stream;
  }
  return nullptr;
}

glm::vec3 read_vertex(const MeshVertices& vertices, const PackedStream& stream, std::uint32_t vertex) {
  glm::vec3 value(0);
  const std::size_t at = std::size_t{vertex} * vertices.mesh.stride() + stream.offset();
  std::memcpy(&value, vertices.bytes.data() + at, std::min<std::size_t>(stream.components(), 3) * sizeof(float));
  return value;
}

}  // namespace plugc
