#pragma once
// What of a mesh's vertices events change while the scene is drawn: which list each takes its numbers from, and what is made
// of the positions anew. PackedLiveMesh has the same.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/geometry.h"
#include "scene/scene.h"

namespace plugc {

enum class VertexPart : std::uint8_t { position, normal, color, tex_coord, fog_coord, attribute };

inline constexpr std::uint32_t kKeepsItsOwn = UINT32_MAX;  ///< In place of an element.

/// Vertex v takes element `elements[v]`, of `width` numbers, of a list.
struct VertexFeed {
  VertexPart part = VertexPart::position;
  unsigned number = 0;  ///< Of a texture coordinate: its unit; of an attribute: its place in the mesh's list.
  std::uint32_t slot = kSceneNoSlot;
  std::uint32_t width = 3;
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

/// Whether events move the mesh's vertices.
bool positions_move(const Mesh& mesh);
/// Numbers a vertex that events feed texture coordinate `unit` with; 0: none.
std::uint32_t fed_width(const Mesh& mesh, unsigned unit);

/// A list of a geometry's as its slot holds it.
struct ListSlot {
  std::uint32_t slot = kSceneNoSlot;  ///< None: nothing changes the list.
  std::uint32_t width = 3;            ///< Numbers an element.
  std::uint32_t count = 0;            ///< Elements.

  bool changes() const { return slot != kSceneNoSlot; }
};

/// Those of one geometry that events change.
struct ListSlots {
  ListSlot coord, normal, color, fog_coord;
  std::vector<ListSlot> tex_units;                                ///< As read_tex_units().
  std::vector<std::pair<std::string_view, ListSlot>> attributes;  ///< By name.

  bool any() const;
};
ListSlots read_list_slots(const GeometrySource& source);

/// Numbers of a list that vertices are made of, as it is at first.
std::span<const double> list_numbers(const GeometrySource& source, NodeId node, std::string_view field);

/// Of a mesh whose vertices are the points of one list in order, two numbers each, with a picture over their box; null where
/// nothing changes the list.
std::shared_ptr<const LiveVertices> make_live_points(const GeometrySource& source, std::string_view field,
                                                     std::size_t vertex_count);

/// Where a vertex stands in each of the lists.
struct VertexPlaces {
  std::uint32_t coord = 0, normal = 0, color = 0, tex = 0;
};
/// The feeds of a mesh that has these vertices.
std::vector<VertexFeed> make_feeds(const ListSlots& slots, const Mesh& mesh, std::span<const VertexPlaces> vertices);

}  // namespace plugc
