#pragma once
// The events of a scene: what its sensors send at a time, and what comes of it (X3D 4.1, 4.4.8). Slots hold the values.

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "base/script_limits.h"
#include "runtime/event_node.h"

namespace plugc {

/// What has happened in a scene so far.
struct EventGraph {
  double time = -1;                   ///< Up to which everything has happened; less than 0: nothing has.
  bool ticking = false;               ///< Clocks run: some time has passed since the scene was loaded.
  std::vector<EventMemory> memory;    ///< By event node.
  std::vector<std::uint32_t> clocks;  ///< The event nodes that are time sensors, in order.
  /// Slots that wake a node, with the node, in order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> listeners;
  std::uint64_t script_work_left = kMaxFrameScriptWork;       ///< Until events are advanced again.
  std::map<std::uint32_t, std::vector<double>> from_outside;  ///< What a host has written to slots.
  std::vector<std::uint32_t> unheard;                         ///< Those of them whose events have not been sent yet.
};

/// Before anything happens.
EventGraph make_event_graph(const PackedScene& scene);

/// A host writes a slot; what hangs on it follows with the next advance_events(). False when the slot does not hold that
/// many values.
bool send_from_outside(EventGraph& graph, Slots& slots, std::uint32_t slot, const std::vector<double>& values);

/// Lets everything happen up to `time`, in seconds since the scene was loaded: at 0, what loading it sets off, but no clock has
/// ticked, as in the reference engine; later, all that clocks have sent from 0 on. Sensors start and stop at their own times,
/// so that what comes of it does not depend on the times that it is called for; all others send at `time`. To go back starts
/// anew.
void advance_events(EventGraph& graph, const PackedScene& scene, Slots& slots, double time);

/// Sends from a node the values of its outputs (empty: not that one) at the time that has been reached.
struct NodeEvents {
  std::uint32_t node = 0;
  std::vector<SentEvent> sent;
};
void send_events(EventGraph& graph, const PackedScene& scene, Slots& slots, const std::vector<NodeEvents>& events);

}  // namespace plugc
