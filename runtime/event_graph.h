#pragma once
// The events of a scene: what its sensors send at a time, and what comes of it (X3D 4.1, 4.4.8).

#include <cstdint>
#include <vector>

#include "package/package_file.h"
#include "runtime/events.h"

namespace plugc {

/// What a node of the graph remembers from one event to the next.
struct EventMemory {
  bool active = false, paused = false;
  double start = 0;         ///< Of an active TimeSensor: the startTime that began it.
  double paused_since = 0;  ///< While it is paused.
  double paused_for = 0;    ///< Seconds of all its pauses that are over.
  double cycle = 0;         ///< The time that its cycle began at.
  std::int64_t step = -1;   ///< Of a sequencer: the key that it stands at.
};

struct EventGraph {
  double time = -1;  ///< Up to which everything has happened; less than 0: nothing has.
  std::vector<EventMemory> memory;
  std::vector<std::uint32_t> sent_from_outside;  ///< Slots that a host has written since.
};

}  // namespace plugc
