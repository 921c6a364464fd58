// Strings of JSON and their escapes (RFC 8259, 7).
//
// A string ends at its quote. One that holds a line break, which JSON forbids, goes on when the next quote looks like its
// own (a comma or a closing bracket follows); else its quote was forgotten, and it ends with its line.

#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "document/characters.h"
#include "document/json_scanner.h"

namespace plugc {
namespace {

/// The character of `\n` and its kind.
std::optional<char> simple_escape(char c) {
  switch (c) {
    case '"':
    case '\\':
    case '/': return c;
    case 'b': return '\b';
    case 'f': return '\f';
    case 'n': return '\n';
    case 'r': return '\r';
    case 't': return '\t';
    default: return std::nullopt;
  }
}

/// The code unit of the `\uXXXX` at `at`.
std::optional<std::uint32_t> code_unit(const char* at, const char* end) {
  if (end - at < 6 || at[0] != '\\' || at[1] != 'u') return std::nullopt;
  std::uint32_t unit = 0;
  const auto [behind, error] = std::from_chars(at + 2, at + 6, unit, 16);
  if (error != std::errc() || behind != at + 6) return std::nullopt;
  return unit;
}

bool is_high_surrogate(std::uint32_t unit) {
  return unit >= 0xD800 && unit < 0xDC00;
}
bool is_low_surrogate(std::uint32_t unit) {
  return unit >= 0xDC00 && unit < 0xE000;
}

}  // namespace

JsonScanner::StringExtent JsonScanner::find_string(const char* quote) const {
  const char* line_break = nullptr;
  for (const char* at = quote + 1; at < end_; ++at) {
    if (*at == '"') {
      const char* behind = line_break == nullptr ? at : std::find_if_not(at + 1, end_, is_json_space);
      const bool own = line_break == nullptr || behind == end_ || *behind == ',' || *behind == '}' || *behind == ']';
      return own ? StringExtent{at, true, line_break} : StringExtent{line_break, false, nullptr};
    }
    if (*at == '\\' && at + 1 < end_) {
      ++at;
    } else if (line_break == nullptr && (*at == '\n' || *at == '\r')) {
      line_break = at;
    }
  }
  return {line_break == nullptr ? end_ : line_break, false, nullptr};
}

void JsonScanner::take_string(MappedText& text) {
  const char* const quote = at_;
  const StringExtent string = find_string(quote);
  const char* run = quote + 1;
  const auto append_run = [&](const char* end) { append_with_line_feeds(text, build_.sources, span(run, end)); };
  for (const char* at = run; (at = std::find(at, string.end, '\\')) != string.end;) {
    append_run(at);
    run = at = take_escape(at, string.end, text);
  }
  append_run(string.end);
  finish_token(string.closed ? string.end + 1 : string.end);
  if (!string.closed) {
    mistake(span(quote, quote + 1), "this `\"` begins a string that is not closed");
  } else if (string.line_break != nullptr) {
    mistake(span(string.line_break, string.line_break + 1), "a string may hold no line break; write `\\n`");
  }
}

/// Behind the escape at `at`, which a closing quote or at least one character follows.
const char* JsonScanner::take_escape(const char* at, const char* end, MappedText& text) {
  const char c = at + 1 < end ? at[1] : '\0';
  if (c == 'u') return take_code_unit(at, end, text);
  const std::optional<char> escaped = simple_escape(c);
  if (escaped) {
    text.append_generated({&*escaped, 1}, span(at, at + 2));
    return at + 2;
  }
  build_.mistake(span(at, at + 1), "this `\\` begins no escape of JSON; write `\\\\`");
  text.append({at, 1}, source_, place(at));
  return at + 1;
}

/// `\u00e9`, or a pair such as `\ud83d\ude00` for one character (RFC 8259, 7).
const char* JsonScanner::take_code_unit(const char* at, const char* end, MappedText& text) {
  const std::optional<std::uint32_t> unit = code_unit(at, end);
  const char* behind = unit ? at + 6 : at + 2;
  std::uint32_t code = unit.value_or(0);
  if (is_high_surrogate(code)) {
    if (const auto low = code_unit(behind, end); low && is_low_surrogate(*low)) {
      code = 0x10000 + ((code - 0xD800) << 10) + (*low - 0xDC00);
      behind += 6;
    }
  }
  if (code == 0 || (code >= 0xD800 && code < 0xE000)) {
    constexpr std::uint32_t kReplacement = 0xFFFD;
    build_.mistake(span(at, behind),
                   fmt::format("`{}` is no character", std::string_view(at, static_cast<std::size_t>(behind - at))));
    code = kReplacement;
  }
  std::string character;
  append_utf8(character, code);
  text.append_generated(character, span(at, behind));
  return behind;
}

Name JsonScanner::take_name() {
  const char* const begin = at_;
  if (*begin != '"') {
    finish_token(token_end());
    return {{begin, static_cast<std::size_t>(last_end_ - begin)}, span(last_begin_, last_end_)};
  }
  const StringExtent string = find_string(begin);
  const Span inside = span(begin + 1, string.end);
  const std::string_view written = build_.sources.text(inside);
  if (string.closed && string.line_break == nullptr && written.find('\\') == std::string_view::npos) {
    finish_token(string.end + 1);
    return {written, inside};
  }
  MappedText decoded;
  take_string(decoded);
  return {build_.document.decoded_names.emplace_back(decoded.text()), inside};
}

}  // namespace plugc
