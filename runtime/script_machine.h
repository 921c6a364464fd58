#pragma once
// Runs the code of Scripts. Whatever the code is, a function ends soon and holds no more memory than a bound.

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "runtime/script_values.h"

namespace plugc {

/// What a Script remembers from one event to the next.
struct ScriptMemory {
  std::vector<ScriptValue> variables;  ///< Empty before it has started.
  std::uint64_t random = 0;            ///< The same numbers each time that a scene is played.
  bool stopped = false;                ///< By a fault; it never runs again.
  std::string message;                 ///< The first thing that is to be said of it, with the line.
};

/// Every variable as the package has it.
void start_script(const PackedScript& script, ScriptMemory& memory);

/// Runs a function on what has come, and notes the variables that it stores to. A fault ends it, and is noted in `memory`; what
/// was stored before stays.
void run_script_function(const PackedScript& script, const PackedScriptFunction& function, std::span<const double> value,
                         double time, ScriptMemory& memory, std::set<std::uint32_t>& stored);

}  // namespace plugc
