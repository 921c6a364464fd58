// Coordinates are chosen or laid over the box of all positions; everything else is copied.

#include "mesh/unit_coords.h"

#include <algorithm>

#include "base/box_texture.h"
#include "mesh/live_vertices.h"

namespace plugc {
namespace {

std::vector<glm::vec4> coords_of(const Mesh& mesh, const UnitCoords& asked) {
  if (asked.kind == VertexCoord::bounds_3d) return box_texture_3d(mesh.positions);
  if (asked.kind == VertexCoord::bounds_2d || mesh.tex_coords.empty()) return box_texture(mesh.positions);
  return mesh.tex_coords[std::min(static_cast<std::size_t>(asked.unit), mesh.tex_coords.size() - 1)];
}

UnitCoords asked_of(std::span<const UnitCoords> units, std::size_t unit) {
  return unit < units.size() ? units[unit] : UnitCoords{VertexCoord::own, static_cast<int>(unit)};
}

/// What events change of coordinates that were chosen so.
std::shared_ptr<const LiveVertices> live_with_unit_coords(const Mesh& mesh, std::span<const UnitCoords> units,
                                                          std::size_t count) {
  const LiveVertices& old = *mesh.live;
  auto live = std::make_shared<LiveVertices>(old);
  const auto is_tex_coord = [](const VertexFeed& feed) { return feed.part == VertexPart::tex_coord; };
  std::erase_if(live->feeds, is_tex_coord);
  const bool positions_move = !old.box_coords.empty();
  if (positions_move) live->box_coords.assign(count, VertexCoord::bounds_2d);
  for (std::size_t i = 0; i < count; ++i) {
    const UnitCoords asked = asked_of(units, i);
    if (asked.kind != VertexCoord::own) {
      if (positions_move) live->box_coords[i] = asked.kind;
      continue;
    }
    if (mesh.tex_coords.empty()) continue;  // the box's
    const std::size_t own = std::min(static_cast<std::size_t>(asked.unit), mesh.tex_coords.size() - 1);
    if (positions_move) live->box_coords[i] = old.box_coords[own];
    for (const VertexFeed& feed : old.feeds) {
      if (!is_tex_coord(feed) || feed.number != own) continue;
      live->feeds.push_back(feed);
      live->feeds.back().number = static_cast<unsigned>(i);
    }
  }
  return live;
}

}  // namespace

bool are_plain(std::span<const UnitCoords> units) {
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (units[i] != UnitCoords{VertexCoord::own, static_cast<int>(i)}) return false;
  }
  return true;
}

Mesh with_unit_coords(const Mesh& mesh, std::span<const UnitCoords> units) {
  Mesh made = mesh;
  made.tex_coords.resize(std::max(mesh.tex_coords.size(), units.size()));
  for (std::size_t i = 0; i < units.size(); ++i) made.tex_coords[i] = coords_of(mesh, units[i]);
  if (mesh.live != nullptr) made.live = live_with_unit_coords(mesh, units, made.tex_coords.size());
  return made;
}

}  // namespace plugc
