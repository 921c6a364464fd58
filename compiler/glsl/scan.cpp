// A token is recognised by its first byte: letters start identifiers, digits (and `.5`) numbers, the rest are symbols by
// longest match. What fits nothing becomes an `invalid` token that is as long as one code point or one string.

#include "glsl/scan.h"

#include <algorithm>

#include "base/limits.h"

namespace plugc {
namespace {

char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? text[at] : '\0';
}

template <typename Accepts>
std::uint32_t skip_while(std::string_view text, std::uint32_t at, Accepts accepts) {
  while (at < text.size() && accepts(text[at])) ++at;
  return at;
}

constexpr bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

constexpr bool is_number_suffix(char c) {
  return c == 'u' || c == 'U' || c == 'f' || c == 'F' || c == 'l' || c == 'L';
}

// `e5`, `E-5`; nothing when no digit follows.
std::uint32_t exponent_end(std::string_view text, std::uint32_t at) {
  if (byte_at(text, at) != 'e' && byte_at(text, at) != 'E') return at;
  const char sign = byte_at(text, at + 1);
  const std::uint32_t digits = at + (sign == '+' || sign == '-' ? 2 : 1);
  return is_digit(byte_at(text, digits)) ? skip_while(text, digits, is_digit) : at;
}

std::uint32_t number_end(std::string_view text, std::uint32_t at) {
  if (text[at] == '0' && (byte_at(text, at + 1) | 0x20) == 'x') {
    return skip_while(text, skip_while(text, at + 2, is_hex_digit), is_number_suffix);
  }
  at = skip_while(text, at, is_digit);
  if (byte_at(text, at) == '.') at = skip_while(text, at + 1, is_digit);
  return skip_while(text, exponent_end(text, at), is_number_suffix);
}

// How many bytes of operator start with `first`; 0 when it starts none.
std::uint32_t symbol_length(char first, char second, char third) {
  constexpr std::string_view kDoubling = "+-<>&|^=#";
  if (is_in_class(first, kPairingByte) && (second == first || second == '=')) {
    const bool shift = (first == '<' || first == '>') && first == second;
    if (shift) return third == '=' ? 3 : 2;
    if (second == first ? kDoubling.find(first) != std::string_view::npos : first != '#') return 2;
  }
  return is_in_class(first, kSymbolByte) ? 1 : 0;
}

// GLSL has no strings; one is passed over whole so that its inside is not taken for code.
std::uint32_t string_end(std::string_view text, std::uint32_t at) {
  const std::uint32_t close = skip_while(text, at + 1, [](char c) { return c != '"' && !is_line_end(c); });
  return byte_at(text, close) == '"' ? close + 1 : close;
}

std::uint32_t code_point_end(std::string_view text, std::uint32_t at) {
  return skip_while(text, at + 1, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
}

}  // namespace

std::uint32_t continuation_length(std::string_view text, std::uint32_t at) {
  if (byte_at(text, at) != '\\') return 0;
  if (byte_at(text, at + 1) == '\r') return byte_at(text, at + 2) == '\n' ? 3 : 2;
  return byte_at(text, at + 1) == '\n' ? 2 : 0;
}

CommentKind comment_at(std::string_view text, std::uint32_t at) {
  if (byte_at(text, at) != '/') return CommentKind::none;
  const char second = byte_at(text, at + 1);
  return second == '/' ? CommentKind::line : second == '*' ? CommentKind::block : CommentKind::none;
}

std::uint32_t line_comment_end(std::string_view text, std::uint32_t at) {
  while (at < text.size() && !is_line_end(text[at])) at += std::max(1U, continuation_length(text, at));
  return at;
}

std::uint32_t block_comment_end(std::string_view text, std::uint32_t at) {
  const std::size_t close = text.find("*/", at + 2);
  return close == std::string_view::npos ? UINT32_MAX : static_cast<std::uint32_t>(close + 2);
}

Token scan_token(std::string_view text, std::uint32_t at) {
  const char first = text[at];
  if (is_identifier_start(first)) return {TokenKind::identifier, at, skip_while(text, at + 1, is_identifier_part)};
  if (is_digit(first) || (first == '.' && is_digit(byte_at(text, at + 1)))) {
    return {TokenKind::number, at, number_end(text, at)};
  }
  const std::uint32_t length = symbol_length(first, byte_at(text, at + 1), byte_at(text, at + 2));
  if (length != 0) return {TokenKind::symbol, at, at + length};
  return {TokenKind::invalid, at, first == '"' ? string_end(text, at) : code_point_end(text, at)};
}

std::vector<Token> scan_range(std::string_view text, std::uint32_t begin, std::uint32_t end) {
  text = text.substr(0, end);
  std::vector<Token> tokens;
  for (std::uint32_t at = begin; at < text.size() && tokens.size() < kMaxShaderTokens;) {
    const std::uint32_t continued = continuation_length(text, at);
    if (continued != 0) {
      at += continued;
    } else if (is_blank(text[at]) || is_line_end(text[at])) {
      ++at;
    } else if (const CommentKind comment = comment_at(text, at); comment == CommentKind::line) {
      at = line_comment_end(text, at);
    } else if (comment == CommentKind::block) {
      at = block_comment_end(text, at);
    } else {
      tokens.push_back(scan_token(text, at));
      at = tokens.back().end;
    }
  }
  return tokens;
}

}  // namespace plugc
