// A changed token becomes another one of the same author, or one of those that break texts in ways of their own: brackets,
// comments, directives, names that nobody declares. Those need no escapes in any encoding.

#include "mutants/mutate.h"

#include <array>
#include <string_view>

#include "glsl/tokens.h"

namespace plugc::mutants {
namespace {

constexpr std::array<std::string_view, 24> kBreakers = {
    "{",  "}", "(", ")",     "[",      "]",     ";",    ",", ".",    "#",      "//",     "/*",
    "*/", "@", "$", "#if 1", "#endif", "float", "vec3", "0", "1.5e", "struct", "return", "nonsense"};

void add_token(const CheckedScene& scene, const MappedText& text, const Token& token, std::vector<Span>& places) {
  const Span span = text.locate(token.begin, token.end);
  if (span.valid() && scene.sources->text(span) == token_text(text.text(), token)) places.push_back(span);
}

std::size_t below(std::mt19937& random, std::size_t bound) {
  return random() % bound;
}

}  // namespace

std::vector<Span> token_places(const CheckedScene& scene, const Author& author) {
  std::vector<Span> places;
  for (const ShaderSource& part : scene.node(author).parts) {
    const std::string_view text = part.text.text();
    for (const Token& token : tokenize(text, {}).tokens) {
      if (token.kind != TokenKind::directive) add_token(scene, part.text, token, places);
      if (token.kind != TokenKind::directive) continue;
      for (const Token& word : directive_tokens(text, token)) add_token(scene, part.text, word, places);
    }
  }
  return places;
}

Mutation mutate(const SourceSet& sources, const std::vector<Span>& places, std::mt19937& random) {
  Mutation mutation;
  mutation.token = places[below(random, places.size())];
  const std::string_view token = sources.text(mutation.token);
  mutation.kind = static_cast<MutationKind>(below(random, 3));
  if (mutation.kind == MutationKind::repeated) mutation.replacement = std::string(token) + " " + std::string(token);
  if (mutation.kind == MutationKind::changed) {
    const bool breaks = below(random, 2) == 0;
    mutation.replacement =
        breaks ? kBreakers[below(random, kBreakers.size())] : sources.text(places[below(random, places.size())]);
  }
  mutation.changed_text = sources.text(mutation.token.source);
  mutation.changed_text.replace(mutation.token.begin, mutation.token.end - mutation.token.begin, mutation.replacement);
  return mutation;
}

}  // namespace plugc::mutants
