#include "compose/shading_features.h"

#include <algorithm>
#include <utility>

#include "compose/recipe.h"

namespace plugc {
namespace {

/// Some effect of the recipe, or its ComposedShader.
bool any_fills(const Composition& composition, std::string_view plug) {
  const std::vector<int> effects = all_effects(composition.recipe);
  const bool by_shader = composition.recipe.shader >= 0 &&
                         composition.input.shaders[static_cast<std::size_t>(composition.recipe.shader)].fills(plug);
  return by_shader || std::ranges::any_of(effects, [&](int effect) {
           return composition.input.effects[static_cast<std::size_t>(effect)].fills(plug);
         });
}

}  // namespace

Features base_features(const Recipe& recipe, const UsedNames& names) {
  Features features;
  // a normal map says all of the normal itself
  const bool bent = std::ranges::find(recipe.textures, TextureRole::normal, &TextureRecipe::role) != recipe.textures.end();
  const bool smooth = recipe.normals && !recipe.gouraud && !recipe.depth_only && !bent;
  const std::pair<bool, std::string_view> all[] = {
      {recipe.lit && !recipe.physical, "LIT"},
      {recipe.physical, "PHYSICAL"},
      {recipe.physical && recipe.vertex_eye, "VIEW"},
      {!recipe.lit, "UNLIT"},
      {recipe.normals, "NORMALS"},
      {recipe.two_sided, "TWO_SIDED"},
      {recipe.back_material, "BACK_MATERIAL"},
      {recipe.color_per_vertex, "COLOR_PER_VERTEX"},
      {recipe.vertex_eye || ((recipe.depth_only || recipe.shader >= 0) && names.contains("castle_vertex_eye")), "VERTEX_EYE"},
      {recipe.ambient, "AMBIENT"},
      {recipe.specular, "SPECULAR"},
      {recipe.emissive, "EMISSIVE"},
      {smooth || names.contains("castle_normal_eye"), "NORMAL_EYE"}};
  for (const auto& [set, feature] : all) {
    if (set) features.insert(feature);
  }
  return features;
}

Features light_features(const Composition& composition, const LightRecipe& light, bool base_adds_lights) {
  const Recipe& recipe = composition.recipe;
  Features features;
  const std::pair<bool, std::string_view> all[] = {{light.kind != LightKind::directional, "POSITIONAL"},
                                                   {light.kind == LightKind::spot, "SPOT"},
                                                   {light.ambient, "LIGHT_AMBIENT"},
                                                   {light.attenuation, "ATTENUATION"},
                                                   {light.radius, "RADIUS"},
                                                   {light.beam_width, "BEAM_WIDTH"},
                                                   {recipe.physical, "PHYSICAL"},
                                                   {!recipe.physical, "PHONG"},
                                                   {recipe.specular, "SPECULAR"},
                                                   {!base_adds_lights, "AS_CONTRIBUTION"},
                                                   {any_fills(composition, "material_light_diffuse"), "WIDE_DIFFUSE"},
                                                   {any_fills(composition, "material_light_ambient"), "WIDE_AMBIENT"},
                                                   {any_fills(composition, "material_light_specular"), "WIDE_SPECULAR"}};
  for (const auto& [set, feature] : all) {
    if (set) features.insert(feature);
  }
  return features;
}

}  // namespace plugc
