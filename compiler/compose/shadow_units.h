#pragma once
// Which files of stdlib_plugs/shadows/ make up the shadow of a light.

#include <string_view>
#include <vector>

#include "compose/recipe.h"
#include "compose/templates.h"

namespace plugc {

struct ShadowUnit {
  std::string_view file;  ///< As TemplateLibrary::get() takes it.
  Features features;
};

/// In the order of their calls. A target without gathers gets look-ups in their place, of the same values.
std::vector<ShadowUnit> shadow_units(const LightRecipe& light, Target target);

/// The fragment stage of a pass over a map.
std::vector<ShadowUnit> map_pass_units(MapPass pass);

}  // namespace plugc
