#pragma once
// The preprocessor's view of a text: which macros are defined at a place, and what `#if` makes of them.
// Source: GLSL 4.60 specification, clause 3.3.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/tokens.h"

namespace plugc {

/// One token of a condition, with the text it came from.
struct ConditionWord {
  TokenKind kind = TokenKind::invalid;
  std::string_view text;
};

/// Points into the texts it is given.
class MacroTable {
 public:
  /// `__VERSION__` is 330 unless it is among them.
  explicit MacroTable(std::span<const MacroDefinition> predefined);

  void define(std::string_view name, std::string_view value, bool has_parameters);
  void undefine(std::string_view name) { macros_.erase(name); }
  bool is_defined(std::string_view name) const { return macros_.contains(name); }

  /// The value of `#if expression`; nothing when it has none (bad syntax, a division by zero, a macro with parameters).
  /// All conditions of one text share one budget of expanded bytes; once it is spent, no condition has a value.
  std::optional<std::int64_t> evaluate(std::string_view expression);

 private:
  struct Macro {
    std::string_view value;
    bool has_parameters = false;
    bool expanding = false;
  };
  bool spend(std::size_t bytes);
  bool expand(std::string_view expression, std::uint32_t depth);
  bool expand_identifier(std::string_view name, std::uint32_t depth);

  std::unordered_map<std::string_view, Macro> macros_;
  std::vector<ConditionWord> words_;
  std::size_t budget_;  ///< Bytes that may still be expanded.
};

}  // namespace plugc
