#pragma once
// What a scene draws beside its picture: the textures that it renders, and its screen effects.

#include <vector>

#include "package/assemble_package.h"

namespace plugc {

void pack_rendered_textures(const Scene& scene, PackedSceneT& packed);

/// `programs` and `textures`: where those of the scene lie in the package (UINT32_MAX: nowhere). An effect whose shader is not
/// valid is left out.
void pack_screen_effects(const SceneParts& parts, const std::vector<std::uint32_t>& programs,
                         const std::vector<std::uint32_t>& textures, PackedSceneT& packed);

}  // namespace plugc
