// IndexedLineSet, LineSet and PointSet (X3D 4.1, 11.4). A polyline of n points becomes n - 1 segments; each segment has two
// vertices of its own, so that colours per line need no special case. Without normals of their own they are unlit.

#include <cmath>

#include <fmt/format.h>

#include "base/box_texture.h"
#include "base/limits.h"
#include "mesh/geometry.h"
#include "mesh/lists.h"
#include "mesh/live_vertices.h"
#include "mesh/mesh_attribute.h"

namespace plugc {

namespace {

// Collects vertices; a point or colour index behind the end is reported once and its segment left out.
class LineBuilder {
 public:
  explicit LineBuilder(const GeometrySource& source)
      : source_(source),
        coords_(read_coords(source)),
        colors_(read_colors(source)),
        normals_(read_normals(source)),
        fog_coords_(read_fog_coords(source, coords_.size())),
        attributes_(read_attributes(source, coords_.size())),
        lists_(read_list_slots(source)) {
    mesh.colors_have_alpha = colors_.have_alpha;
    for (const MeshAttribute& by_coord : attributes_)
      mesh.attributes.push_back({by_coord.name, by_coord.columns, by_coord.components, {}});
    mesh.solid = false;
  }

  std::size_t coord_count() const { return coords_.size(); }

  struct End {
    std::int64_t coord, color;
  };

  void add(std::span<const End> ends) {
    for (const End& end : ends)
      if (!is_usable(end)) return;
    for (const End& end : ends) {
      if (lists_.any()) places_.push_back(places_of(end));
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(coords_[static_cast<std::size_t>(end.coord)]);
      if (!normals_.empty()) mesh.normals.push_back(normals_[static_cast<std::size_t>(end.coord)]);
      if (!colors_.colors.empty()) mesh.colors.push_back(colors_.colors[static_cast<std::size_t>(end.color)]);
      if (!fog_coords_.empty()) mesh.fog_coords.push_back(fog_coords_[static_cast<std::size_t>(end.coord)]);
      for (std::size_t i = 0; i < attributes_.size(); ++i) {
        const std::span<const float> numbers = numbers_at(attributes_[i], static_cast<std::size_t>(end.coord));
        mesh.attributes[i].values.insert(mesh.attributes[i].values.end(), numbers.begin(), numbers.end());
      }
    }
  }

  Mesh take() {
    mesh.tex_coords = {box_texture(mesh.positions)};
    if (lists_.any()) mesh.live = make_live();
    return std::move(mesh);
  }

  Mesh mesh;

 private:
  static VertexPlaces places_of(const End& end) {
    const auto coord = static_cast<std::uint32_t>(end.coord);
    return {coord, coord, static_cast<std::uint32_t>(end.color), coord};
  }

  std::shared_ptr<const LiveVertices> make_live() const {
    ListSlots lists = lists_;
    lists.tex_units.clear();  // lines have the box's
    auto live = std::make_shared<LiveVertices>();
    live->feeds = make_feeds(lists, mesh, places_);
    if (lists.coord.changes()) live->box_coords = {VertexCoord::bounds_2d};
    return live;
  }

  bool is_usable(const End& end) {
    if (mesh.positions.size() > kMaxMeshVertices) return false;  // reported for the whole mesh
    if (!is_in(end.coord, coords_.size(), "coord")) return false;
    if (!normals_.empty() && !is_in(end.coord, normals_.size(), "normal")) return false;
    if (!colors_.colors.empty() && !is_in(end.color, colors_.colors.size(), "color")) return false;
    const glm::vec3& point = coords_[static_cast<std::size_t>(end.coord)];
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
  }

  bool is_in(std::int64_t index, std::size_t size, std::string_view field) {
    if (index >= 0 && static_cast<std::size_t>(index) < size) return true;
    if (!reported_)
      source_.report(DiagnosticId::geometry_index, field,
                     fmt::format("entry {} of `{}` is needed, but it has {}; what needs it is left out", index, field, size));
    reported_ = true;
    return false;
  }

  const GeometrySource& source_;
  std::vector<glm::vec3> coords_;
  ColorList colors_;
  std::vector<glm::vec3> normals_;  // by coord
  std::vector<float> fog_coords_;
  std::vector<MeshAttribute> attributes_;  // by coord
  ListSlots lists_;
  std::vector<VertexPlaces> places_;  // by vertex, where something changes
  bool reported_ = false;
};

std::int64_t entry_or(std::span<const double> list, std::size_t place, std::int64_t otherwise) {
  if (list.empty()) return otherwise;
  return place < list.size() ? static_cast<std::int64_t>(list[place]) : INT64_MAX;  // behind any end
}

void add_indexed_lines(LineBuilder& builder, const GeometrySource& source) {
  const std::span<const double> indices = source.graph.field(source.node, "coordIndex").numbers;
  const std::span<const double> color_indices = source.graph.field(source.node, "colorIndex").numbers;
  const bool per_vertex = source.graph.boolean(source.node, "colorPerVertex");
  std::size_t line = 0;
  const auto end_at = [&](std::size_t i) {
    const auto coord = static_cast<std::int64_t>(indices[i]);
    return LineBuilder::End{
        coord, per_vertex ? entry_or(color_indices, i, coord) : entry_or(color_indices, line, static_cast<std::int64_t>(line))};
  };
  for (std::size_t i = 0; i + 1 < indices.size(); ++i) {
    if (indices[i] < 0) ++line;
    if (indices[i] < 0 || indices[i + 1] < 0) continue;
    const LineBuilder::End segment[] = {end_at(i), end_at(i + 1)};
    builder.add(segment);
  }
}

void add_counted_lines(LineBuilder& builder, const GeometrySource& source) {
  std::int64_t next = 0;
  for (const double value : source.graph.field(source.node, "vertexCount").numbers) {
    const auto count = static_cast<std::int64_t>(value);
    if (count < 2 || count > static_cast<std::int64_t>(builder.coord_count()) - next) {
      source.report(
          count < 2 ? DiagnosticId::geometry_invalid : DiagnosticId::geometry_index, "vertexCount",
          fmt::format("`vertexCount` holds {}, but {} points are left in `coord` and a line needs 2; what follows is left out",
                      count, static_cast<std::int64_t>(builder.coord_count()) - next));
      return;
    }
    for (std::int64_t i = next; i + 1 < next + count; ++i) {
      const LineBuilder::End segment[] = {{i, i}, {i + 1, i + 1}};
      builder.add(segment);
    }
    next += count;
  }
}

}  // namespace

std::optional<Mesh> make_lines(const GeometrySource& source) {
  LineBuilder builder(source);
  builder.mesh.topology = Topology::lines;
  if (source.type() == "IndexedLineSet")
    add_indexed_lines(builder, source);
  else
    add_counted_lines(builder, source);
  return builder.take();
}

std::optional<Mesh> make_points(const GeometrySource& source) {
  LineBuilder builder(source);
  builder.mesh.topology = Topology::points;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(builder.coord_count()); ++i) {
    const LineBuilder::End point[] = {{i, i}};
    builder.add(point);
  }
  return builder.take();
}

}  // namespace plugc
