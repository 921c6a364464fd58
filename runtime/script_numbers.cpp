// Arithmetic, number by number, and matrices.

#include <algorithm>
#include <cmath>
#include <compare>

#include <fmt/format.h>

#include "runtime/script_operations.h"

namespace plugc {

using Op = PackedScriptOp;

UnaryFunction unary_function(Op op) {
  switch (op) {
    case Op::negate: return [](double x) { return -x; };
    case Op::not_: return [](double x) { return x == 0 ? 1.0 : 0.0; };
    case Op::not_zero: return [](double x) { return x != 0 ? 1.0 : 0.0; };
    case Op::sin: return [](double x) { return std::sin(x); };
    case Op::cos: return [](double x) { return std::cos(x); };
    case Op::tan: return [](double x) { return std::tan(x); };
    case Op::cotan: return [](double x) { return 1 / std::tan(x); };
    case Op::arcsin: return [](double x) { return std::asin(x); };
    case Op::arccos: return [](double x) { return std::acos(x); };
    case Op::arctan: return [](double x) { return std::atan(x); };
    case Op::arccotan: return [](double x) { return std::atan(1 / x); };
    case Op::sinh: return [](double x) { return std::sinh(x); };
    case Op::cosh: return [](double x) { return std::cosh(x); };
    case Op::tanh: return [](double x) { return std::tanh(x); };
    case Op::cotanh: return [](double x) { return 1 / std::tanh(x); };
    case Op::exp: return [](double x) { return std::exp(x); };
    case Op::exp2: return [](double x) { return std::exp2(x); };
    case Op::ln: return [](double x) { return std::log(x); };
    case Op::log2: return [](double x) { return std::log2(x); };
    case Op::square: return [](double x) { return x * x; };
    case Op::sqrt: return [](double x) { return std::sqrt(x); };
    case Op::sign: return [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; };
    case Op::abs: return [](double x) { return std::abs(x); };
    case Op::truncate: return [](double x) { return std::trunc(x); };
    case Op::floor: return [](double x) { return std::floor(x); };
    case Op::ceil: return [](double x) { return std::ceil(x); };
    case Op::round: return [](double x) { return std::nearbyint(x); };  // halves to the even number
    default: return nullptr;
  }
}

BinaryFunction binary_function(Op op) {
  switch (op) {
    case Op::add: return [](double x, double y) { return x + y; };
    case Op::subtract: return [](double x, double y) { return x - y; };
    case Op::power: return [](double x, double y) { return std::pow(x, y); };
    case Op::log: return [](double base, double x) { return std::log(x) / std::log(base); };
    case Op::modulo: return [](double x, double y) { return x - std::floor(x / y) * y; };
    case Op::least: return [](double x, double y) { return std::min(x, y); };
    case Op::greatest: return [](double x, double y) { return std::max(x, y); };
    default: return nullptr;
  }
}

ScriptResult by_numbers(UnaryFunction function, ScriptValue value) {
  std::ranges::transform(value, value.begin(), function);
  return {std::move(value), ""};
}

ScriptResult by_numbers(BinaryFunction function, ScriptArguments arguments) {
  ScriptResult made{arguments[0], ""};
  std::transform(made.value.begin(), made.value.end(), arguments[1].begin(), made.value.begin(), function);
  return made;
}

/// The remainder has the sign of what is divided; a whole number has no infinity to stand for a division by zero.
ScriptResult apply_to_whole_numbers(Op op, double x, double y) {
  if (op == Op::modulo) return y == 0 ? script_fault("it divides by zero") : script_number(std::fmod(x, y));
  if (x < 0 || y < 0) return script_fault("powers of whole numbers are only those of 0 and more");
  return script_number(std::pow(x, y));
}

namespace {

ScriptResult scale(ScriptValue value, double factor) {
  for (double& each : value) each *= factor;
  return {std::move(value), ""};
}

/// Of square matrices of `side` columns, or of one and a vector.
ScriptValue multiply_columns(const ScriptValue& matrix, const ScriptValue& columns, std::size_t side) {
  ScriptValue product(columns.size(), 0.0);
  for (std::size_t i = 0; i < product.size(); ++i) {
    const std::size_t column = i / side * side;
    for (std::size_t k = 0; k < side; ++k) product[i] += matrix[k * side + i % side] * columns[column + k];
  }
  return product;
}

}  // namespace

ScriptResult multiply(const ScriptValue& left, const ScriptValue& right) {
  if (left.size() == 1) return scale(right, left[0]);
  if (right.size() == 1) return scale(left, right[0]);
  for (const std::size_t side : {std::size_t{3}, std::size_t{4}}) {
    if (left.size() == side * side && (right.size() == side || right.size() == side * side))
      return {multiply_columns(left, right, side), ""};
  }
  return script_misfit();
}

ScriptResult divide(ScriptValue value, const ScriptValue& by) {
  if (by.size() != 1) return script_misfit();
  for (double& each : value) each /= by[0];
  return {std::move(value), ""};
}

ScriptResult lerp(ScriptArguments arguments) {
  if (arguments[0].size() != 1 || arguments[1].size() != arguments[2].size()) return script_misfit();
  ScriptResult made{arguments[1], ""};
  for (std::size_t i = 0; i < made.value.size(); ++i) made.value[i] += arguments[0][0] * (arguments[2][i] - arguments[1][i]);
  return made;
}

/// In the order of the first numbers that differ, as texts are; nothing orders NaN.
ScriptResult compare(Op op, ScriptArguments arguments) {
  const std::partial_ordering order = arguments[0] <=> arguments[1];
  switch (op) {
    case Op::equal: return script_number(order == 0);
    case Op::not_equal: return script_number(order != 0);
    case Op::less: return script_number(order < 0);
    case Op::less_equal: return script_number(order <= 0);
    case Op::greater: return script_number(order > 0);
    default: return script_number(order >= 0);
  }
}

/// Steele, Lea and Flood's SplitMix64: short, and the same on every machine. In [0, 1).
double next_random(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15U;
  std::uint64_t mixed = state;
  mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
  return std::ldexp(static_cast<double>((mixed ^ (mixed >> 31U)) >> 11U), -53);
}

ScriptResult random_below(const ScriptValue& end, std::uint64_t& state) {
  if (end.size() != 1) return script_misfit();
  if (!(end[0] >= 1)) return script_fault(fmt::format("there is no random integer below {}", end[0]));
  return script_number(std::floor(next_random(state) * end[0]));
}

}  // namespace plugc
