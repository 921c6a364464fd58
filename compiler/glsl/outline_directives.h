#pragma once
// What an outline takes from directives, markers and stray bytes: all that is not a declaration.

#include <string_view>

#include "glsl/outline.h"

namespace plugc {

/// Fills version, extensions, macros, undefs, markers and problems.
void outline_directives(std::string_view text, const std::vector<Token>& tokens, Outline& outline);

}  // namespace plugc
