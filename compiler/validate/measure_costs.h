#pragma once
// What each effect of a program costs: the optimised program with it, less the one without it.

#include <optional>
#include <string>
#include <vector>

#include "compose/compose.h"
#include "validate/validate.h"

namespace plugc {

struct EffectCost {
  std::string label;
  /// The program without this effect; nullopt when that is none, as others need the effect.
  std::optional<ProgramCost> without;
};

struct ProgramCosts {
  std::optional<ProgramCost> whole;  ///< nullopt: the program cannot be optimised.
  std::vector<EffectCost> effects;   ///< In call order.
};

/// `recipe` has given a valid program. Nothing is reported.
ProgramCosts measure_costs(const Recipe& recipe, const ComposeInput& input, Target target, const SourceSet& sources,
                           Validator& validator);

}  // namespace plugc
