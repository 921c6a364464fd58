#pragma once
// What the steps of a script make of values (PackedScriptOp), beside variables and jumps. A package may hold any steps, so what
// does not fit together is a fault, not undefined.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "package/package_file.h"

namespace plugc {

using ScriptValue = std::vector<double>;

/// Why a step has no result, in words; "" where it has one.
struct ScriptResult {
  ScriptValue value;
  std::string fault;
};

/// How many values the step takes from the stack.
std::size_t argument_count(PackedScriptOp op, std::uint32_t operand);

/// `arguments` has as many. `random` is what the random numbers come of; it moves on.
ScriptResult apply_step(PackedScriptOp op, std::uint32_t operand, std::span<const ScriptValue> arguments,
                        std::uint64_t& random);

}  // namespace plugc
