// The text of the value is read once more, token by token, up to the number that is asked for. Words that are no boolean do
// not count where the reader left them out; in the text of an attribute every word stands for one number.

#include "document/number_places.h"

#include <algorithm>
#include <array>

#include "document/characters.h"

namespace plugc {
namespace {

struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool is_bracket(char c) {
  return c == '[' || c == ']';
}
bool ends_token(char c) {
  return is_a(c, kSpaceCharacter) || is_bracket(c) || c == '"' || c == '#';
}

std::size_t quoted_end(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

/// The next token from `at` on; empty at the end.
Token next_token(std::string_view text, std::size_t at) {
  for (; at < text.size(); ++at) {
    if (text[at] == '#')
      at = std::min(text.find_first_of("\r\n", at), text.size() - 1);
    else if (!is_a(text[at], kSpaceCharacter) && !is_bracket(text[at]))
      break;
  }
  if (at >= text.size()) return {text.size(), text.size()};
  if (text[at] == '"') return {at, quoted_end(text, at)};
  const auto* end = std::find_if(text.data() + at, text.data() + text.size(), ends_token);
  return {at, static_cast<std::size_t>(end - text.data())};
}

bool counts(std::string_view token) {
  static constexpr std::array<std::string_view, 4> kBooleans = {"TRUE", "FALSE", "true", "false"};
  return is_a(token[0], kNumberStart) || std::find(kBooleans.begin(), kBooleans.end(), token) != kBooleans.end();
}

Token find_number(std::string_view text, std::size_t index, bool every_token) {
  for (Token token = next_token(text, 0); token.begin < token.end; token = next_token(text, token.end)) {
    if (!every_token && !counts(text.substr(token.begin, token.end - token.begin))) continue;
    if (index-- == 0) return token;
  }
  return {};
}

}  // namespace

Span number_span(const ValueSyntax& value, const Document& document, const SourceSet& sources, std::size_t index) {
  if (value.kind == ValueKind::lexical && value.count != 0) {
    const MappedText& text = document.of(value.strings()).front();
    const Token token = find_number(text.text(), index, true);
    const Span place = text.locate(static_cast<std::uint32_t>(token.begin), static_cast<std::uint32_t>(token.end));
    return token.begin < token.end && place.valid() ? place : value.span;
  }
  const Token token = find_number(sources.text(value.span), index, false);
  if (token.begin == token.end) return value.span;
  return {value.span.source, value.span.begin + static_cast<std::uint32_t>(token.begin),
          value.span.begin + static_cast<std::uint32_t>(token.end)};
}

}  // namespace plugc
