#pragma once
// A library is a file with effects and no shape. Each of its effects is placed alone on the shapes of library_stage.h: on the
// shapes themselves, on their light or on their texture, as it stands in the file.

#include <vector>

#include "scene/scene_context.h"

namespace plugc {

/// Every effect that the scene's own files hold, also in prototypes that nothing uses, in their order.
std::vector<NodeId> library_effects(const NodeGraph& graph);

/// The roots of the appended stage.
std::vector<NodeId> library_stage_roots(const NodeGraph& graph);

/// Puts SceneOptions::alone where it belongs; the stage has been walked and its lights are numbered.
void place_alone(SceneContext& context);

}  // namespace plugc
