#pragma once
// glslang in this process: a candidate in, a verdict out. Called in the worker only, because a hostile text can make
// glslang crash or run for ever.

#include "validate/verdict.h"

namespace plugc {

/// Loads glslang and builds its built-in tables for a target, which is most of the time of a first program.
void warm_up(Target target);

Verdict judge(const Candidate& candidate);

}  // namespace plugc
