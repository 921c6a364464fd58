#pragma once
// What bind_names goes through beside functions (bind_functions.h) and inputs (bind_inputs.h). Internal to the compose room.

#include "compose/placed_unit.h"

namespace plugc {

/// Reports declarations of one variable that differ between stages.
void compare_stages(Composition& composition);

/// Fills ComposedProgram::fields: the uniforms of authors, and what feeds them. Names must be final.
void list_fields(Composition& composition);

}  // namespace plugc
