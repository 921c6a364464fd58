#pragma once
// What the programs of all targets read together. An effect may be left out of one target alone; then a name may mean another
// effect's field there. Internal to the package room.

#include <vector>

#include "validate/validate_recipes.h"

namespace plugc {

/// What composing noted of a uniform; what feeds a uniform without a note follows from its name.
struct UniformNote {
  const FieldUniform* field = nullptr;
  const SwitchUniform* switched = nullptr;
};

/// A uniform of the targets that read the same under its name.
struct UniformOfTargets {
  ReflectedVariable variable;
  UniformNote fed;
  unsigned targets = 0;  ///< As PackedUniform::targets.
};

/// In the order of targets and names. The notes point into `recipe`.
std::vector<UniformOfTargets> all_uniforms(const ValidRecipe& recipe);

/// The vertex inputs of all targets, each name once.
std::vector<ReflectedVariable> all_attributes(const ValidRecipe& recipe);

}  // namespace plugc
