#pragma once
// A fragment stage with several outputs must say where each goes (GLSL ES 3.00, 4.3.8.2; in GLSL 3.30 the linker would choose).
// Internal to the compose room.

#include "compose/placed_unit.h"

namespace plugc {

/// Gives locations to outputs that have none: 0 to castle_FragColor, which is the picture, then in text order what is free.
/// Names must be final.
void note_output_locations(Composition& composition);

/// `layout(location = 1) ` in front of an output's declaration; "" where it needs none.
std::string location_text(const Composition& composition, std::string_view final_name);

}  // namespace plugc
