#pragma once
// What of a mesh's vertices events change while the scene is drawn: which list each takes its numbers from, and what is made
// of the positions anew.

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/mesh.h"
#include "scene/scene.h"

namespace plugc {

enum class VertexPart : std::uint8_t { position, normal, color, tex_coord, fog_coord, attribute };

inline constexpr std::uint32_t kKeepsItsOwn = UINT32_MAX;  ///< In place of an element.

/// Vertex v takes element `elements[v]` of a list.
struct VertexFeed {
  VertexPart part = VertexPart::position;
  unsigned number = 0;  ///< Of a texture coordinate: its unit; of an attribute: its place in the mesh's list.
  std::uint32_t slot = kSceneNoSlot;
  std::vector<std::uint32_t> elements;
};

/// Normals of the faces around each vertex, as PackedMadeNormals has them.
struct MadeNormals {
  std::vector<std::uint32_t> face_ends, corners;
  std::vector<std::uint32_t> vertex_faces, vertex_points;
  float least_cosine = -2;
  bool clockwise = false;
};

struct LiveVertices {
  std::vector<VertexFeed> feeds;
  std::optional<MadeNormals> normals;   ///< None: they are fed, or nothing moves.
  std::vector<VertexCoord> box_coords;  ///< By unit: what is laid over the box of the positions; `own`: nothing.
  int tangent_unit = -1;                ///< Along whose texture coordinates tangents run; -1: they stay, or there are none.
};

}  // namespace plugc
