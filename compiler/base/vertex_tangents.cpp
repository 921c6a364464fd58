// Each triangle says how its edges map to texture coordinates; that solved for the directions of `s` and `t` is summed up at
// its corners, so that large triangles count more. Then the sum is made perpendicular to the vertex's normal.

#include "base/vertex_tangents.h"

#include <cmath>

namespace plugc {
namespace {

struct Directions {
  glm::vec3 of_s{0}, of_t{0};
};

/// The directions of a triangle times twice its area in texture space; zero where that has none.
Directions directions(const TangentInputs& mesh, const std::uint32_t* corners) {
  const glm::vec3 edge_1 = mesh.positions[corners[1]] - mesh.positions[corners[0]];
  const glm::vec3 edge_2 = mesh.positions[corners[2]] - mesh.positions[corners[0]];
  const glm::vec2 tex_1 = glm::vec2(mesh.tex_coords[corners[1]] - mesh.tex_coords[corners[0]]);
  const glm::vec2 tex_2 = glm::vec2(mesh.tex_coords[corners[2]] - mesh.tex_coords[corners[0]]);
  const float area = tex_1.x * tex_2.y - tex_2.x * tex_1.y;
  const Directions found{edge_1 * tex_2.y - edge_2 * tex_1.y, edge_2 * tex_1.x - edge_1 * tex_2.x};
  return area < 0 ? Directions{-found.of_s, -found.of_t} : found;
}

/// Whether that part of the vector is more than rounding left of it.
bool has_direction(const glm::vec3& part, const glm::vec3& vector) {
  const float length = glm::length(part);
  return length > 1e-6F * glm::length(vector) && std::isfinite(length);
}

glm::vec3 any_perpendicular(const glm::vec3& normal) {
  const glm::vec3 helper = std::abs(normal.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(helper, normal));
}

glm::vec4 tangent_at(const glm::vec3& normal, const Directions& sum) {
  const glm::vec3 along = sum.of_s - normal * glm::dot(normal, sum.of_s);
  const glm::vec3 tangent = has_direction(along, sum.of_s) ? glm::normalize(along) : any_perpendicular(normal);
  return {tangent, glm::dot(glm::cross(normal, tangent), sum.of_t) < 0 ? -1 : 1};
}

}  // namespace

std::vector<glm::vec4> vertex_tangents(const TangentInputs& mesh) {
  std::vector<Directions> sums(mesh.positions.size());
  for (std::size_t i = 0; i + 3 <= mesh.indices.size(); i += 3) {
    const Directions found = directions(mesh, &mesh.indices[i]);
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      sums[mesh.indices[corner]].of_s += found.of_s;
      sums[mesh.indices[corner]].of_t += found.of_t;
    }
  }
  std::vector<glm::vec4> tangents;
  tangents.reserve(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) tangents.push_back(tangent_at(mesh.normals[v], sums[v]));
  return tangents;
}

}  // namespace plugc
