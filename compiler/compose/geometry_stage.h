#pragma once
// The geometry stage of a program (thesis, chapter 6). It is there when a `GEOMETRY` part has a `main`; else all parts of that
// type are dropped. Internal to the compose room.

#include "compose/placed_unit.h"

namespace plugc {

/// Whether the program has a geometry stage. Where the target has none, effects that bring one are reported and left out.
bool wants_geometry_stage(Composition& composition);

/// When all parts are placed: finds the one `main` and checks that it takes what the shape is drawn as, then places the
/// functions that it calls and the code that passes varyings on. False when no `main` can stay (reported, and its effect
/// marked): what else would be found wrong now may be right without a geometry stage.
bool place_geometry_stage(Composition& composition);

/// When all names are final: what fragment code calls a passed varying.
void note_passed_varyings(Composition& composition);

}  // namespace plugc
