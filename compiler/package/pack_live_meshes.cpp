// One to one, in the order of the package's meshes.

#include "package/pack_live_meshes.h"

#include <memory>

#include "mesh/live_vertices.h"

namespace plugc {
namespace {

PackedSemantic semantic_of(VertexPart part) {
  switch (part) {
    case VertexPart::position: return PackedSemantic::position;
    case VertexPart::normal: return PackedSemantic::normal;
    case VertexPart::color: return PackedSemantic::color;
    case VertexPart::tex_coord: return PackedSemantic::tex_coord;
    case VertexPart::fog_coord: return PackedSemantic::fog_coord;
    case VertexPart::attribute: break;
  }
  return PackedSemantic::custom;
}

std::unique_ptr<PackedVertexFeedT> pack_feed(const VertexFeed& feed) {
  auto packed = std::make_unique<PackedVertexFeedT>();
  packed->semantic = semantic_of(feed.part);
  packed->unit = static_cast<std::uint8_t>(feed.number);
  packed->width = static_cast<std::uint8_t>(feed.width);
  packed->slot = feed.slot;
  packed->elements = feed.elements;
  return packed;
}

std::unique_ptr<PackedMadeNormalsT> pack_normals(const MadeNormals& normals) {
  auto packed = std::make_unique<PackedMadeNormalsT>();
  packed->face_ends = normals.face_ends;
  packed->corners = normals.corners;
  packed->vertex_faces = normals.vertex_faces;
  packed->vertex_points = normals.vertex_points;
  packed->least_cosine = normals.least_cosine;
  packed->clockwise = normals.clockwise;
  return packed;
}

std::unique_ptr<PackedLiveMeshT> pack_live_mesh(const LiveVertices& live, std::uint32_t mesh) {
  auto packed = std::make_unique<PackedLiveMeshT>();
  packed->mesh = mesh;
  for (const VertexFeed& feed : live.feeds) packed->feeds.push_back(pack_feed(feed));
  if (live.normals) packed->normals = pack_normals(*live.normals);
  for (std::uint32_t unit = 0; unit < live.box_coords.size(); ++unit) {
    if (live.box_coords[unit] == VertexCoord::own) continue;
    const bool all = live.box_coords[unit] == VertexCoord::bounds_3d;
    packed->box_coords.emplace_back(unit, all ? PackedBoxLayout::all_sides : PackedBoxLayout::longest_sides);
  }
  packed->tangent_unit = live.tangent_unit;
  return packed;
}

}  // namespace

void pack_live_meshes(const SceneParts& parts, const std::map<const Mesh*, std::uint32_t>& indices, PackedSceneT& packed) {
  std::map<std::uint32_t, const LiveVertices*> live;
  for (const ShapePlan& plan : parts.shapes) {
    const auto index = indices.find(plan.mesh.get());
    if (index != indices.end() && plan.mesh->live != nullptr) live[index->second] = plan.mesh->live.get();
  }
  for (const auto& [mesh, vertices] : live) packed.live_meshes.push_back(pack_live_mesh(*vertices, mesh));
}

}  // namespace plugc
