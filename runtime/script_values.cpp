// Arithmetic goes number by number; the rest takes values whole.

#include "runtime/script_values.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "runtime/rotations.h"
#include "runtime/world.h"

namespace plugc {
namespace {

using Op = PackedScriptOp;
using Arguments = std::span<const ScriptValue>;

ScriptResult fault(std::string words) {
  return {{}, std::move(words)};
}

ScriptResult misfit() {
  return fault("its code is damaged: values do not fit together");
}

ScriptResult number(double value) {
  return {{value}, ""};
}

// ---- numbers ----

using UnaryFunction = double (*)(double);
using BinaryFunction = double (*)(double, double);

/// Null for what is no function of one number.
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

ScriptResult by_numbers(BinaryFunction function, Arguments arguments) {
  ScriptResult made{arguments[0], ""};
  std::transform(made.value.begin(), made.value.end(), arguments[1].begin(), made.value.begin(), function);
  return made;
}

/// The remainder has the sign of what is divided; a whole number has no infinity to stand for a division by zero.
ScriptResult apply_to_whole_numbers(Op op, double x, double y) {
  if (op == Op::modulo) return y == 0 ? fault("it divides by zero") : number(std::fmod(x, y));
  if (x < 0 || y < 0) return fault("powers of whole numbers are only those of 0 and more");
  return number(std::pow(x, y));
}

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

ScriptResult multiply(const ScriptValue& left, const ScriptValue& right) {
  if (left.size() == 1) return scale(right, left[0]);
  if (right.size() == 1) return scale(left, right[0]);
  for (const std::size_t side : {std::size_t{3}, std::size_t{4}}) {
    if (left.size() == side * side && (right.size() == side || right.size() == side * side))
      return {multiply_columns(left, right, side), ""};
  }
  return misfit();
}

ScriptResult divide(ScriptValue value, const ScriptValue& by) {
  if (by.size() != 1) return misfit();
  for (double& each : value) each /= by[0];
  return {std::move(value), ""};
}

ScriptResult lerp(Arguments arguments) {
  if (arguments[0].size() != 1 || arguments[1].size() != arguments[2].size()) return misfit();
  ScriptResult made{arguments[1], ""};
  for (std::size_t i = 0; i < made.value.size(); ++i) made.value[i] += arguments[0][0] * (arguments[2][i] - arguments[1][i]);
  return made;
}

/// In the order of the first numbers that differ, as texts are; nothing orders NaN.
ScriptResult compare(Op op, Arguments arguments) {
  const std::partial_ordering order = arguments[0] <=> arguments[1];
  switch (op) {
    case Op::equal: return number(order == 0);
    case Op::not_equal: return number(order != 0);
    case Op::less: return number(order < 0);
    case Op::less_equal: return number(order <= 0);
    case Op::greater: return number(order > 0);
    default: return number(order >= 0);
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
  if (end.size() != 1) return misfit();
  if (!(end[0] >= 1)) return fault(fmt::format("there is no random integer below {}", end[0]));
  return number(std::floor(next_random(state) * end[0]));
}

// ---- lists ----

/// Where the element of that index begins; nullopt outside of the list.
std::optional<std::size_t> element_begin(const ScriptValue& list, const ScriptValue& index, std::size_t width) {
  const double last = std::floor(static_cast<double>(list.size()) / static_cast<double>(width)) - 1;
  if (index.size() != 1 || !(index[0] >= 0 && index[0] <= last)) return std::nullopt;
  return static_cast<std::size_t>(index[0]) * width;
}

ScriptResult out_of_range(const ScriptValue& list, const ScriptValue& index, std::size_t width) {
  return fault(
      fmt::format("it asks for element {} of {}, counted from 0", index.empty() ? 0.0 : index[0], list.size() / width));
}

ScriptResult element(const ScriptValue& list, const ScriptValue& index, std::size_t width) {
  const auto begin = element_begin(list, index, width);
  if (!begin) return out_of_range(list, index, width);
  const auto first = list.begin() + static_cast<std::ptrdiff_t>(*begin);
  return {{first, first + static_cast<std::ptrdiff_t>(width)}, ""};
}

ScriptResult replace(ScriptValue list, const ScriptValue& index, const ScriptValue& value, std::size_t width) {
  const auto begin = element_begin(list, index, width);
  if (!begin) return out_of_range(list, index, width);
  if (value.size() != width) return fault("it puts into a text what is not one character");
  std::ranges::copy(value, list.begin() + static_cast<std::ptrdiff_t>(*begin));
  return {std::move(list), ""};
}

ScriptResult resize(ScriptValue list, const ScriptValue& count, std::size_t width) {
  if (count.size() != 1) return misfit();
  const double numbers = count[0] * static_cast<double>(width);
  if (!(numbers >= 0)) return fault(fmt::format("no list has {} elements", count[0]));
  if (numbers > static_cast<double>(kMaxScriptNumbers)) return fault("its lists grow beyond all bounds");
  list.resize(static_cast<std::size_t>(numbers), 0.0);
  return {std::move(list), ""};
}

ScriptResult join(Arguments arguments) {
  ScriptResult made;
  for (const ScriptValue& one : arguments) made.value.insert(made.value.end(), one.begin(), one.end());
  return made;
}

ScriptResult text(std::string_view words) {
  ScriptResult made;
  for (const char c : words) made.value.push_back(static_cast<unsigned char>(c));
  return made;
}

// ---- vectors and rotations ----

glm::dvec3 vector(const ScriptValue& value) {
  return {value[0], value[1], value[2]};
}

ScriptResult numbers(const glm::dvec3& v) {
  return {{v.x, v.y, v.z}, ""};
}

double dot(const ScriptValue& a, const ScriptValue& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

ScriptResult rotate(const ScriptValue& rotation, const glm::dvec3& point) {
  return numbers(to_quaternion(rotation) * point);
}

/// The rotation that carries (0, 0, -1) and (0, 1, 0) there.
ScriptResult orientation(const glm::dvec3& direction, const glm::dvec3& up) {
  const View view = look_along(glm::dvec3(0), direction, up);
  return {axis_and_angle(glm::quat_cast(glm::dmat3(view.eye_to_world))), ""};
}

ScriptResult slerp(double weight, const ScriptValue& from, const ScriptValue& to) {
  return {axis_and_angle(glm::slerp(to_quaternion(from), to_quaternion(to), weight)), ""};
}

/// How many numbers each argument must have, for what takes vectors; empty for all else.
std::vector<std::size_t> vector_sizes(Op op) {
  switch (op) {
    case Op::cross: return {3, 3};
    case Op::grayscale: return {3};
    case Op::rotate: return {4, 3};
    case Op::direction:
    case Op::up: return {4};
    case Op::orientation: return {3, 3};
    case Op::slerp: return {1, 4, 4};
    default: return {};
  }
}

ScriptResult apply_to_vectors(Op op, Arguments arguments) {
  const std::vector<std::size_t> sizes = vector_sizes(op);
  if (!std::ranges::equal(arguments, sizes, {}, &ScriptValue::size)) return misfit();
  switch (op) {
    case Op::cross: return numbers(glm::cross(vector(arguments[0]), vector(arguments[1])));
    case Op::grayscale: return number(glm::dot(vector(arguments[0]), glm::dvec3(0.212671, 0.71516, 0.072169)));
    case Op::rotate: return rotate(arguments[0], vector(arguments[1]));
    case Op::direction: return rotate(arguments[0], {0, 0, -1});
    case Op::up: return rotate(arguments[0], {0, 1, 0});
    case Op::orientation: return orientation(vector(arguments[0]), vector(arguments[1]));
    default: return slerp(arguments[0][0], arguments[1], arguments[2]);
  }
}

}  // namespace

std::size_t argument_count(Op op, std::uint32_t operand) {
  switch (op) {
    case Op::load:
    case Op::jump:
    case Op::random: return 0;
    case Op::join: return operand;
    case Op::replace:
    case Op::lerp:
    case Op::slerp: return 3;
    case Op::element:
    case Op::resize:
    case Op::multiply:
    case Op::divide:
    case Op::equal:
    case Op::not_equal:
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal:
    case Op::dot:
    case Op::cross:
    case Op::rotate:
    case Op::orientation: return 2;
    default: return binary_function(op) != nullptr ? 2 : 1;
  }
}

ScriptResult apply_step(Op op, std::uint32_t operand, Arguments arguments, std::uint64_t& random) {
  const std::size_t width = std::max<std::size_t>(operand, 1);
  switch (op) {
    case Op::join: return join(arguments);
    case Op::count: return number(static_cast<double>(arguments[0].size() / width));
    case Op::element: return element(arguments[0], arguments[1], width);
    case Op::replace: return replace(arguments[0], arguments[1], arguments[2], width);
    case Op::resize: return resize(arguments[0], arguments[1], width);
    case Op::multiply: return multiply(arguments[0], arguments[1]);
    case Op::divide: return divide(arguments[0], arguments[1]);
    case Op::lerp: return lerp(arguments);
    case Op::equal:
    case Op::not_equal:
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal: return compare(op, arguments);
    case Op::random: return number(next_random(random));
    case Op::random_below: return random_below(arguments[0], random);
    case Op::text_of_number: return text(fmt::format("{:.15g}", arguments[0].empty() ? 0.0 : arguments[0][0]));
    case Op::text_of_boolean: return text(arguments[0] == ScriptValue{0.0} ? "false" : "true");
    case Op::length: return number(std::sqrt(dot(arguments[0], arguments[0])));
    case Op::square_length: return number(dot(arguments[0], arguments[0]));
    default: break;
  }
  if (const UnaryFunction function = unary_function(op)) {
    ScriptResult made{arguments[0], ""};
    std::ranges::transform(made.value, made.value.begin(), function);
    return made;
  }
  if (!vector_sizes(op).empty()) return apply_to_vectors(op, arguments);
  if (arguments.size() != 2 || arguments[0].size() != arguments[1].size()) return misfit();
  if (op == Op::dot) return number(dot(arguments[0], arguments[1]));
  if (operand == 1 && (op == Op::modulo || op == Op::power) && arguments[0].size() == 1)
    return apply_to_whole_numbers(op, arguments[0][0], arguments[1][0]);
  const BinaryFunction function = binary_function(op);
  return function == nullptr ? misfit() : by_numbers(function, arguments);
}

}  // namespace plugc
