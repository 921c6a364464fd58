#pragma once
// The lists that Coordinate, Normal, Color and TextureCoordinate nodes hold, as vectors.

#include <vector>

#include "mesh/geometry.h"

namespace plugc {

/// The node's `coord`; empty (and reported) when it is of a type that plugc cannot place.
std::vector<glm::vec3> read_coords(const GeometrySource& source);

/// The node's `normal`, made unit length; empty without one.
std::vector<glm::vec3> read_normals(const GeometrySource& source);

/// The node's `tangent`: of unit length, and which way the texture's t runs (1 or -1, as in tangents.h); empty without one.
std::vector<glm::vec4> read_tangents(const GeometrySource& source);

/// The node's `color`, with alpha 1 where it has none; empty without one.
struct ColorList {
  std::vector<glm::vec4> colors;
  bool have_alpha = false;
};
ColorList read_colors(const GeometrySource& source);

/// The depths of the node's `fogCoord`, as many as it has coords (the last one stands for those that are missing); empty
/// without one.
std::vector<float> read_fog_coords(const GeometrySource& source, std::size_t coord_count);

/// The attributes of authors' shaders that the node's `attrib` holds, a value for each of its coords (X3D 4.1, 31.4.2). Too few
/// are reported, and zeros stand for those that are missing.
std::vector<MeshAttribute> read_attributes(const GeometrySource& source, std::size_t coord_count);

/// The node's `texCoord`, one list a unit. The list of a unit that is NULL or generated is empty.
std::vector<std::vector<glm::vec4>> read_tex_units(const GeometrySource& source);

}  // namespace plugc
