#pragma once
// GLSL as tokens. Comments and white space yield none, except the marker comments that plugc is about. Text in dead
// preprocessor branches (`#if 0`, `#ifdef` of a macro that is not defined) yields none either, so that nothing behind
// this line can take a comment or dead code for code. Source: GLSL 4.60 specification, clause 3.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plugc {

enum class TokenKind : std::uint8_t {
  identifier,  ///< Keywords too.
  number,
  symbol,     ///< One operator or bracket, longest match.
  directive,  ///< A whole live preprocessor line (continued lines included), from `#` to before its line end.
  marker,     ///< A live `/* PLUG: ... */`, `/* PLUG-DECLARATIONS */` or `/* VARYING-PASSTHROUGH-GEOMETRY-SHADERS */`.
  invalid,    ///< A byte that starts no token; an unclosed comment.
};

/// Bytes [begin, end) of the text.
struct Token {
  TokenKind kind = TokenKind::invalid;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// A macro as the preprocessor sees it before the text starts.
struct MacroDefinition {
  std::string name;
  std::string value;
};

struct TokenList {
  std::vector<Token> tokens;
  bool too_many = false;  ///< kMaxShaderTokens was reached; the list is cut short.
};

TokenList tokenize(std::string_view text, std::span<const MacroDefinition> predefined);

/// The tokens inside one directive: `#`, its name, then the rest, comments left out.
std::vector<Token> directive_tokens(std::string_view text, const Token& directive);

inline std::string_view token_text(std::string_view text, const Token& token) {
  return text.substr(token.begin, token.end - token.begin);
}

}  // namespace plugc
