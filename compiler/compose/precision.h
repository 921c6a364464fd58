#pragma once
// A uniform that two stages declare is one uniform, so its precision must be one too (GLSL ES 3.00, 4.3.5; glslang asks it of
// GLSL 3.30 as well): the higher of those that are written, where `highp` stands for none.

#include <optional>

#include "compose/placed_unit.h"

namespace plugc {

/// `lowp`, `mediump` or `highp` in front of a global's type.
std::optional<Token> precision_word(const CodeUnit& code, const GlobalOutline& global);

/// Notes the uniforms whose precisions differ, with the word that all get; names must be final.
void note_precisions(Composition& composition);

}  // namespace plugc
