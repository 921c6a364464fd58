#pragma once
// The scene at a time: events, then where everything is, then what the viewer's place sets off.

#include <functional>
#include <string>

#include "runtime/loaded_scene.h"

namespace plugc {

/// Lets everything happen up to `time` and places it; how it is seen then. `look` makes the camera of a placed scene, which
/// looks through the viewpoint that bound_viewpoint() says for `wanted`. Sensors see the camera of the moment when the scene
/// was loaded, too.
View reach_time(LoadedScene& scene, double time, const std::string& wanted, const std::function<View()>& look);

}  // namespace plugc
