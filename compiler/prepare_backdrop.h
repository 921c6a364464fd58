#pragma once
// The meshes of the backdrop.

#include "base/diagnostics.h"
#include "mesh/mesh_cache.h"
#include "package/assemble_package.h"
#include "scene/node_graph.h"

namespace plugc {

/// Gives each shape of the backdrop its mesh: none to a side whose picture is missing, so that what is behind it is seen. The
/// textures have their final numbers.
void prepare_backdrop(const NodeGraph& graph, SceneParts& parts, VertexBudget& budget, Diagnostics& diagnostics);

}  // namespace plugc
