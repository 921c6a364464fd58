#pragma once
// Meshes whose vertices events change, as they are now.

#include <cstdint>
#include <span>
#include <vector>

#include "base/box.h"
#include "package/package_file.h"
#include "runtime/events.h"

namespace plugc {

/// One mesh of the package with the vertices that its slots give it.
struct LiveMesh {
  const PackedLiveMesh* packed = nullptr;
  const PackedMesh* mesh = nullptr;
  std::vector<std::uint8_t> vertices;      ///< As the package lays them out.
  Box bounds;                              ///< Object space.
  std::vector<std::vector<double>> taken;  ///< By feed: what its slot held.
  bool written = false;                    ///< Since somebody last asked: see take_written().
};

/// Those of a scene, in the order of their meshes.
struct LiveMeshes {
  std::vector<LiveMesh> list;

  /// Null for a mesh that nothing changes.
  const LiveMesh* find(std::uint32_t mesh) const;
};

/// With the vertices that the package has.
LiveMeshes make_live_meshes(const Package& package, const PackedScene& scene);

/// Brings all up to date with their slots.
void update_live_meshes(LiveMeshes& meshes, const Slots& slots);

/// The bytes of a mesh's vertices, live or as the package has them.
std::span<const std::uint8_t> vertex_bytes(const PackedMesh& mesh, const LiveMesh* live);

}  // namespace plugc
