#pragma once
// What of a shape may be switched while it is drawn (effects by `enabled`, lights by `on` or by a Switch above them), and
// the programs that it then needs. A package has a program for every state that can occur, so that nothing is compiled
// while a scene is drawn.

#include <cstdint>
#include <vector>

#include "compose/recipe.h"

namespace plugc {

/// Of one shape. With more than that, its switches stand in one program.
inline constexpr std::size_t kMaxShapePrograms = 8;

struct ShapeSwitch {
  bool of_light = false;
  int index = -1;  ///< Into Scene::effects or Scene::lights.
};

/// A recipe, and which it is a reduction of.
struct StateRecipe {
  Recipe recipe;
  int fuller = -1;  ///< Into the same list: one with more switched on; -1: none, this is such a one.
};

struct ShapeStates {
  std::vector<ShapeSwitch> switches;  ///< Number i is on where bit i of a state is set.
  std::vector<std::uint8_t> states;   ///< By state: into `recipes`. A state that cannot occur has number 0.
  std::vector<StateRecipe> recipes;   ///< Each once; the first has most switched on.
};

ShapeStates make_shape_states(const Scene& scene, const SceneShape& shape, const ShapeFacts& facts,
                              const std::vector<EffectCode>& codes);

}  // namespace plugc
