#pragma once
// Which slots, variables and functions belong to the fields of a Script.

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <utility>
#include <vector>

#include "package/package_file.h"

namespace plugc {

/// Made once a Script, so that an event costs what hangs on it, however many fields there are. All lists are sorted.
struct ScriptFields {
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;  ///< The field of `initialize`.

  Pairs fields;     ///< A slot, and a field that it feeds.
  Pairs variables;  ///< A field, and the variable that holds it.
  Pairs functions;  ///< A field, and a function that answers it.

  /// What stands beside `first`.
  static auto beside(const Pairs& pairs, std::uint32_t first) {
    return std::ranges::equal_range(pairs, first, {}, &Pairs::value_type::first) | std::views::values;
  }
};

/// The node is a Script.
ScriptFields find_script_fields(const PackedEventNode& node);

/// Whether the Script does anything when an event reaches that field.
bool script_listens(const ScriptFields& fields, std::uint32_t field);

}  // namespace plugc
