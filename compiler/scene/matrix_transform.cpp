// MatrixTransform, the engine's node, as the fields of a Transform that does the same. Any matrix M of 3 x 3 is R (SR S SR^-1):
// with the eigenvectors V of M^T M, which Jacobi's rotations find, M V has orthogonal columns as long as the scales; R is what
// turns V into their directions, and SR is V. A mirroring matrix has one negative scale.

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scene/scene_context.h"

namespace plugc {
namespace {

/// One turn in the plane of axes p and q that makes the element of both vanish.
void turn_once(glm::dmat3& matrix, glm::dmat3& vectors, int p, int q) {
  if (matrix[p][q] == 0) return;
  const double angle = 0.5 * std::atan2(2 * matrix[p][q], matrix[q][q] - matrix[p][p]);
  glm::dmat3 turn(1.0);
  turn[p][p] = turn[q][q] = std::cos(angle);
  turn[q][p] = std::sin(angle);
  turn[p][q] = -turn[q][p];
  matrix = glm::transpose(turn) * matrix * turn;
  vectors = vectors * turn;
}

/// The eigenvectors of a symmetric matrix as columns of a rotation.
glm::dmat3 eigenvectors(glm::dmat3 symmetric) {
  constexpr int kSweeps = 12;  // each squares what is left beside the diagonal
  glm::dmat3 vectors(1.0);
  for (int i = 0; i < kSweeps; ++i) {
    turn_once(symmetric, vectors, 0, 1);
    turn_once(symmetric, vectors, 0, 2);
    turn_once(symmetric, vectors, 1, 2);
  }
  return vectors;
}

/// Some unit vector across the given one.
glm::dvec3 across(const glm::dvec3& v) {
  const glm::dvec3 helper = std::abs(v.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(v, helper));
}

struct Parts {
  glm::dmat3 rotation{1.0}, scale_orientation{1.0};
  glm::dvec3 scale{1};
};

/// A scale of nothing leaves its direction open: it is what makes a rotation of the others.
Parts take_apart(const glm::dmat3& matrix) {
  constexpr double kNothing = 1e-12;  // of the largest scale
  Parts parts;
  glm::dmat3 v = eigenvectors(glm::transpose(matrix) * matrix);
  const auto length = [&](int i) { return glm::length(matrix * v[i]); };
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)}) {
    if (length(a) >= length(b)) continue;  // the longest first
    std::swap(v[a], v[b]);
    v[b] = -v[b];  // v stays a rotation
  }
  parts.scale = {length(0), length(1), length(2)};
  glm::dmat3 u(1.0);
  const auto is_something = [&](int i) { return parts.scale[i] > kNothing * parts.scale[0]; };
  if (parts.scale[0] > 0) u[0] = matrix * v[0] / parts.scale[0];
  u[1] = is_something(1) ? glm::normalize(matrix * v[1]) : across(u[0]);
  u[2] = glm::cross(u[0], u[1]);
  if (glm::dot(u[2], matrix * v[2]) < 0) parts.scale[2] = -parts.scale[2];
  parts.rotation = u * glm::transpose(v);
  parts.scale_orientation = v;
  return parts;
}

std::uint32_t rotation_slot(SlotTable& slots, const glm::dmat3& rotation) {
  const glm::dquat turned = glm::quat_cast(rotation);
  const glm::dvec3 axis = glm::axis(turned);
  return slots.constant(SlotType::rotation, {axis.x, axis.y, axis.z, glm::angle(turned)});
}

}  // namespace

SceneTransform read_matrix_transform(SceneContext& context, NodeId node, int parent) {
  SlotTable& slots = context.slots;
  if (slots.may_change(node, "matrix"))
    context.diagnostics.report(DiagnosticId::not_drawn, context.graph[node].type_span,
                               "the `matrix` of a `MatrixTransform` keeps its first value");
  SceneTransform transform;
  transform.parent = parent;
  const auto m = context.graph.field(node, "matrix").numbers;
  if (!std::ranges::all_of(m, [](double number) { return std::isfinite(number); })) return transform;
  const Parts parts = take_apart({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]});
  transform.translation = slots.constant(SlotType::vec3, {m[12], m[13], m[14]});
  transform.rotation = rotation_slot(slots, parts.rotation);
  transform.scale = slots.constant(SlotType::vec3, {parts.scale.x, parts.scale.y, parts.scale.z});
  transform.scale_orientation = rotation_slot(slots, parts.scale_orientation);
  return transform;
}

}  // namespace plugc
