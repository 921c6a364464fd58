#pragma once
// The lowest layer of reading GLSL: white space, comments and single tokens at a place. Knows nothing of directives, of
// live or dead branches, or of markers. Every function looks at [at, end) of the text only.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "glsl/tokens.h"

namespace plugc {

/// What a byte may be part of.
inline constexpr std::uint8_t kLetterByte = 1;
inline constexpr std::uint8_t kDigitByte = 2;
inline constexpr std::uint8_t kSymbolByte = 4;
inline constexpr std::uint8_t kPairingByte = 8;  ///< May be followed by itself or by `=` within one operator.

constexpr std::array<std::uint8_t, 256> make_byte_classes() {
  std::array<std::uint8_t, 256> classes{};
  const auto add = [&](std::string_view bytes, std::uint8_t byte_class) {
    for (const char c : bytes) classes[static_cast<unsigned char>(c)] |= byte_class;
  };
  add("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", kLetterByte);
  add("0123456789", kDigitByte);
  add("()[]{}.,+-*/%<>!~=&^|?:;", kSymbolByte);
  add("+-*/%<>!=&^|#", kPairingByte);
  return classes;
}
inline constexpr std::array<std::uint8_t, 256> kByteClasses = make_byte_classes();

constexpr bool is_in_class(char c, unsigned classes) {
  return (kByteClasses[static_cast<unsigned char>(c)] & classes) != 0;
}
constexpr bool is_digit(char c) {
  return is_in_class(c, kDigitByte);
}
constexpr bool is_identifier_start(char c) {
  return is_in_class(c, kLetterByte);
}
constexpr bool is_identifier_part(char c) {
  return is_in_class(c, kLetterByte | kDigitByte);
}
constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Bytes of a `\` with the line end behind it (`\n`, `\r\n`, `\r`); 0 when none starts here.
std::uint32_t continuation_length(std::string_view text, std::uint32_t at);

enum class CommentKind : std::uint8_t { none, line, block };
CommentKind comment_at(std::string_view text, std::uint32_t at);

/// Behind a `//` comment: at its line end. A continued line is part of the comment (clause 3.4).
std::uint32_t line_comment_end(std::string_view text, std::uint32_t at);
/// Behind the `*/`, or UINT32_MAX when the comment is never closed.
std::uint32_t block_comment_end(std::string_view text, std::uint32_t at);

/// The token at a byte that is neither white space nor the start of a comment.
Token scan_token(std::string_view text, std::uint32_t at);

/// All tokens of [begin, end) (at most kMaxShaderTokens), line ends taken as white space: what a macro's body, a
/// marker's arguments or a signature holds.
std::vector<Token> scan_range(std::string_view text, std::uint32_t begin, std::uint32_t end);

}  // namespace plugc
