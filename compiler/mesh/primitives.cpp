// Box, Rectangle2D and the three solids of revolution (X3D 4.1, 13.3). A Sphere is rings from pole to pole; the sides of Cone
// and Cylinder are two rings, their caps a fan. A ring runs from the back (-z) over the left (-x) to the front (+z) and on, as
// the clauses lay the texture around the y axis, and repeats its first point so that the texture has a seam.

#include <array>
#include <cmath>
#include <numbers>

#include "mesh/geometry.h"

namespace plugc {

namespace {

constexpr int kSlices = 30;  // around the y axis, as the common viewers have it
constexpr int kStacks = 20;  // from pole to pole

struct Ring {
  float radius, y;
  float normal_out, normal_y;  // unit length together
  float t;
};

std::uint32_t add_vertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal, float s, float t) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
  mesh.tex_coords[0].push_back({s, t, 0, 1});
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

Mesh empty_mesh(const GeometrySource& source) {
  Mesh mesh;
  mesh.tex_coords.resize(1);
  mesh.solid = source.graph.boolean(source.node, "solid");
  return mesh;
}

glm::vec2 around(int slice) {
  const double angle = 2 * std::numbers::pi * slice / kSlices;
  return {static_cast<float>(-std::sin(angle)), static_cast<float>(-std::cos(angle))};
}

std::uint32_t add_ring(Mesh& mesh, const Ring& ring) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= kSlices; ++i) {
    const glm::vec2 out = around(i);
    add_vertex(mesh, {ring.radius * out.x, ring.y, ring.radius * out.y},
               {ring.normal_out * out.x, ring.normal_y, ring.normal_out * out.y}, static_cast<float>(i) / kSlices, ring.t);
  }
  return first;
}

// The belt between two rings, the lower one first. Triangles that a pole shrinks to nothing are left out.
void add_belt(Mesh& mesh, const Ring& lower, const Ring& upper) {
  const std::uint32_t a = add_ring(mesh, lower);
  const std::uint32_t b = add_ring(mesh, upper);
  for (std::uint32_t i = 0; i < kSlices; ++i) {
    if (lower.radius != 0) add_triangle(mesh, a + i, a + i + 1, b + i);
    if (upper.radius != 0) add_triangle(mesh, a + i + 1, b + i + 1, b + i);
  }
}

// A disk facing up (+1) or down (-1); its texture is upright for who tilts the solid toward the eye.
void add_cap(Mesh& mesh, float radius, float y, float facing) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < kSlices; ++i) {
    const glm::vec2 out = around(i);
    add_vertex(mesh, {radius * out.x, y, radius * out.y}, {0, facing, 0}, 0.5f + out.x / 2, 0.5f - facing * out.y / 2);
  }
  for (std::uint32_t i = 1; i + 1 < kSlices; ++i) {
    if (facing > 0)
      add_triangle(mesh, first, first + i, first + i + 1);
    else
      add_triangle(mesh, first, first + i + 1, first + i);
  }
}

struct BoxFace {
  glm::vec3 right, up;  // of the picture on it, seen from outside
};

// Front, back, right, left, top, bottom.
constexpr std::array<BoxFace, 6> kBoxFaces = {{
    {{1, 0, 0}, {0, 1, 0}},
    {{-1, 0, 0}, {0, 1, 0}},
    {{0, 0, -1}, {0, 1, 0}},
    {{0, 0, 1}, {0, 1, 0}},
    {{1, 0, 0}, {0, 0, -1}},
    {{1, 0, 0}, {0, 0, 1}},
}};

void add_rectangle(Mesh& mesh, const glm::vec3& center, const glm::vec3& right, const glm::vec3& up, const glm::vec3& normal) {
  const std::uint32_t first = add_vertex(mesh, center - right - up, normal, 0, 0);
  add_vertex(mesh, center + right - up, normal, 1, 0);
  add_vertex(mesh, center + right + up, normal, 1, 1);
  add_vertex(mesh, center - right + up, normal, 0, 1);
  add_triangle(mesh, first, first + 1, first + 2);
  add_triangle(mesh, first, first + 2, first + 3);
}

}  // namespace

std::optional<Mesh> make_box(const GeometrySource& source) {
  Mesh mesh = empty_mesh(source);
  const glm::vec3 half = glm::vec3(source.graph.vec3(source.node, "size")) / 2.0f;
  mesh.ccw = source.graph.boolean(source.node, "ccw");
  for (const BoxFace& face : kBoxFaces) {
    const glm::vec3 outward = glm::cross(face.right, face.up);
    add_rectangle(mesh, outward * half, face.right * half, face.up * half, mesh.ccw ? outward : -outward);
  }
  return mesh;
}

std::optional<Mesh> make_rectangle(const GeometrySource& source) {
  Mesh mesh = empty_mesh(source);
  const glm::vec2 half = glm::vec2(source.graph.vec2(source.node, "size")) / 2.0f;
  add_rectangle(mesh, {}, {half.x, 0, 0}, {0, half.y, 0}, {0, 0, 1});
  return mesh;
}

std::optional<Mesh> make_sphere(const GeometrySource& source) {
  Mesh mesh = empty_mesh(source);
  const auto radius = static_cast<float>(source.graph.number(source.node, "radius"));
  const auto ring_at = [radius](int stack) {
    const double angle = std::numbers::pi * stack / kStacks;
    const bool pole = stack == 0 || stack == kStacks;
    const float out = pole ? 0 : static_cast<float>(std::sin(angle));
    const auto y = static_cast<float>(-std::cos(angle));
    return Ring{radius * out, radius * y, out, y, static_cast<float>(stack) / kStacks};
  };
  std::uint32_t below = add_ring(mesh, ring_at(0));
  for (int stack = 1; stack <= kStacks; ++stack) {
    const std::uint32_t above = add_ring(mesh, ring_at(stack));
    for (std::uint32_t i = 0; i < kSlices; ++i) {
      if (stack != 1) add_triangle(mesh, below + i, below + i + 1, above + i);
      if (stack != kStacks) add_triangle(mesh, below + i + 1, above + i + 1, above + i);
    }
    below = above;
  }
  return mesh;
}

std::optional<Mesh> make_cone(const GeometrySource& source) {
  Mesh mesh = empty_mesh(source);
  const auto radius = static_cast<float>(source.graph.number(source.node, "bottomRadius"));
  const auto height = static_cast<float>(source.graph.number(source.node, "height"));
  if (source.graph.boolean(source.node, "side")) {
    const float slant = std::hypot(radius, height);
    const float out = slant > 0 ? height / slant : 1, up = slant > 0 ? radius / slant : 0;
    add_belt(mesh, {radius, -height / 2, out, up, 0}, {0, height / 2, out, up, 1});
  }
  if (source.graph.boolean(source.node, "bottom")) add_cap(mesh, radius, -height / 2, -1);
  return mesh;
}

std::optional<Mesh> make_cylinder(const GeometrySource& source) {
  Mesh mesh = empty_mesh(source);
  const auto radius = static_cast<float>(source.graph.number(source.node, "radius"));
  const auto height = static_cast<float>(source.graph.number(source.node, "height"));
  if (source.graph.boolean(source.node, "side")) add_belt(mesh, {radius, -height / 2, 1, 0, 0}, {radius, height / 2, 1, 0, 1});
  if (source.graph.boolean(source.node, "top")) add_cap(mesh, radius, height / 2, 1);
  if (source.graph.boolean(source.node, "bottom")) add_cap(mesh, radius, -height / 2, -1);
  return mesh;
}

}  // namespace plugc
