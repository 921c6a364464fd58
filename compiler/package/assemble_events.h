#pragma once
// The event graph of a scene in the package.

#include "package/source_list.h"
#include "package_generated.h"
#include "scene/scene.h"

namespace plugc {

void pack_events(const Scene& scene, SourceList& sources, PackedSceneT& packed);

}  // namespace plugc
