#pragma once
// Lists of a geometry's that events change while the scene is drawn.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scene/node_graph.h"

namespace plugc {

/// A list that vertices take their numbers from: `point` of a Coordinate, `vector` of a Normal and so on.
struct VertexField {
  NodeId node;
  std::string_view field;
  std::uint32_t slot = 0;
};

/// The slot of that field; none for one that nothing changes.
std::optional<std::uint32_t> vertex_slot(std::span<const VertexField> fields, NodeId node, std::string_view field);

}  // namespace plugc
