#pragma once
// The words of CastleScript. Upper and lower case are the same; a comment stands in curly braces.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace plugc {

enum class ScriptTokenKind : std::uint8_t { end, lost, function, name, whole_number, number, text, symbol };

struct ScriptToken {
  ScriptTokenKind kind = ScriptTokenKind::end;
  std::string text;  ///< In lower case; of a text what stands between its apostrophes, as written.
  std::uint32_t begin = 0, end = 0;
};

std::string lower_case(std::string_view name);

/// All tokens and one of the kind `end`; or up to the first character that begins none, which is reported, and one of the kind
/// `lost`.
std::vector<ScriptToken> read_script_tokens(const MappedText& code, Diagnostics& diagnostics);

}  // namespace plugc
