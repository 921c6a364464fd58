#pragma once
// The marker comments: `/* PLUG: name (arguments) */`, `/* PLUG-DECLARATIONS */` and
// `/* VARYING-PASSTHROUGH-GEOMETRY-SHADERS */`. White space is free everywhere between the words.

#include <cstdint>
#include <string_view>
#include <vector>

#include "glsl/outline.h"

namespace plugc {

/// Whether a comment, `/*` and `*/` included, means to be a marker: it begins with `PLUG:` or is one of the other two.
bool is_marker(std::string_view comment);

/// Where a marker's words stand, as offsets into the text.
struct MarkerWords {
  MarkerKind kind = MarkerKind::plug;
  bool well_formed = false;  ///< A plug marker has a name and closed brackets, and nothing behind them.
  std::uint32_t name_begin = 0, name_end = 0;
  std::uint32_t arguments_begin = 0, arguments_end = 0;  ///< Between the brackets, as written.
};

/// `marker` is a token of that kind.
MarkerWords read_marker(std::string_view text, const Token& marker);

/// The arguments of a marker, split at the commas outside of brackets, without blanks around them.
std::vector<std::string_view> split_arguments(std::string_view arguments);

}  // namespace plugc
