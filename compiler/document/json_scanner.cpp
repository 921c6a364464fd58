// Brackets are opened and left one by one, so that a closing bracket of the wrong kind tells which of two mistakes was made:
// when one of its kind is open further out, the inner bracket was not closed; otherwise it is one too many.

#include "document/json_scanner.h"

#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "document/scan_number.h"
#include "document/skip_item.h"

namespace plugc {
namespace {

bool is_structural(char c) {
  return c == '{' || c == '}' || c == '[' || c == ']' || c == ':' || c == ',' || c == '"';
}

bool ends_word(char c) {
  return is_json_space(c) || is_structural(c) || c == '/';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether a text that std::from_chars took is a number of JSON, which has no `1.`, `.5`, `01` and `inf` (RFC 8259, 6).
bool is_json_number(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  if (text.empty() || !is_digit(text[0])) return false;
  if (text[0] == '0' && text.size() > 1 && is_digit(text[1])) return false;
  const std::size_t point = text.find('.');
  return point == std::string_view::npos || (point + 1 < text.size() && is_digit(text[point + 1]));
}

}  // namespace

JsonScanner::JsonScanner(DocumentBuilder& builder) : build_(builder), source_(builder.document.source) {
  const std::string_view text = builder.sources.text(source_);
  begin_ = text.data();
  end_ = begin_ + text.size();
  at_ = text.starts_with("\xEF\xBB\xBF") ? begin_ + 3 : begin_;
  last_begin_ = last_end_ = at_;
  skip_space();
}

// Tokens

bool JsonScanner::begins_value() const {
  const char c = next();
  return at_ != end_ && c != '}' && c != ']' && c != ':' && c != ',';
}

bool JsonScanner::next_is_number() const {
  const char c = next();
  return is_digit(c) || c == '-' || c == '+' || c == '.';
}

std::string_view JsonScanner::peek_word() const {
  if (at_ == end_ || is_structural(*at_)) return "";
  return {at_, static_cast<std::size_t>(token_end() - at_)};
}

const char* JsonScanner::token_end() const {
  if (at_ == end_) return end_;
  if (*at_ == '"') {
    const StringExtent string = find_string(at_);
    return string.closed ? string.end + 1 : string.end;
  }
  return is_structural(*at_) ? at_ + 1 : std::find_if(at_ + 1, end_, ends_word);
}

std::string JsonScanner::describe_next() const {
  if (at_end()) return "the end of the file";
  if (next() == '"') return "a string";
  return described({at_, static_cast<std::size_t>(token_end() - at_)});
}

bool JsonScanner::take(char c) {
  if (at_ == end_ || *at_ != c) return false;
  finish_token(at_ + 1);
  return true;
}

void JsonScanner::finish_token(const char* token_end) {
  last_begin_ = at_;
  last_end_ = at_ = token_end;
  skip_space();
}

void JsonScanner::skip_space() {
  while (at_ != end_ && is_json_space(*at_)) ++at_;
  if (at_ != end_ && *at_ == '/') skip_comments();
}

void JsonScanner::skip_comments() {
  for (;;) {
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    const bool block = rest.starts_with("/*");
    if (!block && !rest.starts_with("//")) return;
    if (!std::exchange(comment_was_reported_, true)) {
      build_.mistake(span(at_, at_ + 2), "JSON has no comments; write a member `#comment`");
    }
    const std::size_t close = block ? rest.find("*/", 2) : rest.find_first_of("\r\n");
    at_ = close == std::string_view::npos ? end_ : at_ + close + (block ? 2 : 1);
    while (at_ != end_ && is_json_space(*at_)) ++at_;
  }
}

void JsonScanner::skip_value() {
  skip_item_of(*this);
}

void JsonScanner::mistake(const Span& span, std::string message) {
  if (span.begin == std::exchange(reported_at_, span.begin)) return;
  build_.mistake(span, std::move(message));
  if (build_.stopped()) finish_token(end_);
}

// Brackets

JsonBracket JsonScanner::open() {
  const JsonBracket bracket{next_span(), next() == '[' ? ']' : '}'};
  ++open_count(bracket.close);
  finish_token(at_ + 1);
  return bracket;
}

bool JsonScanner::leave(const JsonBracket& bracket) {
  --open_count(bracket.close);
  return false;
}

bool JsonScanner::next_item(JsonBracket& bracket) {
  if (!std::exchange(bracket.first, false)) take_comma(bracket);
  while (!at_end() && !build_.stopped()) {
    if (begins_value()) return true;
    if (take(bracket.close)) return leave(bracket);
    const char c = next();
    if ((c == '}' || c == ']') && open_count(c) > 0) {
      mistake(next_span(), fmt::format("`{}` is missing before this `{}`", bracket.close, c));
      return leave(bracket);
    }
    mistake(next_span(),
            fmt::format("expected {} or `{}`, found `{}`", bracket.close == '}' ? "a key" : "a value", bracket.close, c));
    if (!at_end()) finish_token(at_ + 1);
  }
  if (!std::exchange(end_was_reported_, true)) {
    mistake(bracket.place, fmt::format("this `{}` is not closed before the end of the file", bracket.close == '}' ? '{' : '['));
  }
  return leave(bracket);
}

void JsonScanner::take_comma(const JsonBracket& bracket) {
  const Span comma = next_span();
  if (take(',')) {
    if (next() == bracket.close) mistake(comma, fmt::format("no `,` may stand before `{}`", bracket.close));
  } else if (begins_value()) {
    mistake(span(last_begin_, last_end_), "a `,` is missing behind this");
  }
}

bool JsonScanner::next_member(JsonBracket& object, Name& key) {
  while (next_item(object)) {
    if (next() == '{' || next() == '[') {
      mistake(next_span(), fmt::format("expected a key in quotes, found {}", describe_next()));
      skip_value();
      continue;
    }
    if (next() != '"') mistake(next_span(), fmt::format("put {} into quotes", describe_next()));
    key = take_name();
    const bool colon = take(':');
    if (!colon) mistake(span(last_begin_, last_end_), "a `:` is missing behind this");
    if (begins_value()) return true;
    if (colon) mistake(span(last_begin_, last_end_), "a value is missing behind this");
  }
  return false;
}

// Numbers

double JsonScanner::take_number() {
  double value = 0;
  const auto [end, error] = std::from_chars(at_, end_, value);
  const bool whole = error == std::errc() && (end == end_ || ends_word(*end));
  if (!whole || !is_json_number({at_, static_cast<std::size_t>(end - at_)})) return take_odd_number();
  finish_token(end);
  return value;
}

/// A number that JSON does not have (`+1`, `.5`, `0xFF`) is reported and understood. Too small to tell from zero is zero.
double JsonScanner::take_odd_number() {
  double value = 0;
  const Span place = next_span();
  const std::string_view token(at_, place.end - place.begin);
  const auto [end, error] = scan_number(at_, at_ + token.size(), value);
  const bool whole = end == at_ + token.size();
  const bool tiny = error == std::errc::result_out_of_range && whole && token.find("e-") != std::string_view::npos;
  finish_token(at_ + token.size());
  if (tiny) return 0;
  if (error == std::errc() && whole) {
    mistake(place, fmt::format("JSON does not write a number as `{}`", shown(token)));
  } else {
    mistake(place, fmt::format("`{}` is no number that plugc can read", shown(token)));
  }
  return error == std::errc() ? value : 0;
}

}  // namespace plugc
