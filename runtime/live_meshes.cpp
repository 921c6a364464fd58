// A feed whose slot has changed is written into the vertices; then what follows from positions is made anew: the box, normals,
// coordinates that lie over the box, and tangents last, which follow from all of these. Each stream is read from the vertices
// and written back whole.

#include "runtime/live_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/box_texture.h"
#include "base/vertex_tangents.h"
#include "runtime/mesh_vertices.h"
#include "runtime/uniforms.h"

namespace plugc {
namespace {

constexpr std::uint32_t kKeepsItsOwn = UINT32_MAX;  // in place of an element

/// Floats in each vertex.
struct Place {
  std::uint32_t offset = 0, count = 0;
};

/// No floats where the mesh has no such stream.
Place stream_place(const PackedMesh& mesh, PackedSemantic semantic, std::uint32_t unit) {
  const PackedStream* const stream = find_stream(mesh, semantic, unit);
  return stream == nullptr ? Place() : Place{stream->offset(), stream->components()};
}

Place feed_place(const PackedMesh& mesh, const PackedVertexFeed& feed) {
  if (feed.semantic() != PackedSemantic::custom) return stream_place(mesh, feed.semantic(), feed.unit());
  const PackedMeshAttribute& attribute = *mesh.attributes()->Get(feed.unit());
  return {attribute.offset(), std::uint32_t{attribute.columns()} * attribute.components()};
}

template <typename Vector>
std::vector<Vector> read_stream(const LiveMesh& live, PackedSemantic semantic, std::uint32_t unit, const Vector& missing) {
  const Place place = stream_place(*live.mesh, semantic, unit);
  std::vector<Vector> values(live.mesh->vertex_count(), missing);
  const std::size_t bytes = std::min<std::size_t>(place.count, Vector::length()) * sizeof(float);
  for (std::size_t v = 0; v < values.size(); ++v)
    std::memcpy(&values[v], live.vertices.data() + v * live.mesh->stride() + place.offset, bytes);
  return values;
}

template <typename Vector>
void write_stream(LiveMesh& live, PackedSemantic semantic, std::uint32_t unit, const std::vector<Vector>& values) {
  const Place place = stream_place(*live.mesh, semantic, unit);
  const std::size_t bytes = std::min<std::size_t>(place.count, Vector::length()) * sizeof(float);
  for (std::size_t v = 0; v < values.size(); ++v)
    std::memcpy(live.vertices.data() + v * live.mesh->stride() + place.offset, &values[v], bytes);
}

/// As the compiler has them; zero turns to z.
void make_unit_length(float* normal) {
  const glm::vec3 read(normal[0], normal[1], normal[2]);
  const float length = glm::length(read);
  const glm::vec3 unit = length > 0 && std::isfinite(length) ? read / length : glm::vec3(0, 0, 1);
  std::copy_n(&unit.x, 3, normal);
}

void write_feed(LiveMesh& live, const PackedVertexFeed& feed, std::span<const double> numbers) {
  constexpr std::uint32_t kMostNumbers = 16;
  const Place place = feed_place(*live.mesh, feed);
  const std::uint32_t count = std::min({place.count, std::uint32_t{feed.width()}, kMostNumbers});
  const bool is_normal = feed.semantic() == PackedSemantic::normal && count == 3;
  for (flatbuffers::uoffset_t v = 0; v < feed.elements()->size(); ++v) {
    const std::uint32_t element = feed.elements()->Get(v);
    if (element == kKeepsItsOwn) continue;
    float values[kMostNumbers] = {};
    for (std::uint32_t i = 0; i < count; ++i) values[i] = finite_float(numbers[std::size_t{element} * feed.width() + i]);
    if (is_normal) make_unit_length(values);
    std::memcpy(live.vertices.data() + std::size_t{v} * live.mesh->stride() + place.offset, values, count * sizeof(float));
  }
}

std::span<const std::uint32_t> as_span(const flatbuffers::Vector<std::uint32_t>& list) {
  return {list.data(), list.size()};
}

PolygonList polygons(std::span<const std::uint32_t> corners, const PackedMadeNormals& made) {
  return {corners, as_span(*made.face_ends()), made.clockwise()};
}

void make_normals(LiveMesh& live, std::span<const glm::vec3> positions) {
  const PackedMadeNormals& made = *live.packed->normals();
  const std::vector<glm::vec3> of_faces = polygon_normals(polygons(as_span(*made.corners()), made), positions);
  std::vector<glm::vec3> normals;
  normals.reserve(positions.size());
  for (flatbuffers::uoffset_t v = 0; v < positions.size(); ++v)
    normals.push_back(smooth_normal(made.vertex_faces()->Get(v), live.corners_at.at(made.vertex_points()->Get(v)), of_faces,
                                    made.least_cosine()));
  write_stream(live, PackedSemantic::normal, 0, normals);
}

void lay_over_box(LiveMesh& live, std::span<const glm::vec3> positions) {
  if (live.packed->box_coords() == nullptr) return;
  for (const PackedBoxCoords* coords : *live.packed->box_coords()) {
    const bool all_sides = coords->layout() == PackedBoxLayout::all_sides;
    write_stream(live, PackedSemantic::tex_coord, coords->unit(),
                 all_sides ? box_texture_3d(positions) : box_texture(positions));
  }
}

void follow_positions(LiveMesh& live) {
  const auto positions = read_stream(live, PackedSemantic::position, 0, glm::vec3(0));
  live.bounds = {};
  for (const glm::vec3& position : positions) live.bounds = join(live.bounds, {glm::dvec3(position), glm::dvec3(position)});
  if (live.packed->normals() != nullptr) make_normals(live, positions);
  lay_over_box(live, positions);
}

void make_tangents(LiveMesh& live) {
  if (live.packed->tangent_unit() < 0) return;
  const auto unit = static_cast<std::uint32_t>(live.packed->tangent_unit());
  const auto positions = read_stream(live, PackedSemantic::position, 0, glm::vec3(0));
  const auto normals = read_stream(live, PackedSemantic::normal, 0, glm::vec3(0, 0, 1));
  const auto tex_coords = read_stream(live, PackedSemantic::tex_coord, unit, glm::vec4(0, 0, 0, 1));
  write_stream(live, PackedSemantic::tangent, 0,
               vertex_tangents({as_span(*live.mesh->indices()), positions, normals, tex_coords}));
}

/// True where a position has changed.
bool update_live_mesh(LiveMesh& live, const Slots& slots) {
  bool changed = false, moved = false;
  for (flatbuffers::uoffset_t i = 0; i < live.packed->feeds()->size(); ++i) {
    const PackedVertexFeed& feed = *live.packed->feeds()->Get(i);
    const std::uint64_t changed_at = slots.changed_at(feed.slot());
    if (std::exchange(live.taken[i], changed_at) == changed_at) continue;
    write_feed(live, feed, slots.values(feed.slot()));
    changed = true;
    moved = moved || feed.semantic() == PackedSemantic::position;
  }
  if (moved) follow_positions(live);
  if (changed) make_tangents(live);
  if (changed) ++live.version;
  return moved;
}

LiveMesh make_live_mesh(const PackedLiveMesh& packed, const PackedMesh& mesh) {
  LiveMesh live;
  live.packed = &packed;
  live.mesh = &mesh;
  live.vertices.assign(mesh.vertices()->begin(), mesh.vertices()->end());
  const PackedVec3 &low = *mesh.bounds_min(), &high = *mesh.bounds_max();
  live.bounds = {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
  live.taken.resize(packed.feeds()->size());
  if (packed.normals() == nullptr) return live;
  for (const std::uint32_t corner : *packed.normals()->corners())
    live.corner_points.push_back(packed.normals()->vertex_points()->Get(corner));
  live.corners_at = corners_at_points(polygons(live.corner_points, *packed.normals()), mesh.vertex_count());
  return live;
}

}  // namespace

const LiveMesh* LiveMeshes::find(std::uint32_t mesh) const {
  const auto found = std::ranges::lower_bound(list, mesh, {}, [](const LiveMesh& one) { return one.packed->mesh(); });
  return found == list.end() || found->packed->mesh() != mesh ? nullptr : &*found;
}

LiveMeshes make_live_meshes(const Package& package, const PackedScene& scene) {
  LiveMeshes meshes;
  if (scene.live_meshes() == nullptr) return meshes;
  for (const PackedLiveMesh* packed : *scene.live_meshes())
    meshes.list.push_back(make_live_mesh(*packed, *package.meshes()->Get(packed->mesh())));
  return meshes;
}

bool update_live_meshes(LiveMeshes& meshes, const Slots& slots) {
  if (meshes.revision == slots.revision()) return false;
  meshes.revision = slots.revision();
  bool moved = false;
  for (LiveMesh& live : meshes.list) moved = update_live_mesh(live, slots) || moved;
  return moved;
}

std::span<const std::uint8_t> vertex_bytes(const PackedMesh& mesh, const LiveMesh* live) {
  if (live != nullptr) return live->vertices;
  return {mesh.vertices()->data(), mesh.vertices()->size()};
}

}  // namespace plugc
