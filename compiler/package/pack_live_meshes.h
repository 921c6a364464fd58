#pragma once
// What events change of a scene's meshes.

#include <cstdint>
#include <map>

#include "package/assemble_package.h"

namespace plugc {

/// `indices`: where the meshes of the scene's shapes lie in the package.
void pack_live_meshes(const SceneParts& parts, const std::map<const Mesh*, std::uint32_t>& indices, PackedSceneT& packed);

}  // namespace plugc
