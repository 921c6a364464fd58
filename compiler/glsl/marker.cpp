// A marker is read byte by byte with a cursor that stays inside the comment: the keyword, then for a plug its name and the
// brackets, matched by counting.

#include "glsl/marker.h"

#include <algorithm>

#include "glsl/scan.h"

namespace plugc {
namespace {

constexpr std::string_view kDeclarations = "PLUG-DECLARATIONS";
constexpr std::string_view kPassthrough = "VARYING-PASSTHROUGH-GEOMETRY-SHADERS";

// Walks the inside of one comment.
struct Cursor {
  std::string_view text;  // up to the closing `*/`
  std::uint32_t at = 0;

  bool at_end() const { return at >= text.size(); }
  void skip_space() {
    while (!at_end() && (is_blank(text[at]) || is_line_end(text[at]))) ++at;
  }
  bool take(std::string_view word) {
    if (text.substr(at, word.size()) != word) return false;
    at += static_cast<std::uint32_t>(word.size());
    return true;
  }
  // `word` and nothing else up to the end.
  bool take_alone(std::string_view word) {
    if (!take(word)) return false;
    skip_space();
    return at_end();
  }
};

Cursor inside_comment(std::string_view text, std::uint32_t begin, std::uint32_t end) {
  Cursor cursor{text.substr(0, end - 2), begin + 2};
  cursor.skip_space();
  return cursor;
}

bool take_plug(Cursor& cursor) {
  if (!cursor.take("PLUG")) return false;
  cursor.skip_space();
  return cursor.take(":");
}

void read_name(Cursor& cursor, MarkerWords& words) {
  cursor.skip_space();
  words.name_begin = cursor.at;
  while (!cursor.at_end() && is_identifier_part(cursor.text[cursor.at])) ++cursor.at;
  words.name_end = cursor.at;
}

// The bracketed arguments; false when the brackets are missing or do not match.
bool read_arguments(Cursor& cursor, MarkerWords& words) {
  cursor.skip_space();
  if (!cursor.take("(")) return false;
  words.arguments_begin = words.arguments_end = cursor.at;
  for (std::uint32_t depth = 1; !cursor.at_end(); ++cursor.at) {
    const char c = cursor.text[cursor.at];
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) {
      words.arguments_end = cursor.at++;
      return true;
    }
  }
  return false;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(kBlank), text.size());
  return text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
}

}  // namespace

bool is_marker(std::string_view comment) {
  const Cursor start = inside_comment(comment, 0, static_cast<std::uint32_t>(comment.size()));
  Cursor plug = start;
  Cursor declarations = start;
  Cursor passthrough = start;
  return take_plug(plug) || declarations.take_alone(kDeclarations) || passthrough.take_alone(kPassthrough);
}

MarkerWords read_marker(std::string_view text, const Token& marker) {
  Cursor cursor = inside_comment(text, marker.begin, marker.end);
  MarkerWords words;
  const bool starts_with_plug = text[cursor.at] == 'P';
  if (!take_plug(cursor)) {
    words.kind = starts_with_plug ? MarkerKind::declarations : MarkerKind::varying_passthrough;
    words.well_formed = true;
    words.name_begin = words.name_end = words.arguments_begin = words.arguments_end = marker.begin;
    return words;
  }
  read_name(cursor, words);
  const bool named = words.name_begin < words.name_end && !is_digit(text[words.name_begin]);
  words.arguments_begin = words.arguments_end = cursor.at;
  words.well_formed = named && read_arguments(cursor, words);
  cursor.skip_space();
  words.well_formed = words.well_formed && cursor.at_end();
  return words;
}

std::vector<std::string_view> split_arguments(std::string_view arguments) {
  std::vector<std::string_view> parts;
  if (trim(arguments).empty()) return parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= arguments.size(); ++i) {
    const char c = i < arguments.size() ? arguments[i] : ',';
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (i < arguments.size() && (c != ',' || depth != 0)) continue;
    parts.push_back(trim(arguments.substr(begin, i - begin)));
    begin = i + 1;
  }
  return parts;
}

}  // namespace plugc
