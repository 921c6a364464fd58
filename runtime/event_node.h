#pragma once
// What one node of the event graph makes of the events that reach it.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "package/package_file.h"
#include "runtime/events.h"
#include "runtime/script_fields.h"
#include "runtime/script_machine.h"
#include "runtime/time_sensor.h"

namespace plugc {

/// What a node remembers from one event to the next.
struct EventMemory {
  TimeSensorState clock;
  std::int64_t step = -1;            ///< Of a sequence: the key that it stands at; -1: none yet.
  bool inside = false;               ///< Of a proximity sensor.
  bool has_looked = false;           ///< Of a camera and a proximity sensor: it has sent where the viewer is.
  std::vector<std::uint32_t> stack;  ///< Of a bind stack: the nodes on it, the bound one last.
  bool has_begun = false;            ///< Of a bind stack: its first node has been bound.
  ScriptFields script_fields;        ///< Of a Script; they stay.
  ScriptMemory script;
};

/// An event that a node sends, by the place of its output.
struct SentEvent {
  std::size_t output = 0;
  std::vector<double> value;
};

/// A node with its slots, at one time.
struct EventNodeInputs {
  const PackedEventNode& node;
  const Slots& slots;
  std::span<const std::uint32_t> arrived;  ///< Slots that events have reached since the node was woken last, in order.
  double time = 0;

  std::uint32_t slot(std::size_t input) const { return node.inputs()->Get(static_cast<flatbuffers::uoffset_t>(input)); }
  bool has_arrived(std::size_t input) const { return std::ranges::find(arrived, slot(input)) != arrived.end(); }
  std::span<const double> values(std::size_t input) const { return slots.values(slot(input)); }
  double number(std::size_t input, double fallback) const { return slots.number(slot(input), fallback); }
  bool boolean(std::size_t input, bool fallback) const { return slots.boolean(slot(input), fallback); }
};

/// Whether an event at that input makes the node send; the others are what it then works with.
bool wakes(const PackedEventNode& node, const EventMemory& memory, std::uint32_t input);

/// What a node sends when time or an event wakes it; nothing for those that look at the camera. `script_work_left`: of
/// kMaxFrameScriptWork.
std::vector<SentEvent> wake(const EventNodeInputs& inputs, EventMemory& memory, std::uint64_t& script_work_left);

/// The fields of a time sensor.
TimeSensorFields time_sensor_fields(const EventNodeInputs& inputs);

}  // namespace plugc
