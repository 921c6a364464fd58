// glslang knows lines, not columns. The token that it quotes is looked for in that line, as a whole word where it is one;
// the first occurrence is taken. Where it does not stand there (a macro, an operator under another name) the line is
// meant, without the white space around it. A linker's message has no line, but often a name: its first occurrence in the
// whole text is the declaration that is meant.

#include "validate/place_message.h"

#include <algorithm>

namespace plugc {
namespace {

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The bytes of a line, from 1, without its end; an empty range at the end of the text when there is no such line.
Range line_range(std::string_view text, std::uint32_t line) {
  std::size_t begin = 0;
  for (std::uint32_t i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return {text.size(), text.size()};
    begin = end + 1;
  }
  return {begin, std::min(text.find('\n', begin), text.size())};
}

Range trimmed(std::string_view text, Range range) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (range.begin < range.end && is_space(text[range.begin])) ++range.begin;
  while (range.begin < range.end && is_space(text[range.end - 1])) --range.end;
  return range;
}

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Whether a word would go on behind or before the bytes of `found`.
bool cuts_word(std::string_view text, const Range& found) {
  const bool before = found.begin > 0 && is_word(text[found.begin - 1]) && is_word(text[found.begin]);
  const bool behind = found.end < text.size() && is_word(text[found.end]) && is_word(text[found.end - 1]);
  return before || behind;
}

/// The token's first occurrence in `range`; `range` itself when there is none.
Range find_token(std::string_view text, std::string_view token, const Range& range) {
  if (token.empty()) return range;
  for (std::size_t begin = text.find(token, range.begin); begin < range.end; begin = text.find(token, begin + 1)) {
    const Range found{begin, begin + token.size()};
    if (found.end <= range.end && !cuts_word(text, found)) return found;
  }
  return range;
}

Range meant_range(std::string_view text, const VerdictMessage& message) {
  if (message.line != 0) return find_token(text, message.token, trimmed(text, line_range(text, message.line)));
  const Range whole{0, text.size()};
  const Range found = find_token(text, message.token, whole);
  return found.begin == whole.begin && found.end == whole.end ? Range{} : found;
}

}  // namespace

ShaderMessage place_message(const VerdictMessage& message, const ProgramText& program) {
  ShaderMessage placed;
  placed.stage = message.stage;
  placed.line = message.line;
  placed.text = message.text;
  const auto stage = std::ranges::find(program.stages, message.stage, &StageText::stage);
  if (stage == program.stages.end()) return placed;
  const Range range = meant_range(stage->text.text(), message);
  placed.begin = static_cast<std::uint32_t>(range.begin);
  placed.end = static_cast<std::uint32_t>(range.end);
  if (range.begin < range.end) placed.span = stage->text.locate(placed.begin, placed.end);
  return placed;
}

}  // namespace plugc
