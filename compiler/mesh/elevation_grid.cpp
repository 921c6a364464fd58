// ElevationGrid (X3D 4.1, 13.3.4): point (i, j) stands at (i * xSpacing, height[i + j * xDimension], j * zSpacing). Each cell
// is one face, counter-clockwise seen from above, which has one colour or normal where those are per face. As its four points
// seldom lie in a plane, it is then cut along the shorter diagonal, which follows ridges and valleys, and the triangles are
// what creaseAngle looks at. The default texture lies over the whole grid, S along x, T along z.

#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "mesh/face_reader.h"

namespace plugc {

namespace {

struct Grid {
  std::size_t columns = 0, rows = 0;
};

// The dimensions, or nothing (reported unless it is just empty).
std::optional<Grid> grid_of(const GeometrySource& source) {
  const int columns = source.graph.integer(source.node, "xDimension");
  const int rows = source.graph.integer(source.node, "zDimension");
  if (columns < 2 || rows < 2) return Grid{};
  const Grid grid{static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)};
  const std::size_t heights = source.graph.field(source.node, "height").numbers.size();
  if (heights >= grid.columns * grid.rows) return grid;
  source.report(
      DiagnosticId::geometry_invalid, "height",
      fmt::format("`height` has {} values; a grid of {} x {} needs {}", heights, columns, rows, grid.columns * grid.rows));
  return std::nullopt;
}

std::vector<glm::vec3> points_of(const GeometrySource& source, const Grid& grid) {
  const std::span<const double> heights = source.graph.field(source.node, "height").numbers;
  const double x_spacing = source.graph.number(source.node, "xSpacing"),
               z_spacing = source.graph.number(source.node, "zSpacing");
  std::vector<glm::vec3> points;
  points.reserve(grid.columns * grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i)
      points.emplace_back(
          glm::dvec3(static_cast<double>(i) * x_spacing, heights[i + j * grid.columns], static_cast<double>(j) * z_spacing));
  return points;
}

std::vector<glm::vec4> texture_over(const Grid& grid) {
  std::vector<glm::vec4> result;
  result.reserve(grid.columns * grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i)
      result.emplace_back(static_cast<float>(i) / static_cast<float>(grid.columns - 1),
                          static_cast<float>(j) / static_cast<float>(grid.rows - 1), 0.0f, 1.0f);
  return result;
}

bool is_first_diagonal_shorter(const FaceSet& faces, std::span<const Corner> cell) {
  const auto point = [&](std::size_t i) { return glm::dvec3(faces.coords[cell[i].coord]); };
  return glm::distance(point(0), point(2)) <= glm::distance(point(1), point(3));
}

void cut_cells(FaceSet& faces) {
  const std::vector<Corner> cells = std::exchange(faces.corners, {});
  faces.face_ends.clear();
  for (std::size_t at = 0; at < cells.size(); at += 4) {
    const std::span<const Corner> cell(cells.data() + at, 4);
    const std::size_t first = is_first_diagonal_shorter(faces, cell) ? 0 : 1;
    const Corner halves[] = {cell[first],     cell[first + 1],       cell[first + 2],
                             cell[first + 2], cell[(first + 3) % 4], cell[first]};
    faces.add_face(std::span(halves).first(3));
    faces.add_face(std::span(halves).last(3));
  }
}

}  // namespace

std::optional<Mesh> make_elevation_grid(const GeometrySource& source) {
  const std::optional<Grid> grid = grid_of(source);
  if (!grid) return std::nullopt;
  if (grid->columns == 0) return Mesh{};
  FaceReader reader(source, points_of(source, *grid));
  reader.faces.crease_angle = static_cast<float>(source.graph.number(source.node, "creaseAngle"));
  reader.faces.default_tex = texture_over(*grid);
  for (std::size_t j = 0; j + 1 < grid->rows; ++j) {
    for (std::size_t i = 0; i + 1 < grid->columns; ++i) {
      const auto at = static_cast<std::int64_t>(i + j * grid->columns), below = at + static_cast<std::int64_t>(grid->columns);
      const std::int64_t cell[] = {at, below, below + 1, at + 1};
      reader.add_face(cell);
    }
  }
  cut_cells(reader.faces);
  return mesh_of_faces(std::move(reader.faces), source);
}

}  // namespace plugc
