// A recipe in one line: what the program is, then each light, each texture, the effects, with a word for all that takes code.

#include <span>
#include <utility>

#include <fmt/format.h>

#include "compose/recipe.h"

namespace plugc {
namespace {

using Word = std::pair<bool, std::string_view>;

void append_words(std::string& text, std::span<const Word> words) {
  for (const auto& [set, word] : words) {
    if (set) text += word;
  }
}

void append_effects(std::string& text, const std::vector<int>& effects, const Scene& scene) {
  for (const int effect : effects) text += fmt::format(" `{}`", scene.effects[static_cast<std::size_t>(effect)].label);
}

void append_base(std::string& text, const Recipe& recipe) {
  if (recipe.map_pass != MapPass::none) {
    constexpr std::string_view kPasses[] = {"", "moments vsm", "moments evsm", "moments msm", "blur of moments"};
    text = kPasses[static_cast<std::size_t>(recipe.map_pass)];
    return;
  }
  if (recipe.screen_pass != ScreenPass::none) {
    text = recipe.screen_pass == ScreenPass::color ? "screen" : "screen depth";
    return;
  }
  text = recipe.depth_pass ? "depth" : recipe.shader >= 0 ? "shader" : recipe.gouraud ? "gouraud" : "phong";
  const Word words[] = {{!recipe.depth_pass && recipe.shader < 0, recipe.lit ? " lit" : " unlit"},
                        {recipe.depth_pass && !recipe.depth_only, " fragments"},
                        {recipe.of_point_light, " point"},
                        {recipe.cut_near, " cut_near"},
                        {recipe.physical, " physical"},
                        {recipe.specular, " specular"},
                        {recipe.emissive, " emissive"},
                        {recipe.two_sided, " two_sided"},
                        {recipe.color_per_vertex, " color_per_vertex"},
                        {recipe.alpha_test, " alpha_test"},
                        {recipe.fog == FogKind::linear, " linear_fog"},
                        {recipe.fog == FogKind::exponential, " exponential_fog"},
                        {recipe.fog == FogKind::either, " either_fog"},
                        {recipe.fog != FogKind::none && recipe.fog_coord, " fog_coord"},
                        {recipe.fog_plane, " fog_plane"},
                        {recipe.primitive == Primitive::points, " points"},
                        {recipe.primitive == Primitive::lines, " lines"},
                        {recipe.back_material, " back_material"},
                        {recipe.alpha_cutoff, " alpha_cutoff"},
                        {recipe.point_size, " point_size"},
                        {!recipe.filled, " unfilled"}};
  append_words(text, words);
  if (recipe.line_type != 1) text += fmt::format(" line_type {}", recipe.line_type);
  if (recipe.hatch != 0) text += fmt::format(" hatch {}", recipe.hatch);
  if (recipe.clip_planes != 0) text += fmt::format(" clip_planes {}", recipe.clip_planes);
}

void append_light(std::string& text, const LightRecipe& light) {
  if (light.off) {
    text += "; light off";
    return;
  }
  constexpr std::string_view kKinds[] = {"directional", "point", "spot"};
  text += fmt::format("; light {}", kKinds[static_cast<std::size_t>(light.kind)]);
  const Word words[] = {{light.ambient, " ambient"},
                        {light.attenuation, " attenuation"},
                        {light.radius, " radius"},
                        {light.beam_width, " beam_width"}};
  append_words(text, words);
  if (light.shadow) text += fmt::format(" shadow {}", to_text(light.shadow_method));
  const Word further[] = {{light.shadow_intensity, " shadow_intensity"}, {light.guarded, " switched"}};
  append_words(text, further);
}

/// X3D's name in small letters.
std::string_view mode_text(TextureMode mode) {
  constexpr std::string_view kModes[] = {"modulate",
                                         "replace",
                                         "modulate2x",
                                         "modulate4x",
                                         "add",
                                         "addsigned",
                                         "addsigned2x",
                                         "subtract",
                                         "addsmooth",
                                         "blenddiffusealpha",
                                         "blendtexturealpha",
                                         "blendfactoralpha",
                                         "blendcurrentalpha",
                                         "modulatealpha_addcolor",
                                         "modulateinvalpha_addcolor",
                                         "modulateinvcolor_addalpha",
                                         "selectarg2",
                                         "dotproduct3"};
  return kModes[static_cast<std::size_t>(mode)];
}

/// `modulate2x / add diffuse complement`.
std::string combination_text(const TextureCombination& how) {
  constexpr std::string_view kSources[] = {"", " diffuse", " specular", " factor"};
  constexpr std::string_view kFunctions[] = {"", " complement", " alpha_replicate"};
  const std::string alpha = how.alpha_mode == how.mode ? "" : fmt::format(" / {}", mode_text(how.alpha_mode));
  return fmt::format("{}{}{}{}", mode_text(how.mode), alpha, kSources[static_cast<std::size_t>(how.source)],
                     kFunctions[static_cast<std::size_t>(how.function)]);
}

std::string_view generator_text(CoordGenerator generator) {
  constexpr std::string_view kGenerators[] = {"",
                                              " sphere",
                                              " camera_space_normal",
                                              " camera_space_position",
                                              " camera_space_reflection",
                                              " sphere_local",
                                              " coord",
                                              " sphere_reflect",
                                              " sphere_reflect_local",
                                              " world_space_normal",
                                              " world_space_reflection",
                                              " projection",
                                              " noise",
                                              " noise_eye"};
  return kGenerators[static_cast<std::size_t>(generator)];
}

void append_texture(std::string& text, const TextureRecipe& texture) {
  constexpr std::string_view kKinds[] = {"", " 3d", " cube", " shadow", " shader", " shadow cube"};
  constexpr std::string_view kRoles[] = {
      "", "ambient", "specular", "shininess", "emissive", "occlusion", "metallic_roughness", "normal", "unused"};
  const bool main = texture.role == TextureRole::main;
  text +=
      fmt::format("; texture{} {}{}", kKinds[static_cast<std::size_t>(texture.kind)],
                  main ? combination_text(texture.combination) : std::string(kRoles[static_cast<std::size_t>(texture.role)]),
                  generator_text(texture.generator));
  const Word words[] = {{texture.matrix, " matrix"}, {texture.projective, " projective"}};
  append_words(text, words);
}

/// The words, and the effects behind them, where there are any.
void append_effect_list(std::string& text, std::string_view words, const std::vector<int>& effects, const Scene& scene) {
  if (effects.empty()) return;
  text += words;
  append_effects(text, effects, scene);
}

}  // namespace

std::string to_text(const Recipe& recipe, const Scene& scene) {
  std::string text;
  append_base(text, recipe);
  if (recipe.shader >= 0) text += fmt::format(" `{}`", scene.shaders[static_cast<std::size_t>(recipe.shader)].label);
  for (const LightRecipe& light : recipe.lights) {
    append_light(text, light);
    append_effects(text, light.effects, scene);
  }
  for (const TextureRecipe& texture : recipe.textures) {
    append_texture(text, texture);
    append_effects(text, texture.effects, scene);
  }
  append_effect_list(text, "; effects", recipe.effects, scene);
  append_effect_list(text, "; switched", recipe.guarded, scene);
  return text;
}

}  // namespace plugc
