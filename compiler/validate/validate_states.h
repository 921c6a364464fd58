#pragma once
// The recipes of a scene whose shapes can be switched: all are composed and validated, and mistakes are told of the fullest
// ones only, since in the others an effect may merely miss what is off.

#include <vector>

#include "compose/shape_states.h"
#include "validate/validate_recipes.h"

namespace plugc {

/// One result a recipe, as validate_recipes() has it. An effect that is left out of a reduced recipe alone is reported with
/// what is off there.
std::vector<ValidRecipe> validate_states(const std::vector<StateRecipe>& recipes, const ComposeInput& input,
                                         const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                                         ValidationStatistics& statistics);

}  // namespace plugc
