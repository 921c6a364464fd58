#pragma once
// The parameters of a function, from the tokens between its brackets.

#include <span>
#include <string_view>
#include <vector>

#include "glsl/outline.h"

namespace plugc {

std::vector<Parameter> read_parameters(std::string_view text, std::span<const Token> tokens);

}  // namespace plugc
