#pragma once
// What plugc makes of a written set, in the words of the second composer: its messages, and the trace of one run through each
// composed program.

#include <set>
#include <string>

#include "compose/compose.h"
#include "oracle/specification.h"

namespace plugc::oracle {

/// Runs all phases up to composing, in memory. Nothing is validated.
Outcome observe_outcome(const std::string& scene);

/// What all phases say, validation included; a program that glslang refuses says more than composing does.
std::set<std::string> observe_messages(const std::string& scene);

/// The trace of a composed program.
ProgramTrace trace_of(const ComposedProgram& program, const Scene& scene);

}  // namespace plugc::oracle
