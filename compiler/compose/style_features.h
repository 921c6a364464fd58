#pragma once
// Which words of the templates draw lines and faces in the style that a recipe asks for.

#include <string_view>

#include "compose/recipe.h"
#include "compose/templates.h"

namespace plugc {

/// The word of line_type.frag for a type of lines (X3D 4.1, table 12.2); "" for solid ones.
std::string_view line_type_word(int line_type);

/// The words of hatch.frag.
Features hatch_features(const Recipe& recipe);

}  // namespace plugc
