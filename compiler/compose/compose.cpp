// Composing is three passes over one list of placed units: place, resolve, join. See placed_unit.h for what they share.

#include "compose/compose.h"

#include <algorithm>

#include "compose/placed_unit.h"

namespace plugc {

void Composition::mark_faulty(const PlacedUnit& unit) {
  const Owner& owner = owners[unit.owner];
  if (owner.kind == OwnerKind::shader) result.faulty_shader = true;
  if (owner.kind != OwnerKind::effect) return;
  auto& faulty = result.faulty_effects;
  if (std::find(faulty.begin(), faulty.end(), owner.index) == faulty.end()) faulty.push_back(owner.index);
}

ComposedProgram compose(const Recipe& recipe, const ComposeInput& input, Target target, Diagnostics& diagnostics) {
  ComposedProgram program;
  Composition composition(recipe, input, diagnostics, program);
  place_units(composition);
  // from here the list of units is complete, and its order is the order of calls
  resolve_plugs(composition);
  // from here every plug function has its calls and its name
  join_names(composition);
  // from here no two owners' names meet
  for (const ShaderStage stage : {ShaderStage::vertex, ShaderStage::fragment}) {
    program.stages.push_back({stage, stage_text(composition, stage, target)});
  }
  return program;
}

Recipe without_effect(Recipe recipe, int effect) {
  std::erase(recipe.effects, effect);
  for (LightRecipe& light : recipe.lights) std::erase(light.effects, effect);
  for (TextureRecipe& texture : recipe.textures) std::erase(texture.effects, effect);
  return recipe;
}

std::vector<int> all_effects(const Recipe& recipe) {
  std::vector<int> effects;
  const auto add = [&](const std::vector<int>& list) {
    for (const int effect : list) {
      if (std::find(effects.begin(), effects.end(), effect) == effects.end()) effects.push_back(effect);
    }
  };
  for (const LightRecipe& light : recipe.lights) add(light.effects);
  for (const TextureRecipe& texture : recipe.textures) add(texture.effects);
  add(recipe.effects);
  return effects;
}

}  // namespace plugc
