#pragma once
// Fogs that take each other's place: those that events bind, and those that rendered textures have in place of the world's.

#include "scene/scene_context.h"

namespace plugc {

/// Whether its visibilityRange lets the fog be seen, now or later.
bool may_show(const SceneContext& context, NodeId fog);

/// The world's shapes have one program each, with the depth of a plain fog or of one in layers: reports a fog that is drawn as
/// the other of the two.
void report_other_depth(SceneContext& context, NodeId fog, bool volumetric);

}  // namespace plugc
