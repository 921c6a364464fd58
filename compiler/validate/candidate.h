#pragma once
// A program on its way to being valid: a recipe, what composing made of it and what glslang said.

#include <cstddef>
#include <vector>

#include "compose/compose.h"
#include "validate/fault_report.h"
#include "validate/validate.h"
#include "validate/validate_recipes.h"

namespace plugc {

struct ProgramCandidate {
  Recipe recipe;
  Target target = Target::glsl330;
  bool optimize = false;
  ComposedProgram composed;  ///< Its texts have moved on once it is validated.
  ValidationResult result;
};

/// Composes and validates candidates, and counts how often.
class CandidateChecker {
 public:
  CandidateChecker(const ComposeInput& input, Validator& validator, ValidationStatistics& statistics)
      : input_(input), validator_(validator), statistics_(statistics) {}

  /// Composes. Effects that composing itself finds at fault (their mistakes are reported by then) are left out of the
  /// recipe, and those that need them.
  void compose_candidate(ProgramCandidate& candidate, Diagnostics& diagnostics);
  void validate(std::vector<ProgramCandidate>& candidates);
  /// Both, for one more program.
  ProgramCandidate recheck(Recipe recipe, Target target, Diagnostics& diagnostics);

  /// The recipe without these effects, and without the ComposedShader when `shader_gone`. What may be wrong in their texts is
  /// reported, and so are those that need them, which go too.
  Recipe without(const ProgramCandidate& candidate, const std::set<int>& gone, bool shader_gone,
                 Diagnostics& diagnostics) const;

  const Scene& scene() const { return input_.scene; }
  std::size_t rechecks() const { return statistics_.rechecks; }

 private:
  const ComposeInput& input_;
  Validator& validator_;
  ValidationStatistics& statistics_;
};

}  // namespace plugc
