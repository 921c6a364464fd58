#pragma once
// Which parts of the templates that shade - the base shader's and the lights' - a recipe needs.

#include <set>
#include <string_view>

#include "compose/placed_unit.h"
#include "compose/templates.h"

namespace plugc {

/// castle_ names in the code of the effects and of the ComposedShader of a program.
using UsedNames = std::set<std::string_view>;

/// Of the base shader, phong or gouraud, and of depth.vert.
Features base_features(const Recipe& recipe, const UsedNames& names);

/// Of light.glsl. `base_adds_lights`: the base shader has the plug `add_light`, and not only its older form.
Features light_features(const Composition& composition, const LightRecipe& light, bool base_adds_lights);

}  // namespace plugc
