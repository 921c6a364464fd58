#include "compose/name_use.h"

#include <algorithm>

namespace plugc {
namespace {

bool directive_names(const CodeUnit& code, const Token& directive, std::string_view name) {
  if (code.at(directive).find(name) == std::string_view::npos) return false;
  const std::vector<Token> words = directive_tokens(code.text.text(), directive);
  return std::any_of(words.begin(), words.end(), [&](const Token& word) { return code.at(word) == name; });
}

}  // namespace

bool is_used(const CodeUnit& code, std::string_view name, std::uint32_t declared_at) {
  return std::any_of(code.tokens.tokens.begin(), code.tokens.tokens.end(), [&](const Token& token) {
    if (token.kind == TokenKind::directive) return directive_names(code, token, name);
    return token.kind == TokenKind::identifier && code.at(token) == name && token.begin != declared_at;
  });
}

std::set<std::size_t> one_for_each_author(const Composition& composition, const std::set<std::size_t>& owners) {
  std::set<std::pair<OwnerKind, int>> known;
  std::set<std::size_t> kept;
  for (const std::size_t owner : owners) {
    if (known.insert({composition.owners[owner].kind, composition.owners[owner].index}).second) kept.insert(owner);
  }
  return kept;
}

}  // namespace plugc
