// Tables. Types of lines that differ from dashes and dots in a word of the trade alone are drawn as those.

#include "compose/style_features.h"

namespace plugc {

std::string_view line_type_word(int line_type) {
  switch (line_type) {
    case 2:
    case 12: return "DASHED";  // dashed, hidden
    case 3: return "DOTTED";
    case 4:
    case 10:
    case 11: return "DASH_DOT";  // dash-dot, chain, center
    case 5:
    case 13: return "DASH_DOT_DOT";  // dash-dot-dot, phantom
    default: return "";
  }
}

Features hatch_features(const Recipe& recipe) {
  constexpr bool kHorizontal[] = {false, true, false, false, false, true, false};
  constexpr bool kVertical[] = {false, false, true, false, false, true, false};
  constexpr bool kRising[] = {false, false, false, true, false, false, true};
  constexpr bool kFalling[] = {false, false, false, false, true, false, true};
  const auto style = static_cast<std::size_t>(recipe.hatch);
  Features features;
  const std::pair<bool, std::string_view> all[] = {{!recipe.filled, "UNFILLED"},       {recipe.hatch != 0, "HATCHED"},
                                                   {kHorizontal[style], "HORIZONTAL"}, {kVertical[style], "VERTICAL"},
                                                   {kRising[style], "RISING"},         {kFalling[style], "FALLING"}};
  for (const auto& [set, word] : all) {
    if (set) features.insert(word);
  }
  return features;
}

}  // namespace plugc
