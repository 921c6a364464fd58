#pragma once
// A mesh with the texture coordinates that a shape's textures want: geometry that two shapes share may have different ones.

#include <compare>
#include <span>

#include "mesh/mesh.h"
#include "scene/scene.h"

namespace plugc {

/// Where the coordinates of one texture come from.
struct UnitCoords {
  VertexCoord kind = VertexCoord::own;
  int unit = 0;  ///< For `own`: the geometry's unit; beyond its last, that one.
  auto operator<=>(const UnitCoords&) const = default;
};

/// Whether the mesh as it was made will do: texture i takes the own coordinates of unit i.
bool are_plain(std::span<const UnitCoords> units);

/// The mesh with coordinates i as `units[i]` asks; coordinates of its own behind those stay.
Mesh with_unit_coords(const Mesh& mesh, std::span<const UnitCoords> units);

}  // namespace plugc
