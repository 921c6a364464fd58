// Numbers come as doubles, so many an element; vectors of floats leave. The type of the child decides how many numbers make one
// element and what the missing components are.

#include "mesh/lists.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "mesh/live_vertices.h"
#include "mesh/mesh_attribute.h"

namespace plugc {

namespace {

// Elements of N numbers; a rest that makes no whole element is dropped.
template <int N>
std::vector<glm::vec<N, float>> vectors(std::span<const double> numbers) {
  std::vector<glm::vec<N, float>> result(numbers.size() / N);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (int c = 0; c < N; ++c) result[i][c] = static_cast<float>(numbers[i * N + static_cast<std::size_t>(c)]);
  return result;
}

// Elements of N numbers with the rest taken from `missing`.
template <int N>
std::vector<glm::vec4> padded(std::span<const double> numbers, const glm::vec4& missing) {
  std::vector<glm::vec4> result(numbers.size() / N, missing);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (int c = 0; c < N; ++c) result[i][c] = static_cast<float>(numbers[i * N + static_cast<std::size_t>(c)]);
  return result;
}

glm::vec3 unit_or(const glm::vec3& vector, const glm::vec3& fallback) {
  const float length = glm::length(vector);
  return length > 0 && std::isfinite(length) ? vector / length : fallback;
}

std::vector<glm::vec4> read_tex_unit(const GeometrySource& source, NodeId node) {
  const glm::vec4 missing{0, 0, 0, 1};
  if (source.graph.is(node, "TextureCoordinate")) return padded<2>(list_numbers(source, node, "point"), missing);
  if (source.graph.is(node, "TextureCoordinate3D")) return padded<3>(list_numbers(source, node, "point"), missing);
  if (source.graph.is(node, "TextureCoordinate4D")) return padded<4>(list_numbers(source, node, "point"), missing);
  return {};
}

// Of what size an attribute's values are; no columns for a node of another kind.
MeshAttribute attribute_type(const NodeGraph& graph, NodeId node) {
  MeshAttribute attribute{std::string(graph.string(node, "name")), 0, 0, {}};
  if (graph.is(node, "Matrix3VertexAttribute")) attribute.columns = attribute.components = 3;
  if (graph.is(node, "Matrix4VertexAttribute")) attribute.columns = attribute.components = 4;
  if (!graph.is(node, "FloatVertexAttribute")) return attribute;
  attribute.columns = 1;
  attribute.components = static_cast<std::uint8_t>(std::clamp(graph.integer(node, "numComponents"), 1, 4));
  return attribute;
}

}  // namespace

std::vector<glm::vec3> read_coords(const GeometrySource& source) {
  const NodeId coord = source.graph.child(source.node, "coord");
  if (!coord.valid()) return {};
  if (source.graph.is(coord, "Coordinate") || source.graph.is(coord, "CoordinateDouble"))
    return vectors<3>(list_numbers(source, coord, "point"));
  source.report(DiagnosticId::not_drawn, "coord",
                fmt::format("plugc does not place the coordinates of `{}`; use `Coordinate`", source.graph[coord].info->name));
  return {};
}

std::vector<glm::vec3> read_normals(const GeometrySource& source) {
  const NodeId normal = source.graph.child(source.node, "normal");
  if (!source.graph.is(normal, "Normal")) return {};
  std::vector<glm::vec3> normals = vectors<3>(list_numbers(source, normal, "vector"));
  for (glm::vec3& vector : normals) vector = unit_or(vector, {0, 0, 1});
  return normals;
}

std::vector<glm::vec4> read_tangents(const GeometrySource& source) {
  if (!source.graph.has_field(source.node, "tangent")) return {};
  const NodeId tangent = source.graph.child(source.node, "tangent");
  if (!source.graph.is(tangent, "Tangent")) return {};
  std::vector<glm::vec4> tangents = vectors<4>(source.graph.field(tangent, "vector").numbers);
  for (glm::vec4& vector : tangents) vector = glm::vec4(unit_or(glm::vec3(vector), {1, 0, 0}), vector.w < 0 ? -1 : 1);
  return tangents;
}

ColorList read_colors(const GeometrySource& source) {
  const NodeId color = source.graph.child(source.node, "color");
  if (source.graph.is(color, "Color")) return {padded<3>(list_numbers(source, color, "color"), glm::vec4(1)), false};
  if (source.graph.is(color, "ColorRGBA")) return {padded<4>(list_numbers(source, color, "color"), glm::vec4(1)), true};
  return {};
}

std::vector<float> read_fog_coords(const GeometrySource& source, std::size_t coord_count) {
  const NodeId fog_coord = source.graph.child(source.node, "fogCoord");
  if (!source.graph.is(fog_coord, "FogCoordinate")) return {};
  const std::span<const double> depths = list_numbers(source, fog_coord, "depth");
  if (depths.empty()) return {};
  std::vector<float> result(coord_count, static_cast<float>(depths.back()));
  for (std::size_t i = 0; i < std::min(depths.size(), coord_count); ++i) result[i] = static_cast<float>(depths[i]);
  return result;
}

namespace {

/// False, and reported, for one that brings more columns than any program can read.
bool takes_columns(const GeometrySource& source, const MeshAttribute& attribute, std::size_t& columns) {
  columns += attribute.columns;
  if (columns <= kMaxAttributeColumns) return true;
  source.report(DiagnosticId::geometry_limit, "attrib",
                fmt::format("`attrib` has more than {} columns, and no program reads more; `{}` and what follows is left out",
                            kMaxAttributeColumns, attribute.name));
  return false;
}

}  // namespace

std::vector<MeshAttribute> read_attributes(const GeometrySource& source, std::size_t coord_count) {
  std::vector<MeshAttribute> attributes;
  if (!source.graph.has_field(source.node, "attrib")) return attributes;
  std::size_t columns = 0;
  for (const NodeId node : source.graph.children(source.node, "attrib")) {
    if (!source.graph.is(node, "X3DVertexAttributeNode")) continue;
    MeshAttribute attribute = attribute_type(source.graph, node);
    const bool is_known = std::ranges::find(attributes, attribute.name, &MeshAttribute::name) != attributes.end();
    if (attribute.columns == 0 || attribute.name.empty() || is_known) continue;
    if (!takes_columns(source, attribute, columns)) break;
    const std::span<const double> numbers = list_numbers(source, node, "value");
    const std::size_t size = number_count(attribute);
    attribute.values.resize(coord_count * size);
    for (std::size_t i = 0; i < std::min(numbers.size(), attribute.values.size()); ++i)
      attribute.values[i] = static_cast<float>(numbers[i]);
    if (numbers.size() / size < coord_count) {
      source.diagnostics.report(
          DiagnosticId::geometry_invalid, source.graph.field_span(node, "value"),
          fmt::format("`value` of attribute `{}` is for {} points, but there are {}; zeros stand for the rest", attribute.name,
                      numbers.size() / size, coord_count));
    }
    attributes.push_back(std::move(attribute));
  }
  return attributes;
}

std::vector<std::vector<glm::vec4>> read_tex_units(const GeometrySource& source) {
  const NodeId tex_coord = source.graph.child(source.node, "texCoord");
  if (!source.graph.is(tex_coord, "MultiTextureCoordinate")) return {read_tex_unit(source, tex_coord)};
  std::span<const NodeId> sets = source.graph.children(tex_coord, "texCoord");
  if (sets.size() > kMaxTexCoordSets) {
    source.report(
        DiagnosticId::geometry_limit, "texCoord",
        fmt::format("`texCoord` has {} sets of coordinates; plugc takes the first {}", sets.size(), kMaxTexCoordSets));
    sets = sets.first(kMaxTexCoordSets);
  }
  std::vector<std::vector<glm::vec4>> units;
  for (const NodeId unit : sets) units.push_back(read_tex_unit(source, unit));
  return units;
}

}  // namespace plugc
