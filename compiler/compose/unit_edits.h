#pragma once
// The edits of one unit's text, collected and applied at the end, so that what is not edited keeps its place byte for byte.
// Removed ranges never overlap: a removal that meets an earlier one is dropped (that happens in broken code only, which
// glslang then reports), and nothing else is edited inside of them. Internal to the compose room.

#include <string>
#include <string_view>
#include <vector>

#include "glsl/edit.h"
#include "glsl/outline.h"

namespace plugc {

class UnitEdits {
 public:
  explicit UnitEdits(std::string_view text) : text_(text) {}

  /// Puts `replacement` in the place of a range; dropped where that meets an earlier one.
  void replace(std::uint32_t begin, std::uint32_t end, std::string replacement);
  /// Removes a range, and the whole line when nothing else stands on it.
  void remove_lines(std::uint32_t begin, std::uint32_t end);
  void insert(std::uint32_t place, std::string text, const Span& origin = {});
  /// Another name for a token, which nothing else touches.
  void rename(const Token& token, std::string_view name);

  /// The removed range that holds the offset; null where it stays. Until the next removal.
  const TextRange* removed_at(std::uint32_t offset) const;
  bool is_removed(std::uint32_t offset) const { return removed_at(offset) != nullptr; }

  /// All of it; nothing is left here.
  std::vector<Edit> take() { return std::move(edits_); }

 private:
  using Removed = std::vector<TextRange>::const_iterator;
  Removed behind(std::uint32_t offset) const;

  std::string_view text_;
  std::vector<Edit> edits_;
  std::vector<TextRange> removed_;  // in text order
};

}  // namespace plugc
