#pragma once
// What is bound: the viewpoint, background, fog and NavigationInfo that a scene is seen with (X3D 4.1, 7.2.2).

#include "scene/scene_context.h"

namespace plugc {

/// Finds of which kinds events may bind another; before the walk.
void find_changing_stacks(SceneContext& context);

/// A node where it stands. Those of an Inline are not bound at the start.
void note_bindable(SceneContext& context, NodeId node, int transform, bool may_be_first);

// Once all are known, of a kind that changes.

/// The slot of the number of the one that is bound; -1: none.
std::uint32_t bound_index(SceneContext& context, BindKind kind);
/// The slot of the bound Background's skyColor; what `otherwise` holds while none is bound.
std::uint32_t bound_sky_color(SceneContext& context, std::uint32_t otherwise);
/// A fog with the values of the one that is bound, in units of the first, and in its space where it lies in layers; its index
/// in context.scene.fogs. There is at least one.
int add_changing_fog(SceneContext& context);
/// The headlight, on where the bound NavigationInfo says so, or none is bound. Their `headlightNode`s do not count.
void add_changing_headlight(SceneContext& context);
/// The slot of the bound NavigationInfo's visibilityLimit, also where that does not change; none where nothing can be limited.
/// `first`: the one that is bound at the start, if any.
std::uint32_t visibility_limit(SceneContext& context, NodeId first);

/// Makes the slots that bind nodes, which are what events must reach.
void add_set_bind_slots(SceneContext& context);
/// The stack as an event node, once all of its slots are made.
SceneEventNode make_stack_node(const SceneContext& context, const BindStack& stack);

}  // namespace plugc
