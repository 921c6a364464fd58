#pragma once
// Shadows that can never fall, found where the light, what receives and what casts stand still for good: their programs need
// no code for them.

#include <vector>

#include "compose/code_unit.h"
#include "package/assemble_package.h"

namespace plugc {

/// Takes lights out of `receives` of shapes that nothing can stand before, seen from the light. Whatever a ROUTE, the host, an
/// effect or a ComposedShader may move stands everywhere. `parts` has its meshes, and knows which shapes are blended.
void drop_impossible_shadows(const std::vector<EffectCode>& effects, SceneParts& parts);

/// Whether some shape looks into a shadow map, so that casters need programs to be drawn into it.
bool needs_casters(const Scene& scene);

}  // namespace plugc
