#pragma once
// The event graph of a scene in the package.

#include "package_generated.h"
#include "scene/scene.h"

namespace plugc {

void pack_events(const Scene& scene, PackedSceneT& packed);

}  // namespace plugc
