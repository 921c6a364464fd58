// Tokens are in text order, so a range of them is found by bisection.

#include "compose/struct_text.h"

#include <algorithm>

namespace plugc {

std::string token_line(const CodeUnit& code, std::uint32_t begin, std::uint32_t end) {
  const auto& tokens = code.tokens.tokens;
  std::string line;
  auto token =
      std::lower_bound(tokens.begin(), tokens.end(), begin, [](const Token& t, std::uint32_t at) { return t.begin < at; });
  for (; token != tokens.end() && token->end <= end; ++token) {
    if (token->kind == TokenKind::marker) continue;
    if (!line.empty()) line += ' ';
    line += code.at(*token);
  }
  return line;
}

std::string struct_text(const CodeUnit& code, const StructOutline& type) {
  std::string text = token_line(code, type.begin, type.end);
  if (text.ends_with(" ;")) text.resize(text.size() - 2);
  return text;
}

}  // namespace plugc
