#pragma once
// The event graph of a scene as plain data.

#include "scene/scene_context.h"

namespace plugc {

/// Fills the scene's event_nodes and routes, once everything that is drawn has its slots: only what reaches these is kept.
/// Events that would change something drawn, but are not evaluated, are reported.
void read_events(SceneContext& context);

/// Whether what sends from there is a node whose events plugc does not make, though they would come without anybody's hand.
bool is_unmade(const NodeGraph& graph, const Scripts& scripts, const EventField& field);

}  // namespace plugc
