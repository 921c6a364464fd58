#pragma once
// How far the viewer sees (X3D 4.1, 23.4.4, NavigationInfo.visibilityLimit).

#include "runtime/world.h"

namespace plugc {

/// In units of the world; 0: as far as there is anything.
double sight_limit(const PackedScene& scene, const Slots& slots);

/// Brings the far plane of a perspective as near as the limit; who draws it then clips depth. False, and the view stays as it
/// is, where the limit is 0 or lies behind all that is seen.
bool limit_sight(View& view, double limit);

}  // namespace plugc
