// Fields are in order of their nodes; a node has few.

#include "scene/vertex_field.h"

#include <algorithm>

namespace plugc {

const VertexField* find_vertex_field(std::span<const VertexField> fields, NodeId node, std::string_view field) {
  for (auto at = std::ranges::lower_bound(fields, node, {}, &VertexField::node); at != fields.end() && at->node == node; ++at) {
    if (at->field == field) return &*at;
  }
  return nullptr;
}

}  // namespace plugc
