// Three tries, in the order of the standard: what the author names, what is usual for the node, what fits at all.

#include "scene/container_field.h"

#include "scene/event_names.h"

namespace plugc {

bool takes_nodes(const FieldInfo* field) {
  return field != nullptr && is_node(field->type) && holds_value(field->access);
}

const FieldInfo* container_field_of(const NodeInfo& holder, const NodeInfo& node, std::string_view written) {
  const FieldInfo* named = find_field_as_written(holder, written, Encoding::xml);
  if (takes_nodes(named)) return named;
  const FieldInfo* usual = find_field_info(holder, node.container_field);
  if (takes_nodes(usual) && accepts(*usual, node)) return usual;
  for (const FieldInfo& field : holder.fields) {
    if (takes_nodes(&field) && !field.accepts.empty() && accepts(field, node)) return &field;
  }
  return takes_nodes(usual) ? usual : nullptr;
}

}  // namespace plugc
