#pragma once
// What steps of a script do, by topic. Internal: script_values.cpp says which step does which, and that there are as many
// arguments as it takes; of what sizes they are is looked at here.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/script_values.h"

namespace plugc {

using ScriptArguments = std::span<const ScriptValue>;

inline ScriptResult script_fault(std::string words) {
  return {{}, std::move(words)};
}
inline ScriptResult script_misfit() {
  return script_fault("its code is damaged: values do not fit together");
}
inline ScriptResult script_number(double value) {
  return {{value}, ""};
}

// Numbers (script_numbers.cpp)

using UnaryFunction = double (*)(double);
using BinaryFunction = double (*)(double, double);
/// Null for what is no function of one number, of two.
UnaryFunction unary_function(PackedScriptOp op);
BinaryFunction binary_function(PackedScriptOp op);
ScriptResult by_numbers(UnaryFunction function, ScriptValue value);
/// Both are of one size.
ScriptResult by_numbers(BinaryFunction function, ScriptArguments arguments);
/// modulo and power of two numbers.
ScriptResult apply_to_whole_numbers(PackedScriptOp op, double x, double y);
ScriptResult multiply(const ScriptValue& left, const ScriptValue& right);
ScriptResult divide(ScriptValue value, const ScriptValue& by);
ScriptResult lerp(ScriptArguments arguments);
/// equal to greater_equal.
ScriptResult compare(PackedScriptOp op, ScriptArguments arguments);
/// In [0, 1).
double next_random(std::uint64_t& state);
ScriptResult random_below(const ScriptValue& end, std::uint64_t& state);

// Lists and texts (script_lists.cpp); `width`: numbers of an element

ScriptResult element(const ScriptValue& list, const ScriptValue& index, std::size_t width);
ScriptResult replace(ScriptValue list, const ScriptValue& index, const ScriptValue& value, std::size_t width);
ScriptResult resize(ScriptValue list, const ScriptValue& count, std::size_t width);
ScriptResult join(ScriptArguments arguments);
ScriptResult script_text(std::string_view words);

// Vectors and rotations (script_vectors.cpp)

/// How many numbers each argument must have, for what takes vectors; empty for all else.
std::span<const std::size_t> vector_sizes(PackedScriptOp op);
/// vector_sizes() has some.
ScriptResult apply_to_vectors(PackedScriptOp op, ScriptArguments arguments);
/// Both are of one size.
double dot(const ScriptValue& a, const ScriptValue& b);

}  // namespace plugc
