// One optimised program for the recipe and one for each effect left out. An effect that others need cannot be left out alone:
// composing or validating without it finds them at fault.

#include "validate/measure_costs.h"

namespace plugc {
namespace {

/// nullopt when composing finds an effect at fault.
std::optional<ProgramText> compose_text(const Recipe& recipe, const ComposeInput& input, Target target,
                                        const SourceSet& sources) {
  Diagnostics unheard(sources);
  ComposedProgram composed = compose(recipe, input, target, unheard);
  if (composed.faulty_shader || !composed.faulty_effects.empty()) return std::nullopt;
  ProgramText text;
  text.target = target;
  text.optimize = true;
  for (ComposedStage& stage : composed.stages) text.stages.push_back({stage.stage, std::move(stage.text)});
  return text;
}

std::optional<ProgramCost> cost_of(const Recipe& recipe, const ComposeInput& input, Target target, const SourceSet& sources,
                                   Validator& validator) {
  std::optional<ProgramText> text = compose_text(recipe, input, target, sources);
  if (!text) return std::nullopt;
  std::vector<ProgramText> one;
  one.push_back(std::move(*text));
  const ValidationResult result = std::move(validator.validate(std::move(one)).front());
  return result.program ? result.program->cost() : std::nullopt;
}

}  // namespace

ProgramCosts measure_costs(const Recipe& recipe, const ComposeInput& input, Target target, const SourceSet& sources,
                           Validator& validator) {
  ProgramCosts costs;
  costs.whole = cost_of(recipe, input, target, sources, validator);
  for (const int effect : all_effects(recipe)) {
    costs.effects.push_back({input.scene.effects[static_cast<std::size_t>(effect)].label,
                             cost_of(without_effect(recipe, effect), input, target, sources, validator)});
  }
  return costs;
}

}  // namespace plugc
