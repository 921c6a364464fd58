#pragma once
// Geometry nodes as indexed triangles, lines or points. Object space, right-handed, units as in the scene.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "base/diagnostics.h"
#include "scene/node_graph.h"
#include "scene/vertex_field.h"

namespace plugc {

enum class Topology : std::uint8_t { triangles, lines, points };

/// Numbers of an author's at each vertex, for shaders: FloatVertexAttribute, Matrix3VertexAttribute, Matrix4VertexAttribute.
struct MeshAttribute {
  std::string name;
  std::uint8_t columns = 1, components = 4;  ///< Columns of a matrix (else 1), numbers in each.
  std::vector<float> values;                 ///< columns * components a vertex.
  friend bool operator==(const MeshAttribute&, const MeshAttribute&) = default;
};

struct LiveVertices;

struct Mesh {
  Topology topology = Topology::triangles;
  std::vector<glm::vec3> positions;                ///< All count for the bounds, also those that no index names (Text).
  std::vector<glm::vec3> normals;                  ///< Unit length; empty for lines and points without normals.
  std::vector<std::vector<glm::vec4>> tex_coords;  ///< Per unit (s, t, r, q), as many as the node has or at least one default.
  std::vector<glm::vec4> colors;                   ///< Linear RGBA; empty without a Color node.
  bool colors_have_alpha = false;
  std::vector<glm::vec4> tangents;  ///< For normal maps (tangents.h): written ones, or what was asked for; else empty.
  std::vector<float> fog_coords;    ///< Depth in the fog; empty without a FogCoordinate node.
  std::vector<MeshAttribute> attributes;
  std::vector<std::uint32_t> indices;        ///< Counter-clockwise triangles seen from the front.
  bool solid = true;                         ///< Back faces need not be drawn.
  bool ccw = true;                           ///< False: front faces are clockwise in `indices` (already as written).
  std::shared_ptr<const LiveVertices> live;  ///< What of its vertices events change (live_vertices.h); null: nothing.
  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// The triangles of one geometry node; nullopt (with a diagnostic) where it has nothing to draw.
/// `changing`: lists that events change; vertices that use them get a `live` part.
/// Sources: X3D 4.1 (ISO/IEC 19775-1) clauses 11 (Rendering), 13 (Geometry3D), 18 (Texturing); Newell's teapot patches.
std::optional<Mesh> make_mesh(const NodeGraph& graph, NodeId geometry, Diagnostics& diagnostics,
                              std::span<const VertexField> changing = {});

}  // namespace plugc
