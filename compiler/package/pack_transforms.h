#pragma once
// A scene's transforms in the package, with what turns or hides them.

#include "package/package_file.h"
#include "scene/scene.h"

namespace plugc {

/// Those of things and those of texture coordinates, in the order of the scene's lists.
void pack_transforms(const Scene& scene, PackedSceneT& packed);

}  // namespace plugc
