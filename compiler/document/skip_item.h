#pragma once
// Passing over what a scanner stands at; the same for all encodings with brackets.

#include <cstddef>

namespace plugc {

/// Skips one token, or a bracket with all that it holds. Depth is counted, so that no nesting exhausts the stack; a bracket
/// may be closed by one of the other kind, as broken texts have it.
template <typename Scanner>
void skip_item_of(Scanner& scan) {
  std::size_t depth = 0;
  do {
    const char c = scan.next();
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    scan.take_token();
  } while (depth > 0 && !scan.at_end());
}

}  // namespace plugc
