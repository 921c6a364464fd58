// Geometry2D (X3D 4.1, clause 14; Rectangle2D stands in primitives.cpp): figures in the plane z = 0, seen from +z. Curves are
// lines, filled figures are triangles whose front is toward +z. Circles have the slices of the solids of revolution times two,
// as they are often seen straight from the front.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/box_texture.h"
#include "mesh/geometry.h"
#include "mesh/live_vertices.h"

namespace plugc {
namespace {

constexpr int kSlices = 60;  // of a whole circle
constexpr double kWhole = 2 * std::numbers::pi;

struct Arc {
  double from = 0, size = kWhole;  // radians, counter-clockwise
  int slices = kSlices;
  bool is_whole() const { return size == kWhole; }
};

/// Of equal angles, and of those a whole turn or more apart, a circle comes (X3D 4.1, 14.3.1 and 14.3.2).
Arc read_arc(const GeometrySource& source) {
  const double from = source.graph.number(source.node, "startAngle"), to = source.graph.number(source.node, "endAngle");
  if (!std::isfinite(from) || !std::isfinite(to) || from == to || std::abs(to - from) >= kWhole) return {};
  const double size = to > from ? to - from : to - from + kWhole;
  return {from, size, std::max(1, static_cast<int>(std::ceil(kSlices * size / kWhole)))};
}

glm::vec2 direction(const Arc& arc, int slice) {
  const double angle = arc.from + arc.size * slice / arc.slices;
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

float read_radius(const GeometrySource& source, std::string_view field) {
  return static_cast<float>(source.graph.number(source.node, field));
}

Mesh curve() {
  Mesh mesh;
  mesh.topology = Topology::lines;
  mesh.solid = false;
  return mesh;
}

void add_segment(Mesh& mesh, const glm::vec2& from, const glm::vec2& to) {
  for (const glm::vec2& end : {from, to}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(end, 0);
  }
}

Mesh arc_line(const Arc& arc, float radius) {
  Mesh mesh = curve();
  for (int i = 0; i < arc.slices; ++i) add_segment(mesh, radius * direction(arc, i), radius * direction(arc, i + 1));
  mesh.tex_coords = {box_texture(mesh.positions)};
  return mesh;
}

Mesh figure(const GeometrySource& source) {
  Mesh mesh;
  mesh.tex_coords.resize(1);
  mesh.solid = source.graph.boolean(source.node, "solid");
  return mesh;
}

/// The texture lies over the square around a circle of that radius.
std::uint32_t add_point(Mesh& mesh, const glm::vec2& point, float radius) {
  const glm::vec2 place = radius > 0 ? point / radius * 0.5F + 0.5F : glm::vec2(0.5F);
  mesh.positions.emplace_back(point, 0);
  mesh.normals.emplace_back(0, 0, 1);
  mesh.tex_coords[0].emplace_back(place, 0, 1);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// What lies between the first of the ring's points and the others, or around `center`.
Mesh sector(const GeometrySource& source, const Arc& arc, float radius, bool with_center) {
  Mesh mesh = figure(source);
  if (with_center) add_point(mesh, glm::vec2(0), radius);
  for (int i = 0; i < arc.slices + (arc.is_whole() ? 0 : 1); ++i) add_point(mesh, radius * direction(arc, i), radius);
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 1; i + 1 < count; ++i) mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  if (with_center && arc.is_whole()) mesh.indices.insert(mesh.indices.end(), {0, count - 1, 1});
  return mesh;
}

Mesh annulus(const GeometrySource& source, float inner, float outer) {
  Mesh mesh = figure(source);
  const Arc arc;
  for (int i = 0; i <= arc.slices; ++i) {
    const std::uint32_t first = add_point(mesh, inner * direction(arc, i), outer);
    add_point(mesh, outer * direction(arc, i), outer);
    if (i < arc.slices) mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 3, first, first + 3, first + 2});
  }
  return mesh;
}

std::vector<glm::vec2> read_points(const GeometrySource& source, std::string_view field) {
  const std::span<const double> numbers = list_numbers(source, source.node, field);
  std::vector<glm::vec2> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.emplace_back(glm::dvec2(numbers[i], numbers[i + 1]));
  return points;
}

}  // namespace

std::optional<Mesh> make_arc(const GeometrySource& source) {
  const Arc arc = source.type() == "Arc2D" ? read_arc(source) : Arc();
  return arc_line(arc, read_radius(source, "radius"));
}

std::optional<Mesh> make_closed_arc(const GeometrySource& source) {
  const Arc arc = read_arc(source);
  const bool is_pie = source.graph.string(source.node, "closureType") != "CHORD";
  return sector(source, arc, read_radius(source, "radius"), is_pie && !arc.is_whole());
}

std::optional<Mesh> make_disk(const GeometrySource& source) {
  const float inner = read_radius(source, "innerRadius"), outer = read_radius(source, "outerRadius");
  if (inner > outer) {
    source.report(DiagnosticId::geometry_invalid, "innerRadius",
                  fmt::format("`innerRadius` is {}, more than `outerRadius`, which is {}", inner, outer));
    return std::nullopt;
  }
  if (inner <= 0) return sector(source, Arc(), outer, false);
  return inner == outer ? arc_line(Arc(), outer) : annulus(source, inner, outer);
}

std::optional<Mesh> make_polyline(const GeometrySource& source) {
  const std::vector<glm::vec2> points = read_points(source, "lineSegments");
  Mesh mesh = curve();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) add_segment(mesh, points[i], points[i + 1]);
  mesh.tex_coords = {box_texture(mesh.positions)};
  return mesh;
}

std::optional<Mesh> make_polypoint(const GeometrySource& source) {
  Mesh mesh = curve();
  mesh.topology = Topology::points;
  for (const glm::vec2& point : read_points(source, "point")) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.emplace_back(point, 0);
  }
  mesh.tex_coords = {box_texture(mesh.positions)};
  mesh.live = make_live_points(source, "point", mesh.positions.size());
  return mesh;
}

/// Triangles may run either way; all have their front toward +z.
std::optional<Mesh> make_triangle_set_2d(const GeometrySource& source) {
  const std::vector<glm::vec2> points = read_points(source, "vertices");
  Mesh mesh = figure(source);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const glm::vec2 ab = points[i + 1] - points[i], ac = points[i + 2] - points[i];
    const bool clockwise = ab.x * ac.y - ab.y * ac.x < 0;
    const auto first = static_cast<std::uint32_t>(i);
    mesh.indices.insert(mesh.indices.end(), {first, first + (clockwise ? 2 : 1), first + (clockwise ? 1 : 2)});
  }
  for (const glm::vec2& point : points) mesh.positions.emplace_back(point, 0);
  mesh.positions.resize(mesh.indices.size());  // a rest that makes no triangle counts for nothing
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
  mesh.tex_coords[0] = box_texture(mesh.positions);
  mesh.live = make_live_points(source, "vertices", mesh.positions.size());
  return mesh;
}

}  // namespace plugc
