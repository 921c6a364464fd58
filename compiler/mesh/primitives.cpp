// Box, Rectangle2D and the three solids of revolution (X3D 4.1, 13.3). A Sphere is rings from pole to pole; the sides of Cone
// and Cylinder are rings, too, their caps a fan. A ring runs from the back (-z) over the left (-x) to the front (+z) and on, as
// the clauses lay the texture around the y axis, and repeats its first point so that the texture has a seam.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/limits.h"
#include "mesh/geometry.h"

namespace plugc {

namespace {

constexpr int kSlices = 30;        // around the y axis, as the common viewers have it
constexpr int kSphereStacks = 20;  // from pole to pole
constexpr int kFewestSlices = 3;

// How fine a solid of revolution is: the reference engine's fields `slices` and `stacks`. What
// makes no solid, as -1, the default, leaves it to the renderer.
struct Fineness {
  int slices = kSlices, stacks = 1;
};

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

glm::vec2 around(int slice, int slices) {
  const double angle = 2 * std::numbers::pi * slice / slices;
  return {static_cast<float>(-std::sin(angle)), static_cast<float>(-std::cos(angle))};
}

std::uint32_t add_ring(Mesh& mesh, const Ring& ring, int slices) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= slices; ++i) {
    const glm::vec2 out = around(i, slices);
    add_vertex(mesh, {ring.radius * out.x, ring.y, ring.radius * out.y},
               {ring.normal_out * out.x, ring.normal_y, ring.normal_out * out.y},
               static_cast<float>(i) / static_cast<float>(slices), ring.t);
  }
  return first;
}

// The belts between rings, the lowest first. Triangles that a pole shrinks to nothing are left out.
void add_belts(Mesh& mesh, std::span<const Ring> rings, int slices) {
  std::uint32_t a = add_ring(mesh, rings[0], slices);
  for (std::size_t ring = 1; ring < rings.size(); ++ring) {
    const std::uint32_t b = add_ring(mesh, rings[ring], slices);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(slices); ++i) {
      if (rings[ring - 1].radius != 0) add_triangle(mesh, a + i, a + i + 1, b + i);
      if (rings[ring].radius != 0) add_triangle(mesh, a + i + 1, b + i + 1, b + i);
    }
    a = b;
  }
}

// The side of a Cone or Cylinder, in stacks of equal height.
void add_side(Mesh& mesh, const Ring& bottom, const Ring& top, const Fineness& fineness) {
  std::vector<Ring> rings;
  for (int i = 0; i <= fineness.stacks; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(fineness.stacks);
    rings.push_back({std::lerp(bottom.radius, top.radius, part), std::lerp(bottom.y, top.y, part), bottom.normal_out,
                     bottom.normal_y, part});
  }
  add_belts(mesh, rings, fineness.slices);
}

// A disk facing up (+1) or down (-1); its texture is upright for who tilts the solid toward the eye.
void add_cap(Mesh& mesh, float radius, float y, float facing, int slices) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < slices; ++i) {
    const glm::vec2 out = around(i, slices);
    add_vertex(mesh, {radius * out.x, y, radius * out.y}, {0, facing, 0}, 0.5f + out.x / 2, 0.5f - facing * out.y / 2);
  }
  for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(slices); ++i) {
    if (facing > 0)
      add_triangle(mesh, first, first + i, first + i + 1);
    else
      add_triangle(mesh, first, first + i + 1, first + i);
  }
}

// nullopt, with a message, where there would be more than kMaxSolidVertices.
std::optional<Fineness> read_fineness(const GeometrySource& source, int usual_stacks) {
  const int slices = source.graph.integer(source.node, "slices"), stacks = source.graph.integer(source.node, "stacks");
  const Fineness fineness{slices < kFewestSlices ? kSlices : slices, stacks < 1 ? usual_stacks : stacks};
  const std::uint64_t vertices = (std::uint64_t{1} + static_cast<std::uint64_t>(fineness.slices)) *
                                 (std::uint64_t{1} + static_cast<std::uint64_t>(fineness.stacks));
  if (vertices <= kMaxSolidVertices) return fineness;
  source.report(
      DiagnosticId::geometry_limit, "slices",
      fmt::format("this `{}` would have {} vertices; plugc takes at most {}", source.type(), vertices, kMaxSolidVertices));
  return std::nullopt;
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
  const auto fineness = read_fineness(source, kSphereStacks);
  if (!fineness) return std::nullopt;
  Mesh mesh = empty_mesh(source);
  const auto radius = static_cast<float>(source.graph.number(source.node, "radius"));
  std::vector<Ring> rings;
  for (int stack = 0; stack <= fineness->stacks; ++stack) {
    const double angle = std::numbers::pi * stack / fineness->stacks;
    const bool pole = stack == 0 || stack == fineness->stacks;
    const float out = pole ? 0 : static_cast<float>(std::sin(angle));
    const auto y = static_cast<float>(-std::cos(angle));
    rings.push_back({radius * out, radius * y, out, y, static_cast<float>(stack) / static_cast<float>(fineness->stacks)});
  }
  add_belts(mesh, rings, fineness->slices);
  return mesh;
}

std::optional<Mesh> make_cone(const GeometrySource& source) {
  const auto fineness = read_fineness(source, 1);
  if (!fineness) return std::nullopt;
  Mesh mesh = empty_mesh(source);
  const auto radius = static_cast<float>(source.graph.number(source.node, "bottomRadius"));
  const auto height = static_cast<float>(source.graph.number(source.node, "height"));
  if (source.graph.boolean(source.node, "side")) {
    const float slant = std::hypot(radius, height);
    const float out = slant > 0 ? height / slant : 1, up = slant > 0 ? radius / slant : 0;
    add_side(mesh, {radius, -height / 2, out, up, 0}, {0, height / 2, out, up, 1}, *fineness);
  }
  if (source.graph.boolean(source.node, "bottom")) add_cap(mesh, radius, -height / 2, -1, fineness->slices);
  return mesh;
}

std::optional<Mesh> make_cylinder(const GeometrySource& source) {
  const auto fineness = read_fineness(source, 1);
  if (!fineness) return std::nullopt;
  Mesh mesh = empty_mesh(source);
  const auto radius = static_cast<float>(source.graph.number(source.node, "radius"));
  const auto height = static_cast<float>(source.graph.number(source.node, "height"));
  if (source.graph.boolean(source.node, "side"))
    add_side(mesh, {radius, -height / 2, 1, 0, 0}, {radius, height / 2, 1, 0, 1}, *fineness);
  if (source.graph.boolean(source.node, "top")) add_cap(mesh, radius, height / 2, 1, fineness->slices);
  if (source.graph.boolean(source.node, "bottom")) add_cap(mesh, radius, -height / 2, -1, fineness->slices);
  return mesh;
}

}  // namespace plugc
