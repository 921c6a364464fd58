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
  bool started = false;
  std::vector<ScriptValue> variables;
  std::size_t held = 0;      ///< Numbers in them.
  std::uint64_t random = 0;  ///< The same numbers each time that a scene is played.
  bool stopped = false;      ///< By a fault; it never runs again.
  std::string message;       ///< The first thing that is to be said of it, with the line.
};

/// A Script that runs.
struct AwakeScript {
  const PackedScript& script;
  ScriptMemory& memory;
  std::uint64_t& work_left;             ///< Of kMaxFrameScriptWork. Whoever wants more is stopped.
  std::set<std::uint32_t> stored = {};  ///< Variables that its functions have stored to.
};

/// Every variable as the package has it.
void start_script(const PackedScript& script, ScriptMemory& memory);

/// A variable takes what an event has brought.
void give_script(AwakeScript& awake, std::uint32_t variable, std::span<const double> value);

/// Runs a function on what has come. A fault ends it, and is noted in the memory; what was stored before stays.
void run_script_function(AwakeScript& awake, const PackedScriptFunction& function, std::span<const double> value, double time);

}  // namespace plugc
