#pragma once
// Prototypes that plugc writes. Parameters have their types alone, or names of plugc's, which no macro of another part can
// touch. Internal to the compose room.

#include <string>

#include "compose/placed_unit.h"

namespace plugc {

/// `void PLUG_light_scale_2(inout float, const in vec3);` and a line end.
std::string plug_prototype(const Composition& composition, const PlugCall& call);

/// What follows `float noise(vec3 p);` in a unit when another owner defines it as `target`, `noise_2`:
/// `float noise_2(in vec3); float noise(in vec3 argument_0) { return noise_2(argument_0); }`.
std::string forwarding_text(const Composition& composition, const PlacedUnit& unit, const FunctionOutline& prototype,
                            std::string_view target);

}  // namespace plugc
