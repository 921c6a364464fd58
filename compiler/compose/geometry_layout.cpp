// Layouts are the outline's; their words are looked for, as nothing else than words decides here.

#include "compose/geometry_layout.h"

#include <algorithm>
#include <span>

namespace plugc {
namespace {

struct InputPrimitive {
  std::string_view name;
  int size = 0;
};
constexpr InputPrimitive kInputPrimitives[] = {
    {"points", 1}, {"lines", 2}, {"triangles", 3}, {"lines_adjacency", 4}, {"triangles_adjacency", 6}};

const InputPrimitive* find_primitive(std::string_view name) {
  const auto* const found = std::ranges::find(kInputPrimitives, name, &InputPrimitive::name);
  return found == std::end(kInputPrimitives) ? nullptr : found;
}

std::span<const Token> tokens_of(const CodeUnit& code, const TextRange& range) {
  const auto& tokens = code.tokens.tokens;
  const auto begin = std::ranges::lower_bound(tokens, range.begin, {}, &Token::begin);
  return {begin, std::ranges::lower_bound(tokens, range.end, {}, &Token::begin)};
}

}  // namespace

std::optional<InputLayout> find_input_layout(const CodeUnit& code) {
  constexpr std::size_t kTokensOfPlainLayout = 6;  // layout ( triangles ) in ;
  for (const TextRange& range : code.outline.layouts) {
    InputLayout layout{range, {}, false};
    const auto tokens = tokens_of(code, range);
    const bool is_input = std::ranges::any_of(tokens, [&](const Token& token) { return code.at(token) == "in"; });
    for (const Token& token : tokens) {
      const InputPrimitive* found = find_primitive(code.macro_word(code.at(token)));
      if (found == nullptr || !layout.primitive.empty()) continue;
      layout.primitive = found->name;
      layout.alone = code.at(token) == found->name && tokens.size() == kTokensOfPlainLayout;
    }
    if (is_input && !layout.primitive.empty()) return layout;
  }
  return std::nullopt;
}

bool has_output_layout(const CodeUnit& code) {
  return std::ranges::any_of(code.outline.layouts, [&](const TextRange& range) {
    const auto tokens = tokens_of(code, range);
    return std::ranges::any_of(tokens, [&](const Token& token) { return code.at(token) == "out"; });
  });
}

int input_size(std::string_view primitive) {
  return find_primitive(primitive)->size;
}

}  // namespace plugc
