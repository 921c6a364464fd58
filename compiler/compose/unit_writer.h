#pragma once
// One placed unit as text: markers have become calls, prototypes stand in front, repeated declarations are gone, names are
// final. Internal to the compose room.

#include "compose/unit_draft.h"

namespace plugc {

/// Puts the unit behind what the stage has already.
void write_unit(Composition& composition, const PlacedUnit& unit, Declared& declared, MappedText& stage);

}  // namespace plugc
