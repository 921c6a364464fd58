// Coordinates are chosen or laid over the box of all positions; everything else is copied.

#include "mesh/unit_coords.h"

#include <algorithm>

#include "mesh/box_texture.h"

namespace plugc {
namespace {

std::vector<glm::vec4> coords_of(const Mesh& mesh, const UnitCoords& asked) {
  if (asked.kind == VertexCoord::bounds_3d) return box_texture_3d(mesh.positions);
  if (asked.kind == VertexCoord::bounds_2d || mesh.tex_coords.empty()) return box_texture(mesh.positions);
  return mesh.tex_coords[std::min(static_cast<std::size_t>(asked.unit), mesh.tex_coords.size() - 1)];
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
  return made;
}

}  // namespace plugc
