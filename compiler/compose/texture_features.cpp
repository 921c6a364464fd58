// Tables from what a recipe says to the words of the templates.

#include "compose/texture_features.h"

#include <span>
#include <utility>

namespace plugc {
namespace {

using Choice = std::pair<bool, std::string_view>;

void insert_chosen(Features& features, std::span<const Choice> choices) {
  for (const auto& [chosen, word] : choices) {
    if (chosen) features.insert(word);
  }
}

std::string_view mode_word(TextureMode mode) {
  constexpr std::string_view kWords[] = {"MODULATE",
                                         "REPLACE",
                                         "MODULATE2X",
                                         "MODULATE4X",
                                         "ADD",
                                         "ADDSIGNED",
                                         "ADDSIGNED2X",
                                         "SUBTRACT",
                                         "ADDSMOOTH",
                                         "BLEND",
                                         "BLEND",
                                         "BLEND",
                                         "BLEND",
                                         "MODULATEALPHA_ADDCOLOR",
                                         "MODULATEINVALPHA_ADDCOLOR",
                                         "MODULATEINVCOLOR_ADDALPHA",
                                         "SELECTARG2",
                                         "DOTPRODUCT3"};
  return kWords[static_cast<std::size_t>(mode)];
}

/// Whose alpha a mode blends by.
std::string_view blend_word(TextureMode mode) {
  switch (mode) {
    case TextureMode::blend_diffuse_alpha: return "BLEND_DIFFUSE";
    case TextureMode::blend_texture_alpha: return "BLEND_TEXTURE";
    case TextureMode::blend_factor_alpha: return "BLEND_FACTOR";
    case TextureMode::blend_current_alpha: return "BLEND_CURRENT";
    default: return "NO_BLEND";
  }
}

/// The same, of a mode for alpha alone.
std::string_view alpha_blend_word(TextureMode mode) {
  switch (mode) {
    case TextureMode::blend_diffuse_alpha: return "ALPHA_BLEND_DIFFUSE";
    case TextureMode::blend_texture_alpha: return "ALPHA_BLEND_TEXTURE";
    case TextureMode::blend_factor_alpha: return "ALPHA_BLEND_FACTOR";
    case TextureMode::blend_current_alpha: return "ALPHA_BLEND_CURRENT";
    default: return "ALPHA_NO_BLEND";
  }
}

bool is_apart(const TextureCombination& how) {
  return how.alpha_mode != how.mode;
}

/// Whether it takes more than multiplying or replacing the colour so far.
bool is_combined(const TextureCombination& how) {
  const bool replaces = how.mode == TextureMode::replace;
  const bool multiplies = how.mode == TextureMode::modulate && how.source == TextureSource::previous;
  return is_apart(how) || !(replaces || multiplies);
}

bool has_mode(const TextureCombination& how, TextureMode mode) {
  return how.mode == mode || how.alpha_mode == mode;
}

/// How the texture changes the colour.
void insert_combination(Features& features, const TextureCombination& how) {
  constexpr std::string_view kSources[] = {"ARG2_PREVIOUS", "ARG2_DIFFUSE", "ARG2_SPECULAR", "ARG2_FACTOR"};
  const bool combined = is_combined(how);
  const Choice choices[] = {
      {!combined && how.mode == TextureMode::modulate, "MODE_MODULATE"},
      {!combined && how.mode == TextureMode::replace, "MODE_REPLACE"},
      {combined, "MODE_COMBINED"},
      {combined, kSources[static_cast<std::size_t>(how.source)]},
      {combined, blend_word(how.mode)},
      {is_apart(how), "ALPHA_APART"},
      {is_apart(how), alpha_blend_word(how.alpha_mode)},
      {uses_diffuse(how), "USES_DIFFUSE"},
      {combined && (how.source == TextureSource::factor || has_mode(how, TextureMode::blend_factor_alpha)), "USES_FACTOR"},
      {how.function == TextureFunction::complement, "COMPLEMENT"},
      {how.function == TextureFunction::alpha_replicate, "ALPHA_REPLICATE"}};
  insert_chosen(features, choices);
}

}  // namespace

Features coordinate_features(const TextureRecipe& texture) {
  constexpr std::string_view kGenerators[] = {
      "OF_MESH", "SPHERE",         "CAMERA_SPACE_NORMAL",  "CAMERA_SPACE_POSITION", "CAMERA_SPACE_REFLECTION", "SPHERE_LOCAL",
      "COORD",   "SPHERE_REFLECT", "SPHERE_REFLECT_LOCAL", "WORLD_SPACE_NORMAL",    "WORLD_SPACE_REFLECTION",  "PROJECTION",
      "NOISE",   "NOISE"};
  using enum CoordGenerator;
  const CoordGenerator g = texture.generator;
  Features features{kGenerators[static_cast<std::size_t>(g)]};
  const Choice choices[] = {{texture.matrix, "TEXTURE_MATRIX"},
                            {g == sphere_local || g == coord || g == sphere_reflect_local || g == noise, "IN_OBJECT_SPACE"},
                            {g == world_space_normal || g == world_space_reflection, "IN_WORLD_SPACE"},
                            {g == sphere_reflect || g == sphere_reflect_local, "PARAMETER"}};
  insert_chosen(features, choices);
  return features;
}

Features texture_features(const TextureRecipe& texture, bool first_unit) {
  constexpr std::string_view kKinds[] = {"IMAGE_2D", "IMAGE_3D", "CUBE", "SHADOW_2D", "SHADER", "SHADOW_CUBE"};
  Features features{kKinds[static_cast<std::size_t>(texture.kind)]};
  if (first_unit) features.insert("FIRST_UNIT");
  if (texture.projective) features.insert("PROJECTIVE");
  insert_combination(features, texture.combination);
  return features;
}

std::vector<Features> mode_features(const TextureCombination& how) {
  std::vector<Features> functions;
  if (is_combined(how)) functions.push_back({mode_word(how.mode)});
  if (is_apart(how)) functions.push_back({"FOR_ALPHA", mode_word(how.alpha_mode)});
  return functions;
}

bool uses_diffuse(const TextureCombination& how) {
  return is_combined(how) && (how.source == TextureSource::diffuse || has_mode(how, TextureMode::blend_diffuse_alpha));
}

}  // namespace plugc
