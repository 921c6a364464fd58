#pragma once
// Meshes whose vertices events change, as they are now.

#include <cstdint>
#include <span>
#include <vector>

#include "base/box.h"
#include "base/face_normals.h"
#include "package/package_file.h"
#include "runtime/events.h"

namespace plugc {

/// One mesh of the package with the vertices that its slots give it.
struct LiveMesh {
  const PackedLiveMesh* packed = nullptr;
  const PackedMesh* mesh = nullptr;
  std::vector<std::uint8_t> vertices;        ///< As the package lays them out.
  Box bounds;                                ///< Object space.
  std::vector<std::uint64_t> taken;          ///< By feed: Slots::changed_at of what was written; 0: nothing yet.
  std::vector<std::uint32_t> corner_points;  ///< Of made normals: by corner, the first vertex in its place.
  CornersAtPoints corners_at;                ///< The same, by that vertex.
  std::uint32_t version = 0;                 ///< Grows with each change.
};

/// Those of a scene, in the order of their meshes.
struct LiveMeshes {
  std::vector<LiveMesh> list;
  std::uint64_t revision = 0;  ///< Of the slots that they were brought up to date with.

  /// Null for a mesh that nothing changes.
  const LiveMesh* find(std::uint32_t mesh) const;
};

/// With the vertices that the package has.
LiveMeshes make_live_meshes(const Package& package, const PackedScene& scene);

/// Brings all up to date with their slots. True where a position has changed.
bool update_live_meshes(LiveMeshes& meshes, const Slots& slots);

/// The bytes of a mesh's vertices, live or as the package has them.
std::span<const std::uint8_t> vertex_bytes(const PackedMesh& mesh, const LiveMesh* live);

}  // namespace plugc
