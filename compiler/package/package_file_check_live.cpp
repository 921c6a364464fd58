// Meshes whose vertices follow slots: every list has an entry a vertex, and every entry leads somewhere.

#include "package/package_file_check.h"

namespace plugc {
namespace {

using Indices = flatbuffers::Vector<std::uint32_t>;

constexpr std::uint32_t kKeepsItsOwn = UINT32_MAX;  // in place of an element

bool has_stream(const PackedMesh& mesh, PackedSemantic semantic, std::uint32_t unit) {
  if (semantic == PackedSemantic::custom) return mesh.attributes() != nullptr && unit < mesh.attributes()->size();
  for (const PackedStream* stream : *mesh.streams()) {
    if (stream->semantic() == semantic && stream->unit() == unit) return true;
  }
  return false;
}

/// A number a vertex, all less than `size`, or kKeepsItsOwn where that may be.
bool check_by_vertex(SceneCheck& scene, const PackedMesh& mesh, const char* word, const Indices& list, std::uint64_t size,
                     bool may_be_none, const Place& place) {
  if (list.size() != mesh.vertex_count())
    return scene.check.fail(place, fmt::format("{} entries are for {} vertices", list.size(), mesh.vertex_count()));
  return scene.check.each(&place, word, list, [&](std::uint32_t index, const Place& at) {
    return (may_be_none && index == kKeepsItsOwn) || scene.check.require_index(at, "number", index, size);
  });
}

bool check_feed(SceneCheck& scene, const PackedMesh& mesh, const PackedVertexFeed& feed, const Place& place) {
  if (!is_enumerator(feed.semantic()) || !has_stream(mesh, feed.semantic(), feed.unit()))
    return scene.check.fail(place, "its mesh has no such stream");
  if (feed.width() == 0) return scene.check.fail(place, "its elements have no numbers");
  if (!scene.present_slot(place, "it", feed.slot(), feed.width())) return false;
  const std::uint64_t elements = scene.slot_size(feed.slot()) / feed.width();
  return check_by_vertex(scene, mesh, "element", *feed.elements(), elements, true, place);
}

bool check_faces(SceneCheck& scene, const PackedMesh& mesh, const PackedMadeNormals& normals, const Place& place) {
  const std::size_t corners = normals.corners()->size();
  std::uint32_t last = 0;
  return scene.check.each(&place, "face", *normals.face_ends(),
                          [&](std::uint32_t end, const Place& at) {
                            const bool grows = end >= last && end <= corners;
                            last = end;
                            return grows || scene.check.fail(at, fmt::format("it cannot end at corner {}", end));
                          }) &&
         (last == corners || scene.check.fail(place, "its last corners are in no face")) &&
         scene.check.each(&place, "corner", *normals.corners(), [&](std::uint32_t vertex, const Place& at) {
           return scene.check.require_index(at, "vertex", vertex, mesh.vertex_count());
         });
}

bool check_normals(SceneCheck& scene, const PackedMesh& mesh, const PackedMadeNormals* normals, const Place& place) {
  if (normals == nullptr) return true;
  return (has_stream(mesh, PackedSemantic::normal, 0) || scene.check.fail(place, "its mesh has no normals")) &&
         check_faces(scene, mesh, *normals, place) &&
         check_by_vertex(scene, mesh, "face of vertex", *normals->vertex_faces(), normals->face_ends()->size(), false, place) &&
         check_by_vertex(scene, mesh, "place of vertex", *normals->vertex_points(), mesh.vertex_count(), false, place);
}

bool check_tangents(SceneCheck& scene, const PackedMesh& mesh, std::int32_t unit, const Place& place) {
  if (unit < 0) return true;
  const bool fits = mesh.topology() == PackedTopology::triangles && has_stream(mesh, PackedSemantic::normal, 0) &&
                    has_stream(mesh, PackedSemantic::tangent, 0) &&
                    has_stream(mesh, PackedSemantic::tex_coord, static_cast<std::uint32_t>(unit));
  return fits || scene.check.fail(place, "its mesh has not what tangents need");
}

bool check_live_mesh(SceneCheck& scene, const PackedLiveMesh& live, const Place& place) {
  PackageCheck& check = scene.check;
  if (!check.require_index(place, "mesh", live.mesh(), check.package.meshes()->size())) return false;
  const auto before = static_cast<flatbuffers::uoffset_t>(place.index) - 1;
  if (place.index != 0 && scene.scene.live_meshes()->Get(before)->mesh() >= live.mesh())
    return check.fail(place, "it is out of order");
  const PackedMesh& mesh = *check.package.meshes()->Get(live.mesh());
  return check.each(&place, "feed", *live.feeds(),
                    [&](const PackedVertexFeed* feed, const Place& at) { return check_feed(scene, mesh, *feed, at); }) &&
         check_normals(scene, mesh, live.normals(), place) && check_tangents(scene, mesh, live.tangent_unit(), place) &&
         (live.box_coords() == nullptr ||
          check.each(&place, "box coordinates", *live.box_coords(), [&](const PackedBoxCoords* coords, const Place& at) {
            return (is_enumerator(coords->layout()) && has_stream(mesh, PackedSemantic::tex_coord, coords->unit())) ||
                   check.fail(at, "its mesh has no such coordinates");
          }));
}

}  // namespace

bool check_live_meshes(SceneCheck& scene, const Place& place) {
  const auto* meshes = scene.scene.live_meshes();
  return meshes == nullptr || scene.check.each(&place, "live mesh", *meshes, [&](const PackedLiveMesh* live, const Place& at) {
    return check_live_mesh(scene, *live, at);
  });
}

}  // namespace plugc
