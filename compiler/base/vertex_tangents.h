#pragma once
// Tangents of a mesh of triangles. The compiler makes them where a normal map is, the renderer makes them anew when vertices
// move.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace plugc {

/// By vertex; three indices make a triangle.
struct TangentInputs {
  std::span<const std::uint32_t> indices;
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::vec4> tex_coords;
};

/// For each vertex the direction in which `s` grows, unit length, at a right angle to the normal; `w` is 1 where `t` grows
/// along cross(normal, tangent) and -1 where it grows against it (glTF 2.0, 3.7.2.1, has the same form). Where the coordinates
/// say nothing any direction along the surface will do.
std::vector<glm::vec4> vertex_tangents(const TangentInputs& mesh);

}  // namespace plugc
