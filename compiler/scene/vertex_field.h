#pragma once
// Lists of a geometry's that events change while the scene is drawn.

#include <cstdint>
#include <span>
#include <string_view>

#include "scene/node_graph.h"

namespace plugc {

/// A list that vertices take their numbers from: `point` of a Coordinate, `vector` of a Normal and so on.
struct VertexField {
  NodeId node;
  std::string_view field;
  std::uint32_t slot = 0;
  std::span<const double> start;  ///< What it holds at first: as written, or, where nothing is, what the first key will send.
};

/// The field with its slot; null for one that nothing changes.
const VertexField* find_vertex_field(std::span<const VertexField> fields, NodeId node, std::string_view field);

}  // namespace plugc
