#pragma once
// Which events can happen at all, and which of them reach something that is drawn. The rest of a scene's event graph is not
// kept.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/dynamic_fields.h"
#include "scene/scripts.h"

namespace plugc {

using EventField = std::pair<NodeId, std::string_view>;

/// What can be bound (X3D 4.1, 7.2.2): one node of each kind at a time.
enum class BindKind : std::uint8_t { viewpoint, background, fog, navigation_info };
inline constexpr std::size_t kBindKinds = 4;
/// None for a node that is not bound, or of a kind that plugc does not draw.
std::optional<BindKind> bind_kind(const NodeGraph& graph, NodeId node);

/// What such a node sends.
inline constexpr std::string_view kBindOutputs[] = {"isBound", "bindTime"};
bool says_what_is_bound(std::string_view field);

struct EventFlow {
  std::set<EventField> live;      ///< Fields at which an event can happen while nobody touches the scene.
  std::set<EventField> reaching;  ///< Fields from which routes and nodes lead to a drawn field.

  bool carries(const GraphRoute& route) const {
    return live.contains({route.from, route.from_field}) && reaching.contains({route.to, route.to_field});
  }
};

/// Fields at which an event can happen while nobody touches the scene, wherever sensors and viewpoints stand.
std::set<EventField> find_live_fields(const NodeGraph& graph, const Scripts& scripts, std::span<const DynamicField> dynamic);

/// `drawn`: fields whose values are drawn. `dynamic`: fields that the host writes. `placed`: the sensors of the camera and the
/// viewpoints that have a place in the scene.
EventFlow find_event_flow(const NodeGraph& graph, const Scripts& scripts, std::span<const EventField> drawn,
                          std::span<const DynamicField> dynamic, const std::set<NodeId>& placed);

}  // namespace plugc
