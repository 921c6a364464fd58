#pragma once
// The names that a field goes by: in VRML 2.0 some differ, and events may be named `set_x` and `x_changed`.

#include <string_view>

#include "document/document.h"
#include "scene/node_table.h"

namespace plugc {

/// What a ROUTE or an IS asks of a field.
enum class EventUse : std::uint8_t { any, receive, send };

bool holds_value(FieldAccess access);
bool holds_value(AccessType access);
AccessType as_access_type(FieldAccess access);
/// Whether IS may join a field of a body to a field of the prototype around it (X3D 4.1 part 1, 4.4.4.2).
bool may_join(AccessType inner, AccessType outer);
bool allows(FieldAccess access, EventUse use);
bool allows(AccessType access, EventUse use);

/// The field called `name` in a file of that encoding: `choice` of a VRML 2.0 Switch is `children`, `front` of a cube map of
/// X3D 3 is `frontTexture`. Null when there is none.
const FieldInfo* find_field_as_written(const NodeInfo& node, std::string_view name, Encoding encoding);

/// `set_x` to `x` for what receives, `x_changed` to `x` for what sends; "" when `name` has no such ending.
std::string_view without_event_affix(std::string_view name, EventUse use);

/// The result of `find` for `name`, or else for the field that `name` is an event of.
template <typename Find>
auto find_event(std::string_view name, EventUse use, Find find) -> decltype(find(name)) {
  if (auto found = find(name)) return found;
  for (const EventUse side : {EventUse::receive, EventUse::send}) {
    if (use != EventUse::any && use != side) continue;
    const std::string_view base = without_event_affix(name, side);
    if (base.empty()) continue;
    if (auto found = find(base)) return found;
  }
  return nullptr;
}

}  // namespace plugc
