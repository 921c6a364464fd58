// Few parts name a precision, so the uniforms of all others are looked at only where one does.

#include "compose/precision.h"

#include <algorithm>
#include <array>

namespace plugc {
namespace {

constexpr std::array<std::string_view, 3> kWords = {"lowp", "mediump", "highp"};  // upwards

std::size_t rank_of(const CodeUnit& code, const GlobalOutline& global) {
  const auto word = precision_word(code, global);
  return word ? static_cast<std::size_t>(std::ranges::find(kWords, code.at(*word)) - kWords.begin()) : kWords.size() - 1;
}

}  // namespace

bool names_precision(std::string_view text) {
  return std::ranges::any_of(kWords, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

std::optional<Token> precision_word(const CodeUnit& code, const GlobalOutline& global) {
  const auto& tokens = code.tokens.tokens;
  auto token = std::ranges::lower_bound(tokens, global.begin, {}, &Token::begin);
  for (; token != tokens.end() && token->begin < global.declarator_begin; ++token) {
    if (std::ranges::find(kWords, code.at(*token)) != kWords.end()) return *token;
  }
  return std::nullopt;
}

void note_precisions(Composition& c) {
  const bool any = std::ranges::any_of(c.units, [](const PlacedUnit& unit) { return unit.code->names_precision; });
  if (!any) return;
  struct Range {
    std::size_t lowest = kWords.size(), highest = 0;
  };
  std::map<std::string_view, Range> ranges;
  for (const PlacedUnit& unit : c.units) {
    if (unit.dropped) continue;
    for (const GlobalOutline& global : unit.code->outline.globals) {
      if (global.storage != Storage::uniform) continue;
      Range& range = ranges[c.final_name(unit, global.name)];
      const std::size_t rank = rank_of(*unit.code, global);
      range.lowest = std::min(range.lowest, rank);
      range.highest = std::max(range.highest, rank);
    }
  }
  for (const auto& [name, range] : ranges) {
    if (range.lowest < range.highest) c.precisions.emplace(name, kWords[range.highest]);
  }
}

}  // namespace plugc
