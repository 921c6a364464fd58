#pragma once
// The scene at a time: events, then where everything is, then what the viewer's place sets off.

#include <functional>

#include "runtime/loaded_scene.h"

namespace plugc {

/// Lets everything happen up to `time` and places it; how it is seen then. `look` makes the camera of a placed scene, which
/// looks through the viewpoint of that index (-1: through none). Sensors see the camera of the moment when the scene was
/// loaded, too.
View reach_time(LoadedScene& scene, double time, std::int32_t viewpoint, const std::function<View()>& look);

}  // namespace plugc
