#pragma once
// Composes recipes, has them validated, and where one fails finds the effect that is at fault and leaves it out alone.

#include <vector>

#include "compose/compose.h"
#include "validate/validate.h"

namespace plugc {

/// A recipe's program for one target.
struct TargetProgram {
  ValidatedProgram program;
  ComposedProgram composed;  ///< Its texts have moved into `program`.
};

struct ValidRecipe {
  Recipe used;                         ///< The recipe without what was left out.
  std::vector<TargetProgram> targets;  ///< In the order of the targets asked for; those that failed are missing.
};

/// How much composing and validating took, for `./dev demo` and the benchmark.
struct ValidationStatistics {
  double compose_milliseconds = 0;
  double validate_milliseconds = 0;
  std::size_t compositions = 0;
  std::size_t rechecks = 0;  ///< Programs composed anew to find a fault.
};

/// What recipes are made into.
struct ProgramOptions {
  std::vector<Target> targets;
  bool optimize = false;  ///< What cannot be optimised stays as composed (reported).
};

/// One result a recipe. At most kMaxRechecks programs are checked to find the faults of one recipe.
inline constexpr std::size_t kMaxRechecks = 64;
std::vector<ValidRecipe> validate_recipes(const std::vector<Recipe>& recipes, const ComposeInput& input,
                                          const ProgramOptions& options, Validator& validator, Diagnostics& diagnostics,
                                          ValidationStatistics& statistics);

}  // namespace plugc
