#pragma once
// Shadow volumes of the reference engine (`shadowVolumes` and `shadowVolumesMain` of lights, once `kambiShadows` and
// `kambiShadowsMain`), which plugc draws by the means that it has.

#include "scene/node_graph.h"
#include "scene/scene.h"

namespace plugc {

/// Whether some light casts shadow volumes. As in the engine, none does as long as no light is the main one.
bool has_shadow_volumes(const NodeGraph& graph, const Scene& scene);

/// Lights with shadow volumes cast on all shapes, as lights with `shadows TRUE` do.
void cast_for_volumes(const NodeGraph& graph, Scene& scene);

}  // namespace plugc
