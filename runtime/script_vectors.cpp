// Vectors of three numbers and rotations.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "runtime/rotations.h"
#include "runtime/script_operations.h"
#include "runtime/world.h"

namespace plugc {

using Op = PackedScriptOp;

namespace {

glm::dvec3 vector(const ScriptValue& value) {
  return {value[0], value[1], value[2]};
}

ScriptResult numbers(const glm::dvec3& v) {
  return {{v.x, v.y, v.z}, ""};
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

}  // namespace

double dot(const ScriptValue& a, const ScriptValue& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::span<const std::size_t> vector_sizes(Op op) {
  static constexpr std::array<std::size_t, 2> kVectors = {3, 3}, kTurned = {4, 3};
  static constexpr std::array<std::size_t, 1> kVector = {3}, kRotation = {4};
  static constexpr std::array<std::size_t, 3> kRotations = {1, 4, 4};
  switch (op) {
    case Op::cross:
    case Op::orientation: return kVectors;
    case Op::grayscale: return kVector;
    case Op::rotate: return kTurned;
    case Op::direction:
    case Op::up: return kRotation;
    case Op::slerp: return kRotations;
    default: return {};
  }
}

ScriptResult apply_to_vectors(Op op, ScriptArguments arguments) {
  if (!std::ranges::equal(arguments, vector_sizes(op), {}, &ScriptValue::size)) return script_misfit();
  switch (op) {
    case Op::cross: return numbers(glm::cross(vector(arguments[0]), vector(arguments[1])));
    case Op::grayscale: return script_number(glm::dot(vector(arguments[0]), glm::dvec3(0.212671, 0.71516, 0.072169)));
    case Op::rotate: return rotate(arguments[0], vector(arguments[1]));
    case Op::direction: return rotate(arguments[0], {0, 0, -1});
    case Op::up: return rotate(arguments[0], {0, 1, 0});
    case Op::orientation: return orientation(vector(arguments[0]), vector(arguments[1]));
    default: return slerp(arguments[0][0], arguments[1], arguments[2]);
  }
}

}  // namespace plugc
