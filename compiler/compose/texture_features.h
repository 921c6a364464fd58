#pragma once
// Which parts of the texture templates a texture of a recipe needs.

#include <vector>

#include "compose/recipe.h"
#include "compose/templates.h"

namespace plugc {

/// Of texture.vert.
Features coordinate_features(const TextureRecipe& texture);
/// Of texture.frag.
Features texture_features(const TextureRecipe& texture, bool first_unit);
/// Of texture_mode.glsl, once for each function that texture.frag then calls: none, one, or one for colour and one for alpha.
std::vector<Features> mode_features(const TextureCombination& combination);
/// Whether texture.frag asks what texture_diffuse.frag keeps.
bool uses_diffuse(const TextureCombination& combination);

}  // namespace plugc
