// glslang knows lines, not columns. Where a column has been found all the same it counts. Else the token that glslang quotes
// is looked for among the tokens of that line, and the first that is it is taken. Where it does not stand there (a macro has
// made it) the line is meant, without the white space around it. A linker's message has no line, but often a name: its first
// occurrence in the whole text is the declaration that is meant.

#include "validate/place_message.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "glsl/qualifiers.h"
#include "glsl/scan.h"

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

/// Whether glslang means a token by a name that is not written.
bool is_meant(std::string_view text, std::span<const Token> tokens, std::size_t i, std::string_view name) {
  const std::string_view word = token_text(text, tokens[i]);
  if (name == "constructor") return is_basic_type(word) && i + 1 < tokens.size() && token_text(text, tokens[i + 1]) == "(";
  constexpr std::string_view kComparisons[] = {"==", "!=", "<=", ">="};
  return name == "assign" && word.ends_with('=') && std::ranges::find(kComparisons, word) == std::end(kComparisons);
}

/// The only token that is meant by a name; `range` itself when there are none or several.
Range find_meant(std::string_view text, std::span<const Token> tokens, std::string_view name, const Range& range) {
  Range found = range;
  std::size_t count = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (is_meant(text, tokens, i, name) && ++count == 1) found = {tokens[i].begin, tokens[i].end};
  }
  return count == 1 ? found : range;
}

/// The token's first occurrence in `range`; `range` itself when there is none.
Range find_token(std::string_view text, std::string_view token, const Range& range) {
  if (token.empty()) return range;
  const auto tokens = scan_range(text, static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.end));
  const auto found = std::ranges::find_if(tokens, [&](const Token& each) { return token_text(text, each) == token; });
  if (found != tokens.end()) return {found->begin, found->end};
  const std::size_t begin = text.find(token, range.begin);  // several tokens, as `#version`
  const bool stands = begin < range.end && begin + token.size() <= range.end && !is_identifier_start(token.front());
  return stands ? Range{begin, begin + token.size()} : find_meant(text, tokens, token, range);
}

/// The `}` of the function whose head begins in the line, where a function that returns nothing has come to its end.
Range end_of_function(std::string_view text, const Range& line) {
  std::size_t open = 0;
  for (const Token& token : scan_range(text, static_cast<std::uint32_t>(line.begin), static_cast<std::uint32_t>(text.size()))) {
    const std::string_view word = token_text(text, token);
    if (word == "{") ++open;
    if (word == "}" && open > 0 && --open == 0) return {token.begin, token.end};
    if (word == ";" && open == 0) break;
  }
  return line;
}

Range meant_range(std::string_view text, const VerdictMessage& message) {
  if (message.column != 0) {
    const std::size_t begin = line_range(text, message.line).begin + message.column - 1;
    return {begin, begin + message.token.size()};
  }
  if (message.line != 0 && message.text.find("function does not return a value") != std::string::npos)
    return end_of_function(text, trimmed(text, line_range(text, message.line)));
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
