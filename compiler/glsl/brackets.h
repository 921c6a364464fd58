#pragma once
// Which bracket closes which, for a whole text at once, so that everything behind can jump instead of recursing.

#include <cstdint>
#include <string_view>
#include <vector>

#include "glsl/outline.h"

namespace plugc {

/// Tokens of code only: no directives, no markers, nothing invalid, no bracket that closes nothing.
struct BracketedCode {
  std::vector<Token> tokens;
  /// For an opening bracket the index of the one that closes it, or of the last token inside when none does. Else 0.
  std::vector<std::uint32_t> closing;
};

/// Reports brackets without a partner, and nesting beyond kMaxExpressionNesting: the code is cut there. `outline` has its
/// macros by now.
BracketedCode match_brackets(std::string_view text, const std::vector<Token>& tokens, Outline& outline);

}  // namespace plugc
