#pragma once
// The field that a node without a field's name stands in: a child element of XML.

#include "scene/node_table.h"

namespace plugc {

/// Whether `field`, which may be null, holds nodes.
bool takes_nodes(const FieldInfo* field);

/// The field that the author names (`written`, may be empty), else the node's default one, else the first that takes the
/// node. Null when `holder` has none for it. Source: ISO/IEC 19776-1, 4.3 (containerField).
const FieldInfo* container_field_of(const NodeInfo& holder, const NodeInfo& node, std::string_view written);

}  // namespace plugc
