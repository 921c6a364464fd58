#pragma once
// Reads the vertices of a mesh, as the package lays them out.

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include "package/package_file.h"

namespace plugc {

/// A mesh with its vertices, which may be live.
struct MeshVertices {
  const PackedMesh& mesh;
  std::span<const std::uint8_t> bytes;
};

/// Null where the mesh has no such stream.
const PackedStream* find_stream(const PackedMesh& mesh, PackedSemantic semantic, std::uint32_t unit = 0);

/// The first three numbers of that vertex in the stream; zero for those that it lacks.
glm::vec3 read_vertex(const MeshVertices& vertices, const PackedStream& stream, std::uint32_t vertex);

}  // namespace plugc
