// What MultiTexture says of one of its textures: mode, source and function (X3D 4.1, 18.4.3). A mode may name two, one for
// the colour and one for alpha, with a comma (or, in the reference engine, a slash) between. Words that do not exist have been
// reported when the value was read.

#include <algorithm>
#include <array>

#include "scene/scene_context.h"

namespace plugc {
namespace {

struct ModeName {
  std::string_view name;
  TextureMode mode;
};

using enum TextureMode;
constexpr ModeName kModes[] = {{"MODULATE", modulate},
                               {"REPLACE", replace},
                               {"SELECTARG1", replace},
                               {"MODULATE2X", modulate_2x},
                               {"MODULATE4X", modulate_4x},
                               {"ADD", add},
                               {"ADDSIGNED", add_signed},
                               {"ADDSIGNED2X", add_signed_2x},
                               {"SUBTRACT", subtract},
                               {"ADDSMOOTH", add_smooth},
                               {"BLENDDIFFUSEALPHA", blend_diffuse_alpha},
                               {"BLENDTEXTUREALPHA", blend_texture_alpha},
                               {"BLENDFACTORALPHA", blend_factor_alpha},
                               {"BLENDCURRENTALPHA", blend_current_alpha},
                               {"MODULATEALPHA_ADDCOLOR", modulate_alpha_add_color},
                               {"MODULATEINVALPHA_ADDCOLOR", modulate_inv_alpha_add_color},
                               {"MODULATEINVCOLOR_ADDALPHA", modulate_inv_color_add_alpha},
                               {"SELECTARG2", select_arg2},
                               {"DOTPRODUCT3", dot_product_3}};
constexpr std::array<std::string_view, 4> kSources = {"", "DIFFUSE", "SPECULAR", "FACTOR"};
constexpr std::array<std::string_view, 3> kFunctions = {"", "COMPLEMENT", "ALPHAREPLICATE"};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::string_view string_at(const NodeGraph& graph, NodeId node, std::string_view field, std::size_t index) {
  const auto strings = graph.field(node, field).strings;
  return index < strings.size() ? trimmed(strings[index].text()) : std::string_view();
}

TextureMode mode_named(std::string_view name) {
  const auto* found = std::ranges::find(kModes, name, &ModeName::name);
  return found == std::end(kModes) ? modulate : found->mode;
}

/// The enumerator of the value's place among the names; the first for an unknown value.
template <typename Enum, std::size_t N>
Enum named(const std::array<std::string_view, N>& names, std::string_view value) {
  const auto found = std::ranges::find(names, value);
  return static_cast<Enum>(found == names.end() ? 0 : found - names.begin());
}

}  // namespace

std::optional<TextureCombination> read_combination(const NodeGraph& graph, NodeId multi_texture, std::size_t index) {
  const std::string_view mode = string_at(graph, multi_texture, "mode", index);
  if (mode == "OFF") return std::nullopt;
  const std::size_t comma = mode.find_first_of(",/");
  TextureCombination combination;
  combination.mode = mode_named(trimmed(mode.substr(0, comma)));
  combination.alpha_mode = comma == std::string_view::npos ? combination.mode : mode_named(trimmed(mode.substr(comma + 1)));
  combination.source = named<TextureSource>(kSources, string_at(graph, multi_texture, "source", index));
  combination.function = named<TextureFunction>(kFunctions, string_at(graph, multi_texture, "function", index));
  return combination;
}

}  // namespace plugc
