// The mean of the triangles' normals, each counted by its area and turned to the side of the largest one: so the two sides of
// a thin plate do not cancel each other out.

#include "mesh/mirror_window.h"

#include <cmath>
#include <limits>

namespace plugc {
namespace {

/// A triangle's normal, twice its area long, and three times its middle.
struct Facet {
  glm::dvec3 normal{0}, corners{0};
};

Facet facet(const Mesh& mesh, std::size_t first) {
  const glm::dvec3 a(mesh.positions[mesh.indices[first]]), b(mesh.positions[mesh.indices[first + 1]]),
      c(mesh.positions[mesh.indices[first + 2]]);
  return {glm::cross(b - a, c - a), a + b + c};
}

struct Plane {
  glm::dvec3 normal{0}, middle{0};
};

std::optional<Plane> mean_plane(const Mesh& mesh) {
  glm::dvec3 largest(0);
  for (std::size_t i = 0; i + 3 <= mesh.indices.size(); i += 3) {
    const glm::dvec3 normal = facet(mesh, i).normal;
    if (glm::length(normal) > glm::length(largest)) largest = normal;
  }
  Plane sum;
  double areas = 0;
  for (std::size_t i = 0; i + 3 <= mesh.indices.size(); i += 3) {
    const Facet found = facet(mesh, i);
    const double area = glm::length(found.normal);
    sum.normal += glm::dot(found.normal, largest) < 0 ? -found.normal : found.normal;
    sum.middle += found.corners * (area / 3);
    areas += area;
  }
  const double length = glm::length(sum.normal);
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(areas)) return std::nullopt;
  return Plane{sum.normal / length, sum.middle / areas};
}

/// As near to the object's +y as the plane allows, else to its -z.
glm::dvec3 upwards(const glm::dvec3& normal) {
  const glm::dvec3 wished = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  return glm::normalize(wished - glm::dot(wished, normal) * normal);
}

}  // namespace

std::optional<MirrorWindow> mirror_window(const Mesh& mesh) {
  if (mesh.topology != Topology::triangles) return std::nullopt;
  const auto plane = mean_plane(mesh);
  if (!plane) return std::nullopt;
  const glm::dvec3 up = upwards(plane->normal);
  const glm::dvec3 right = glm::cross(up, plane->normal);
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const std::uint32_t index : mesh.indices) {
    const glm::dvec3 from_middle = glm::dvec3(mesh.positions[index]) - plane->middle;
    const glm::dvec2 place(glm::dot(from_middle, right), glm::dot(from_middle, up));
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  return MirrorWindow{plane->middle + right * low.x + up * low.y, right * (high.x - low.x), up * (high.y - low.y)};
}

}  // namespace plugc
