#pragma once
// What shader code grows to in a compiler. Small texts can stand for huge ones: macros that use each other twice double at
// each step; and an expression of tens of thousands of terms ends a compiler that walks it by recursion.

#include <cstddef>
#include <optional>
#include <string_view>

#include "glsl/outline.h"

namespace plugc {

/// Where code becomes more than a compiler is given: the place and why. `tokens` are those of the text.
struct SizeProblem {
  std::uint32_t begin = 0, end = 0;
  std::string message;
};
std::optional<SizeProblem> find_size_problem(std::string_view text, const TokenList& tokens);

}  // namespace plugc
