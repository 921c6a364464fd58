#pragma once
// Which events can happen at all, and which of them reach something that is drawn. The rest of a scene's event graph is not
// kept.

#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/dynamic_fields.h"
#include "scene/event_kinds.h"

namespace plugc {

using EventField = std::pair<NodeId, std::string_view>;

struct EventFlow {
  std::set<EventField> live;      ///< Fields at which an event can happen while nobody touches the scene.
  std::set<EventField> reaching;  ///< Fields from which routes and nodes lead to a drawn field.

  bool carries(const GraphRoute& route) const {
    return live.contains({route.from, route.from_field}) && reaching.contains({route.to, route.to_field});
  }
};

/// `drawn`: fields whose values are drawn. `dynamic`: fields that the host writes. `placed`: the sensors of the camera and the
/// viewpoints that have a place in the scene.
EventFlow find_event_flow(const NodeGraph& graph, std::span<const EventField> drawn, std::span<const DynamicField> dynamic,
                          const std::set<NodeId>& placed);

}  // namespace plugc
