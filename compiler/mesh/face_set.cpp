// Faces to triangles. Corners with the same indices become one vertex (found by an open-addressing table over all
// corners). Convex faces and triangles are fans around their first corner; the others are projected along their normal and
// ear-clipped. Texture units that the node leaves out get the default for the coordinate.

#include "mesh/face_set.h"

#include <bit>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/box_texture.h"
#include "base/limits.h"
#include "mesh/mesh_attribute.h"
#include "mesh/triangulate.h"

namespace plugc {

namespace {

// Gives each different corner a number, in the order of first appearance.
class CornerTable {
 public:
  explicit CornerTable(std::size_t corners) : slots_(std::bit_ceil(corners * 2 + 1), kNoIndex) {}

  std::uint32_t find_or_add(const Corner& corner) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(corner) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == kNoIndex) {
        slots_[slot] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(corner);
        return slots_[slot];
      }
      if (vertices[slots_[slot]] == corner) return slots_[slot];
    }
  }

  std::vector<Corner> vertices;

 private:
  static std::size_t hash(const Corner& corner) {
    std::uint64_t h = 0;
    for (const std::uint32_t part : {corner.coord, corner.normal, corner.color, corner.tex, corner.tangent}) {
      h = (h ^ part) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }

  std::vector<std::uint32_t> slots_;
};

// Two axes of the plane across `normal`, such that counter-clockwise stays so for who looks against the normal.
std::vector<glm::dvec2> project(const FaceSet& faces, std::span<const Corner> face, const glm::dvec3& normal) {
  const glm::dvec3 helper = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, normal));
  const glm::dvec3 up = glm::cross(normal, right);
  const glm::dvec3 origin = faces.coords[face[0].coord];
  std::vector<glm::dvec2> points;
  points.reserve(face.size());
  for (const Corner& corner : face) {
    const glm::dvec3 p = glm::dvec3(faces.coords[corner.coord]) - origin;
    points.push_back({glm::dot(p, right), glm::dot(p, up)});
  }
  return points;
}

class FaceTriangulator {
 public:
  FaceTriangulator(const FaceSet& faces, std::span<const glm::vec3> of_faces, const GeometrySource& source)
      : faces_(faces), of_faces_(of_faces), source_(source), table_(faces.corners.size()) {}

  void add_all() {
    for (std::size_t face = 0; face < faces_.face_count(); ++face) add(face);
  }

  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> corner_vertices;  // by corner of the faces
  std::vector<std::uint32_t> vertex_faces;     // by vertex: the first face that has it
  const std::vector<Corner>& vertices() const { return table_.vertices; }

 private:
  void add(std::size_t index) {
    const std::span<const Corner> face = faces_.face(index);
    vertex_.clear();
    for (const Corner& corner : face) vertex_.push_back(table_.find_or_add(corner));
    vertex_faces.resize(table_.vertices.size(), static_cast<std::uint32_t>(index));
    corner_vertices.insert(corner_vertices.end(), vertex_.begin(), vertex_.end());
    if (faces_.convex || face.size() == 3 || !add_clipped(face, of_faces_[index])) add_fan();
  }

  void add_fan() {
    for (std::size_t i = 1; i + 1 < vertex_.size(); ++i)
      indices.insert(indices.end(), {vertex_[0], vertex_[i], vertex_[i + 1]});
  }

  bool add_clipped(std::span<const Corner> face, const glm::vec3& normal) {
    if (face.size() > kMaxPolygonCorners) {
      source_.report(DiagnosticId::geometry_limit,
                     fmt::format("a face has {} corners; plugc cuts up to {} into triangles and takes "
                                 "larger ones as convex",
                                 face.size(), kMaxPolygonCorners));
      return false;
    }
    const auto count = static_cast<std::uint32_t>(face.size());
    const glm::dvec3 as_written = faces_.ccw ? normal : -normal;  // corners run counter-clockwise around this one
    const auto triangles = triangulate(project(faces_, face, as_written), {&count, 1}, &work_left_);
    for (const std::uint32_t i : triangles) indices.push_back(vertex_[i]);
    if (triangles.empty()) report_work();
    return !triangles.empty();
  }

  void report_work() {
    if (!std::exchange(reported_work_, true))
      source_.report(DiagnosticId::geometry_limit,
                     fmt::format("this `{}` has more concave corners than plugc cuts into triangles in bearable time; it takes "
                                 "some faces as convex",
                                 source_.type()));
  }

  const FaceSet& faces_;
  std::span<const glm::vec3> of_faces_;
  const GeometrySource& source_;
  CornerTable table_;
  std::vector<std::uint32_t> vertex_;  // of the face at hand
  std::uint64_t work_left_ = kMaxPolygonWork;
  bool reported_work_ = false;
};

// Box texture over the coordinates that faces use; those that none uses must not stretch it.
std::vector<glm::vec4> default_tex_of(const FaceSet& faces, std::span<const glm::vec3> vertex_positions,
                                      std::span<const Corner> vertices) {
  if (faces.default_tex.empty()) return box_texture(vertex_positions);
  std::vector<glm::vec4> result;
  for (const Corner& vertex : vertices) result.push_back(faces.default_tex[vertex.coord]);
  return result;
}

void fill_tex_coords(Mesh& mesh, const FaceSet& faces, std::span<const Corner> vertices) {
  mesh.tex_coords.resize(std::max<std::size_t>(faces.tex_units.size(), 1));
  for (std::size_t unit = 0; unit < mesh.tex_coords.size(); ++unit) {
    if (unit >= faces.tex_units.size() || faces.tex_units[unit].empty()) {
      mesh.tex_coords[unit] = default_tex_of(faces, mesh.positions, vertices);
      continue;
    }
    mesh.tex_coords[unit].reserve(vertices.size());
    for (const Corner& vertex : vertices) mesh.tex_coords[unit].push_back(faces.tex_units[unit][vertex.tex]);
  }
}

void fill_attributes(Mesh& mesh, const FaceSet& faces, std::span<const Corner> vertices) {
  for (const MeshAttribute& by_coord : faces.attributes) {
    MeshAttribute& attribute = mesh.attributes.emplace_back(by_coord);
    attribute.values.clear();
    attribute.values.reserve(vertices.size() * number_count(by_coord));
    for (const Corner& vertex : vertices) {
      const std::span<const float> numbers = numbers_at(by_coord, vertex.coord);
      attribute.values.insert(attribute.values.end(), numbers.begin(), numbers.end());
    }
  }
}

// The first vertex at each one's coordinate.
std::vector<std::uint32_t> first_at_points(const FaceSet& faces, std::span<const Corner> vertices) {
  std::vector<std::uint32_t> first(faces.coords.size(), kNoIndex), result;
  result.reserve(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    std::uint32_t& known = first[vertices[v].coord];
    if (known == kNoIndex) known = v;
    result.push_back(known);
  }
  return result;
}

MadeNormals made_normals(const FaceSet& faces, FaceTriangulator& triangulator) {
  MadeNormals made;
  made.face_ends = faces.face_ends;
  made.vertex_points = first_at_points(faces, triangulator.vertices());
  made.corners = std::move(triangulator.corner_vertices);
  made.vertex_faces = std::move(triangulator.vertex_faces);
  made.least_cosine = least_cosine(faces);
  made.clockwise = !faces.ccw;
  return made;
}

std::shared_ptr<const LiveVertices> make_live(const FaceSet& faces, bool normals_are_made, FaceTriangulator& triangulator,
                                              const Mesh& mesh) {
  std::vector<VertexPlaces> places;
  places.reserve(triangulator.vertices().size());
  for (const Corner& vertex : triangulator.vertices())
    places.push_back({vertex.coord, vertex.normal, vertex.color, vertex.tex});
  auto live = std::make_shared<LiveVertices>();
  live->feeds = make_feeds(faces.lists, mesh, places);
  if (!faces.lists.coord.changes()) return live;
  if (normals_are_made) live->normals = made_normals(faces, triangulator);
  for (std::size_t unit = 0; unit < mesh.tex_coords.size(); ++unit) {
    const bool written = unit < faces.tex_units.size() && !faces.tex_units[unit].empty();
    live->box_coords.push_back(written ? VertexCoord::own : VertexCoord::bounds_2d);
  }
  return live;
}

}  // namespace

std::optional<Mesh> mesh_of_faces(FaceSet faces, const GeometrySource& source) {
  const std::vector<glm::vec3> of_faces = face_normals(faces);
  const bool normals_are_made = faces.normals.empty();
  if (normals_are_made) generate_normals(faces, of_faces);
  FaceTriangulator triangulator(faces, of_faces, source);
  triangulator.add_all();

  Mesh mesh;
  mesh.indices = std::move(triangulator.indices);
  mesh.solid = faces.solid;
  mesh.ccw = faces.ccw;
  mesh.colors_have_alpha = faces.colors_have_alpha;
  mesh.positions.reserve(triangulator.vertices().size());
  mesh.normals.reserve(triangulator.vertices().size());
  for (const Corner& vertex : triangulator.vertices()) {
    mesh.positions.push_back(faces.coords[vertex.coord]);
    mesh.normals.push_back(faces.normals[vertex.normal]);
    if (!faces.colors.empty()) mesh.colors.push_back(faces.colors[vertex.color]);
    if (!faces.tangents.empty()) mesh.tangents.push_back(faces.tangents[vertex.tangent]);
    if (!faces.fog_coords.empty()) mesh.fog_coords.push_back(faces.fog_coords[vertex.coord]);
  }
  fill_tex_coords(mesh, faces, triangulator.vertices());
  fill_attributes(mesh, faces, triangulator.vertices());
  if (faces.lists.any()) mesh.live = make_live(faces, normals_are_made, triangulator, mesh);
  return mesh;
}

}  // namespace plugc
