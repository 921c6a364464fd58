#pragma once
// From a line and a token of composed text to the author's place.

#include "validate/verdict.h"

namespace plugc {

ShaderMessage place_message(const VerdictMessage& message, const ProgramText& program);

}  // namespace plugc
