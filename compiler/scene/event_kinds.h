#pragma once
// The nodes whose events are evaluated while the scene is drawn: which fields they read and send, in the order that the
// package keeps their slots in.

#include <cstdint>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace plugc {

struct EventNodeInfo {
  std::string_view node;  ///< Its type.
  EventKind kind;
  std::span<const std::string_view> inputs, outputs;  ///< Fields, as PackedEventKind lists their slots.
};

/// Null for a node that makes no events, or only through somebody's hand or code.
const EventNodeInfo* find_event_node(std::string_view type);

/// The place of `name` among `fields`; -1 when it is none of them.
int find_field_index(std::span<const std::string_view> fields, std::string_view name);

}  // namespace plugc
