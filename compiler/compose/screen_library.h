#pragma once
// What screen effects may ask of the picture: the functions of templates/screen_effect.frag, and its uniforms.

#include <cstdint>
#include <optional>
#include <string_view>

#include "compose/recipe.h"
#include "compose/templates.h"

namespace plugc {

/// What the fragment code of a screen effect's shader names of the library, as far as the pass has it.
Features screen_features(const EffectCode& shader, ScreenPass pass, Target target);

/// What a uniform of the library holds.
enum class ScreenValue : std::uint8_t { color, depth, width, height };
std::optional<ScreenValue> find_screen_value(std::string_view uniform);

}  // namespace plugc
