#pragma once
// What a mutant's messages are worth.

#include <string>
#include <vector>

#include "mutants/check_scene.h"
#include "mutants/mutate.h"

namespace plugc::mutants {

/// How the compiler took a mutant. The law: of those refused, nearly all are named, and all that is said is in place.
struct Judgement {
  bool refused = false;              ///< Something is wrong that was not wrong before.
  bool died = false;                 ///< The validating process crashed or overran.
  bool named = false;                ///< An error stands at the mutated node or in its code.
  bool placed = false;               ///< ... in the mutated part, at the mutated token's line or behind it.
  bool exact = false;                ///< ... at the very line.
  bool uncaused = false;             ///< An effect that needed the mutated one is told to be at fault, and not why.
  std::vector<std::string> outside;  ///< Errors elsewhere that name no cause.
  std::vector<std::string> lost;     ///< Other authors whose code is missing, without a consequence being reported.
};

/// `before` is the scene as it was, `after` the same with the mutation.
Judgement judge(const CheckedScene& before, const CheckedScene& after, const Mutation& mutation);

/// The authors whose code holds the place.
Authors authors_at(const CheckedScene& scene, const Span& place);

}  // namespace plugc::mutants
