// Every corner of an intersection of solids lies on a face of one of them, inside all the others. So each face is cut by the
// planes of all others (Sutherland and Hodgman, 1974), and what remains of all faces has the corners wanted, and no other
// points outside. No closed surface is ever built.

#include "runtime/hull.h"

#include <cmath>

namespace plugc {
namespace {

using Polygon = std::vector<glm::dvec3>;

constexpr int kAxes = 3;

double side(const glm::dvec4& plane, const glm::dvec3& point) {
  return glm::dot(glm::dvec3(plane), point) + plane.w;
}

/// What of the polygon is inside. The corner that a cut makes lies on its edge, whichever end is inside.
Polygon cut(const Polygon& polygon, const glm::dvec4& plane) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3& from = polygon[i];
    const glm::dvec3& to = polygon[(i + 1) % polygon.size()];
    const double a = side(plane, from);
    const double b = side(plane, to);
    if (a >= 0) kept.push_back(from);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back(from + (to - from) * (a / (a - b)));
  }
  return kept;
}

/// Through `point`, with its inside where `inside` is; a plane without direction lets all through.
glm::dvec4 plane_towards(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& inside) {
  const double length = glm::length(normal);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0, 0};
  const glm::dvec3 unit = glm::dot(normal, inside - point) < 0 ? -normal / length : normal / length;
  return {unit, -glm::dot(unit, point)};
}

glm::dvec4 row(const glm::dmat4& m, int i) {
  return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

}  // namespace

Hull hull_of(const Box& box, const glm::dmat4& matrix) {
  Hull hull;
  hull.flat = true;
  if (transformed(box, matrix).empty()) return hull;
  std::array<glm::dvec3, 8> points = corners(box);
  for (glm::dvec3& point : points) point = glm::dvec3(matrix * glm::dvec4(point, 1));
  const glm::dvec3 center(matrix * glm::dvec4(box.center(), 1));
  const glm::dvec3 size = box.size();
  const glm::dmat3 axes(matrix);
  const std::array<glm::dvec3, kAxes> edges = {axes[0] * size.x, axes[1] * size.y, axes[2] * size.z};
  const double volume = std::abs(glm::dot(edges[0], glm::cross(edges[1], edges[2])));
  const double reach = glm::length(edges[0]) + glm::length(edges[1]) + glm::length(edges[2]);
  hull.flat = !(volume > 1e-12 * reach * reach * reach);
  for (unsigned axis = 0; axis < kAxes; ++axis) {
    const unsigned u = 1U << (axis + 1) % kAxes;
    const unsigned v = 1U << (axis + 2) % kAxes;
    for (const unsigned first : {0U, 1U << axis}) {
      hull.faces.push_back({points[first], points[first | u], points[first | u | v], points[first | v]});
      if (!hull.flat) {
        const glm::dvec3 normal = glm::cross(edges[(axis + 1) % kAxes], edges[(axis + 2) % kAxes]);
        hull.planes.push_back(plane_towards(points[first], normal, center));
      }
    }
  }
  return hull;
}

Hull view_hull(const glm::dmat4& world_to_eye, const glm::dmat4& projection) {
  Hull hull;
  const glm::dmat4 to_clip = projection * world_to_eye;
  const glm::dmat4 to_world = glm::inverse(to_clip);
  const auto unproject = [&](double x, double y, double z) {
    const glm::dvec4 point = to_world * glm::dvec4(x, y, z, 1);
    return glm::dvec3(point) / point.w;
  };
  const bool perspective = projection[3][3] == 0;
  const glm::dvec3 eye(glm::inverse(world_to_eye)[3]);
  constexpr std::array<glm::dvec2, 4> kCorners = {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    const glm::dvec2& a = kCorners[i];
    const glm::dvec2& b = kCorners[(i + 1) % kCorners.size()];
    Polygon face = {unproject(a.x, a.y, 1), unproject(b.x, b.y, 1)};
    if (perspective) {
      face.push_back(eye);
    } else {
      face.push_back(unproject(b.x, b.y, -1));
      face.push_back(unproject(a.x, a.y, -1));
    }
    hull.faces.push_back(std::move(face));
  }
  for (const int axis : {0, 1}) {
    hull.planes.push_back(row(to_clip, 3) + row(to_clip, axis));
    hull.planes.push_back(row(to_clip, 3) - row(to_clip, axis));
  }
  return hull;
}

std::vector<glm::dvec3> common_points(std::span<const Hull* const> hulls) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    bool can_end_inside = true;
    for (std::size_t j = 0; j < hulls.size(); ++j) can_end_inside = can_end_inside && (j == i || !hulls[j]->flat);
    if (!can_end_inside) continue;
    for (Polygon face : hulls[i]->faces) {
      for (std::size_t j = 0; j < hulls.size(); ++j) {
        for (const glm::dvec4& plane : hulls[j]->planes) {
          if (j != i && !face.empty()) face = cut(face, plane);
        }
      }
      points.insert(points.end(), face.begin(), face.end());
    }
  }
  return points;
}

}  // namespace plugc
