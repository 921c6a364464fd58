// Two batches: the fullest recipes, then the reduced ones, to which nobody listens.

#include "validate/validate_states.h"

#include <algorithm>

#include <fmt/format.h>

namespace plugc {
namespace {

/// Effects of a recipe that its program does not have.
std::vector<int> left_out(const Recipe& wanted, const Recipe& used) {
  std::vector<int> effects = all_effects(wanted);
  const std::vector<int> kept = all_effects(used);
  std::erase_if(effects, [&](int effect) { return std::ranges::find(kept, effect) != kept.end(); });
  return effects;
}

/// What the fuller recipe has and the reduced one has not.
std::string switched_off(const Recipe& reduced, const Recipe& fuller, const Scene& scene) {
  std::string text;
  const auto add = [&](const std::string& what) { text += text.empty() ? what : " and " + what; };
  for (const int effect : left_out(fuller, reduced))
    add(fmt::format("`{}`", scene.effects[static_cast<std::size_t>(effect)].label));
  for (std::size_t i = 0; i < fuller.lights.size(); ++i) {
    const bool off = i >= reduced.lights.size() || reduced.lights[i].off;
    if (off && !fuller.lights[i].off) add(fmt::format("light {}", i));
  }
  return text;
}

void report_consequences(const StateRecipe& wanted, const Recipe& used, const StateRecipe& fuller, const Recipe& used_fuller,
                         const Scene& scene, Diagnostics& diagnostics) {
  const std::vector<int> faulty = left_out(fuller.recipe, used_fuller);
  for (const int index : left_out(wanted.recipe, used)) {
    if (std::ranges::find(faulty, index) != faulty.end()) continue;
    const SceneEffect& effect = scene.effects[static_cast<std::size_t>(index)];
    const std::string off = switched_off(wanted.recipe, fuller.recipe, scene);
    diagnostics.report(DiagnosticId::effect_needs_switched, effect.span,
                       fmt::format("effect `{}` is left out while {} is switched off: the program is not valid without it",
                                   effect.label, off));
  }
}

}  // namespace

std::vector<ValidRecipe> validate_states(const std::vector<StateRecipe>& recipes, const ComposeInput& input,
                                         const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                                         ValidationStatistics& statistics) {
  std::vector<ValidRecipe> valid(recipes.size());
  Diagnostics unheard(diagnostics.sources());
  for (const bool reduced : {false, true}) {
    std::vector<Recipe> batch;
    for (const StateRecipe& one : recipes) {
      if ((one.fuller >= 0) == reduced) batch.push_back(one.recipe);
    }
    if (batch.empty()) continue;
    std::vector<ValidRecipe> results =
        validate_recipes(batch, input, options, validator, reduced ? unheard : diagnostics, statistics);
    auto result = results.begin();
    for (std::size_t i = 0; i < recipes.size(); ++i) {
      if ((recipes[i].fuller >= 0) == reduced) valid[i] = std::move(*result++);
    }
  }
  for (std::size_t i = 0; i < recipes.size(); ++i) {
    if (recipes[i].fuller < 0) continue;
    const auto fuller = static_cast<std::size_t>(recipes[i].fuller);
    report_consequences(recipes[i], valid[i].used, recipes[fuller], valid[fuller].used, input.scene, diagnostics);
  }
  return valid;
}

}  // namespace plugc
