#pragma once
// The meshes of a compilation, each once: a geometry node that several shapes USE is turned into triangles once, and nodes that
// come to the same triangles, as the boxes of a modelling tool do, share them.

#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/limits.h"
#include "mesh/mesh.h"
#include "mesh/unit_coords.h"

namespace plugc {

struct MeshCache {
  /// By geometry node and by what its texture units read; null where the node has nothing to draw.
  std::map<std::pair<NodeId, std::vector<UnitCoords>>, std::shared_ptr<const Mesh>> by_node;
  std::unordered_multimap<std::size_t, std::shared_ptr<const Mesh>> by_content;  ///< By a hash of positions and indices.
  std::size_t vertices_left = kMaxSceneVertices;
  bool is_full = false;  ///< A mesh was left out: all new ones are.
};

/// The mesh as the cache has it; one that is new to it is added. One with vertices that events change is its own. Null where
/// that would be too many vertices, and for every new mesh from there on; the first is reported, at the place of its geometry.
std::shared_ptr<const Mesh> share_mesh(MeshCache& cache, Mesh mesh, const Span& geometry, Diagnostics& diagnostics);

}  // namespace plugc
