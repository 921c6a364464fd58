#pragma once
// How a texture is looked up, as the package has it.

#include <memory>

#include "package/package_file.h"
#include "scene/scene.h"

namespace plugc {

/// None where no edge shows it, and for one of zeros.
std::unique_ptr<PackedBorder> pack_border(const SceneTexture& texture);

}  // namespace plugc
