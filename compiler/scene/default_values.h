#pragma once
// The defaults of the node table as typed values.

#include "scene/node_graph.h"

namespace plugc {

/// The default of a field of field_table(). All defaults are parsed on the first call.
const FieldValue& default_value(const FieldInfo& field);

}  // namespace plugc
