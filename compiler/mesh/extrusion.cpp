// Extrusion (X3D 4.1, 13.3.5): the cross-section, a curve in x and z, is scaled, turned and set up at each point of the spine,
// in the plane across the spine there; quadrilaterals join each to the next. A plane's y axis runs along the spine, its z axis
// is normal to the spine's bend. Sides share their corners, also over the seams of closed curves, so that creaseAngle smooths
// them; caps have corners of their own and are flat.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "base/transform_matrix.h"
#include "mesh/face_set.h"

namespace plugc {
namespace {

constexpr double kSamePlace = 1e-9;  // relative to the sizes at hand

/// The lists that are read, and where the curves close.
struct Curves {
  std::vector<glm::dvec2> section;  // x and z
  std::vector<glm::dvec3> spine;
  bool section_closed = false, spine_closed = false;
};

bool same_place(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(a - b) <= kSamePlace * (glm::length(a) + glm::length(b));
}

Curves read_curves(const GeometrySource& source) {
  Curves curves;
  const auto section = source.graph.field(source.node, "crossSection").numbers;
  const auto spine = source.graph.field(source.node, "spine").numbers;
  for (std::size_t i = 0; i + 1 < section.size(); i += 2) curves.section.emplace_back(section[i], section[i + 1]);
  for (std::size_t i = 0; i + 2 < spine.size(); i += 3) curves.spine.emplace_back(spine[i], spine[i + 1], spine[i + 2]);
  const auto flat = [](const glm::dvec2& p) { return glm::dvec3(p, 0); };
  curves.section_closed = curves.section.size() > 2 && same_place(flat(curves.section.front()), flat(curves.section.back()));
  curves.spine_closed = curves.spine.size() > 2 && same_place(curves.spine.front(), curves.spine.back());
  return curves;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
}

bool is_zero(const glm::dvec3& v) {
  return v == glm::dvec3(0);
}

/// The spine with points that coincide taken as one. A closed one ends where it begins.
struct Path {
  std::vector<glm::dvec3> places;
  std::vector<std::size_t> of_points;  // the place of each point of the spine
  bool closed = false;

  const glm::dvec3& behind(std::size_t place) const {
    if (closed) return places[(place + 1) % (places.size() - 1)];
    return places[std::min(place + 1, places.size() - 1)];
  }
  const glm::dvec3& before(std::size_t place) const {
    if (place == 0) return places[closed ? places.size() - 2 : 0];
    return places[place - 1];
  }
};

Path path_of(const Curves& curves) {
  Path path;
  for (const glm::dvec3& point : curves.spine) {
    if (path.places.empty() || !same_place(point, path.places.back())) path.places.push_back(point);
    path.of_points.push_back(path.places.size() - 1);
  }
  path.closed = curves.spine_closed && path.places.size() > 1;
  return path;
}

/// Of a straight spine: the plane y = 0 turned so that y runs along it, the shortest way.
glm::dmat3 straight_frame(const glm::dvec3& y) {
  if (is_zero(y)) return glm::dmat3(1.0);
  const glm::dvec3 axis = glm::cross(glm::dvec3(0, 1, 0), y);
  const double angle = std::atan2(glm::length(axis), y.y);
  if (is_zero(axis)) return y.y > 0 ? glm::dmat3(1.0) : glm::dmat3(rotation_matrix({1, 0, 0, angle}));
  return glm::dmat3(rotation_matrix({axis, angle}));
}

/// The bend's normal at each place; where the spine runs straight, or ends, that of a place before it, else behind it. None is
/// the opposite of the one before. All zero: the spine is straight.
std::vector<glm::dvec3> bend_normals(const Path& path) {
  constexpr double kLeastBend = 1e-6;  // sine of the angle
  std::vector<glm::dvec3> normals(path.places.size());
  glm::dvec3 known(0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const glm::dvec3 ahead = unit_or_zero(path.behind(i) - path.places[i]);
    const glm::dvec3 back = unit_or_zero(path.before(i) - path.places[i]);
    const glm::dvec3 across = glm::cross(ahead, back);
    glm::dvec3 normal = glm::length(across) > kLeastBend ? glm::normalize(across) : known;
    if (glm::dot(normal, known) < 0) normal = -normal;
    normals[i] = known = normal;
  }
  for (std::size_t i = normals.size(); i-- > 1;) {
    if (is_zero(normals[i - 1])) normals[i - 1] = normals[i];
  }
  return normals;
}

/// The plane of the cross-section at each place: its axes as columns.
std::vector<glm::dmat3> section_planes(const Path& path) {
  const std::vector<glm::dvec3> normals = bend_normals(path);
  std::vector<glm::dmat3> planes;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const glm::dvec3 y = unit_or_zero(path.behind(i) - path.before(i));
    if (is_zero(normals[i])) {
      planes.push_back(straight_frame(unit_or_zero(path.places.back() - path.places.front())));
      continue;
    }
    const glm::dvec3 x = unit_or_zero(glm::cross(y, normals[i]));
    const bool folds_back = is_zero(y) || is_zero(x);
    planes.push_back(folds_back && i > 0 ? planes.back() : glm::dmat3(x, y, glm::cross(x, y)));
  }
  return planes;
}

/// Entry i of a list of so many numbers an element; of too few the last serves all others.
template <int N>
glm::vec<N, double> entry(std::span<const double> numbers, std::size_t i, const glm::vec<N, double>& otherwise) {
  const std::size_t count = numbers.size() / N;
  if (count == 0) return otherwise;
  glm::vec<N, double> result;
  for (int c = 0; c < N; ++c) result[c] = numbers[std::min(i, count - 1) * N + static_cast<std::size_t>(c)];
  return result;
}

/// The cross-section where it stands, spine point by spine point.
std::vector<glm::vec3> section_points(const GeometrySource& source, const Curves& curves) {
  const auto scales = source.graph.field(source.node, "scale").numbers;
  const auto orientations = source.graph.field(source.node, "orientation").numbers;
  const Path path = path_of(curves);
  const std::vector<glm::dmat3> planes = section_planes(path);
  std::vector<glm::vec3> points;
  points.reserve(curves.spine.size() * curves.section.size());
  for (std::size_t j = 0; j < curves.spine.size(); ++j) {
    const glm::dvec2 scale = entry<2>(scales, j, glm::dvec2(1));
    const glm::dmat3 turned = planes[path.of_points[j]] * glm::dmat3(rotation_matrix(entry<4>(orientations, j, {0, 0, 1, 0})));
    for (const glm::dvec2& p : curves.section)
      points.emplace_back(curves.spine[j] + turned * glm::dvec3(p.x * scale.x, 0, p.y * scale.y));
  }
  return points;
}

class ExtrusionBuilder {
 public:
  ExtrusionBuilder(const GeometrySource& source, Curves curves) : curves_(std::move(curves)) {
    faces.coords = section_points(source, curves_);
    faces.crease_angle = static_cast<float>(source.graph.number(source.node, "creaseAngle"));
    faces.ccw = source.graph.boolean(source.node, "ccw");
    faces.solid = source.graph.boolean(source.node, "solid");
    faces.convex = source.graph.boolean(source.node, "convex");
    faces.tex_units.resize(1);
  }

  void add_sides();
  void add_cap(std::size_t ring, bool at_begin);

  FaceSet faces;

 private:
  std::uint32_t columns() const { return static_cast<std::uint32_t>(curves_.section.size()); }
  bool ends_meet() const;
  std::uint32_t side_coord(std::uint32_t i, std::uint32_t j, bool wraps) const;

  Curves curves_;
};

/// Whether the last ring is the first: the spine is closed, and neither scale nor orientation keeps them apart.
bool ExtrusionBuilder::ends_meet() const {
  if (!curves_.spine_closed) return false;
  const std::size_t last = (curves_.spine.size() - 1) * columns();
  for (std::size_t i = 0; i < columns(); ++i) {
    const glm::vec3 apart = faces.coords[i] - faces.coords[last + i];
    if (glm::length(apart) > 1e-5F * (glm::length(faces.coords[i]) + 1e-20F)) return false;
  }
  return true;
}

std::uint32_t ExtrusionBuilder::side_coord(std::uint32_t i, std::uint32_t j, bool wraps) const {
  if (curves_.section_closed && i + 1 == columns()) i = 0;
  if (wraps && j + 1 == curves_.spine.size()) j = 0;
  return j * columns() + i;
}

/// The texture lies once around the cross-section and once along the spine.
void ExtrusionBuilder::add_sides() {
  const auto rows = static_cast<std::uint32_t>(curves_.spine.size());
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns(); ++i)
      faces.tex_units[0].emplace_back(static_cast<float>(i) / static_cast<float>(columns() - 1),
                                      static_cast<float>(j) / static_cast<float>(rows - 1), 0, 1);
  }
  const bool wraps = ends_meet();
  const auto corner = [&](std::uint32_t i, std::uint32_t j) {
    return Corner{.coord = side_coord(i, j, wraps), .tex = j * columns() + i};
  };
  for (std::uint32_t j = 0; j + 1 < rows; ++j) {
    for (std::uint32_t i = 0; i + 1 < columns(); ++i)
      faces.add_face(std::array{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  }
}

/// The larger of the cross-section's sizes spans the texture; S runs along x, T along z.
void ExtrusionBuilder::add_cap(std::size_t ring, bool at_begin) {
  const std::size_t count = curves_.section.size() - (curves_.section_closed ? 1 : 0);
  if (count < 3) return;
  glm::dvec2 low = curves_.section[0], high = low;
  for (const glm::dvec2& p : curves_.section) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  std::vector<Corner> cap;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = at_begin ? count - 1 - i : i;  // each is seen from outside
    const glm::dvec2 place = size > 0 ? (curves_.section[at] - low) / size : glm::dvec2(0);
    cap.push_back({.coord = static_cast<std::uint32_t>(faces.coords.size()),
                   .tex = static_cast<std::uint32_t>(faces.tex_units[0].size())});
    faces.coords.push_back(faces.coords[ring * columns() + at]);
    faces.tex_units[0].emplace_back(static_cast<float>(place.x), static_cast<float>(place.y), 0, 1);
  }
  faces.add_face(cap);
}

bool all_finite(const std::vector<glm::vec3>& points) {
  return std::ranges::all_of(points,
                             [](const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

}  // namespace

std::optional<Mesh> make_extrusion(const GeometrySource& source) {
  Curves curves = read_curves(source);
  const std::size_t rows = curves.spine.size(), columns = curves.section.size();
  if (rows < 2 || columns < 2) return Mesh{};
  constexpr std::size_t kCorners = 4;  // of each face
  if (columns > kMaxMeshVertices / kCorners / rows) {
    source.report(DiagnosticId::geometry_limit,
                  fmt::format("this `Extrusion` has {} x {} faces, more than {} corners; plugc takes no more", columns - 1,
                              rows - 1, kMaxMeshVertices));
    return std::nullopt;
  }
  ExtrusionBuilder builder(source, std::move(curves));
  if (!all_finite(builder.faces.coords)) {
    source.report(DiagnosticId::geometry_invalid, "this `Extrusion` has sizes that are not finite numbers");
    return std::nullopt;
  }
  builder.add_sides();
  if (source.graph.boolean(source.node, "beginCap")) builder.add_cap(0, true);
  if (source.graph.boolean(source.node, "endCap")) builder.add_cap(rows - 1, false);
  return mesh_of_faces(std::move(builder.faces), source);
}

}  // namespace plugc
