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

/// What all meshes of a compilation may have together.
struct VertexBudget {
  std::size_t left = kMaxSceneVertices;
  bool spent = false;  ///< Something was refused: all that comes after it is.
};

/// Takes the vertices of one more mesh. False where they are too many, and ever after; the first time is reported, at the place
/// of the geometry.
bool take_vertices(VertexBudget& budget, std::size_t count, const Span& geometry, Diagnostics& diagnostics);

struct MeshCache {
  /// By geometry node and by what its texture units read; null where the node has nothing to draw.
  std::map<std::pair<NodeId, std::vector<UnitCoords>>, std::shared_ptr<const Mesh>> by_node;
  std::unordered_multimap<std::size_t, std::shared_ptr<const Mesh>> by_content;  ///< By a hash of positions and indices.
  /// By a mesh and the unit whose coordinates its tangents follow; null where they are left out.
  std::map<std::pair<std::shared_ptr<const Mesh>, std::size_t>, std::shared_ptr<const Mesh>> with_tangents;
  VertexBudget budget;
};

/// The mesh as the cache has it; one that is new to it is added. One with vertices that events change is its own. Null for a
/// new one where the budget is spent.
std::shared_ptr<const Mesh> share_mesh(MeshCache& cache, Mesh mesh, const Span& geometry, Diagnostics& diagnostics);

}  // namespace plugc
