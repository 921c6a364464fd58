#include "runtime/live_meshes.h"

#include <algorithm>

namespace plugc {

const LiveMesh* LiveMeshes::find(std::uint32_t mesh) const {
  const auto found = std::ranges::lower_bound(list, mesh, {}, [](const LiveMesh& one) { return one.packed->mesh(); });
  return found == list.end() || found->packed->mesh() != mesh ? nullptr : &*found;
}

std::span<const std::uint8_t> vertex_bytes(const PackedMesh& mesh, const LiveMesh* live) {
  if (live != nullptr) return live->vertices;
  return {mesh.vertices()->data(), mesh.vertices()->size()};
}

}  // namespace plugc
