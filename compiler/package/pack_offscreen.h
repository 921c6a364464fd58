#pragma once
// What a scene draws beside its picture: the textures that it renders, and its screen effects.

#include <vector>

#include "package/pack_shape.h"

namespace plugc {

void pack_rendered_textures(const Scene& scene, PackedSceneT& packed);

/// An effect whose shader is not valid is left out.
void pack_screen_effects(const SceneParts& parts, const Packed& where, PackedSceneT& packed);

}  // namespace plugc
