#pragma once
// What a uniform starts with where its declaration says so: `uniform vec3 tint = vec3(1.0, 0.5, 0.25);`. Targets without
// such initialisers get the value from the package, and so does a uniform of a program that another shape has set before.

#include <optional>
#include <vector>

#include "compose/code_unit.h"

namespace plugc {

/// The numbers of the initialiser: literals, constructors, the four operations, constants and macros of the same part (GLSL
/// 3.30, 4.3.3, without functions). Matrices stand column by column, booleans are 0 and 1. nullopt for anything else.
std::optional<std::vector<double>> initial_value(const CodeUnit& code, const GlobalOutline& global);

}  // namespace plugc
