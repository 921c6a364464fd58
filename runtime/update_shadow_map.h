#pragma once
// Which shadow maps a frame needs, and which of them must be drawn for it.

#include <cstdint>

#include "runtime/loaded_scene.h"

namespace plugc {

/// Decides whether map `index` is in use in a view seen by `camera` (`all_around`: by whoever looks), and what its light sees
/// then. True when its content must be drawn anew: never for a map that nobody visible looks into, that nothing casts into
/// where it is looked at, or whose content would come out as it is.
bool update_shadow_map(LoadedScene& scene, std::uint32_t index, const View& camera, Messages& messages);

}  // namespace plugc
