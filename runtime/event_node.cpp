// One function a kind. X3D 4.1: 8.4.1, 19.4, 30.4.

#include "runtime/event_node.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/interpolate.h"
#include "runtime/script_node.h"

namespace plugc {
namespace {

using Sent = std::vector<SentEvent>;

void add(Sent& sent, std::size_t output, const std::optional<double>& value) {
  if (value) sent.push_back({output, {*value}});
}

void add(Sent& sent, std::size_t output, const std::optional<bool>& value) {
  if (value) sent.push_back({output, {*value ? 1.0 : 0.0}});
}

Sent wake_time_sensor(const EventNodeInputs& inputs, EventMemory& memory) {
  const TimeSensorEvents events = tick(time_sensor_fields(inputs), memory.clock, inputs.time);
  Sent sent;
  add(sent, 0, events.is_active);
  add(sent, 1, events.is_paused);
  add(sent, 2, events.fraction);
  add(sent, 3, events.elapsed_time);
  add(sent, 4, events.time);
  add(sent, 5, events.cycle_time);
  return sent;
}

std::vector<double> interpolate(const EventNodeInputs& inputs, const KeyFrames& frames) {
  const double fraction = inputs.number(0, 0);
  switch (inputs.node.kind()) {
    case PackedEventKind::interpolate_color: return interpolate_color(fraction, frames);
    case PackedEventKind::interpolate_normal: return interpolate_normals(fraction, frames);
    case PackedEventKind::interpolate_rotation: return interpolate_rotation(fraction, frames);
    case PackedEventKind::squad: return interpolate_squad(fraction, frames);
    case PackedEventKind::spline:
      return interpolate_spline(fraction, frames, {inputs.values(3), inputs.boolean(4, false), inputs.boolean(5, false)});
    default: return interpolate_linear(fraction, frames);
  }
}

Sent wake_interpolator(const EventNodeInputs& inputs) {
  const std::size_t width = inputs.slots.values(inputs.node.outputs()->Get(0)).size();
  const KeyFrames frames{inputs.values(1), inputs.values(2), width};
  if (frames.count() == 0) return {};
  return {{0, interpolate(inputs, frames)}};
}

/// X3D 4.1, 30.2.4: a value once each time that another key is reached.
Sent wake_sequence(const EventNodeInputs& inputs, EventMemory& memory) {
  const std::span<const double> values = inputs.values(4);
  const auto count = static_cast<std::int64_t>(values.size());
  if (count == 0) return {};
  std::int64_t step = memory.step;
  if (inputs.has_arrived(0)) {
    const std::span<const double> keys = inputs.values(3);
    const std::size_t used = std::min(keys.size(), values.size());
    if (used != 0) step = static_cast<std::int64_t>(find_interval(inputs.number(0, 0), keys, used).index);
  }
  bool again = false;  // stepping sends the value though there may be but one
  if (inputs.has_arrived(1) && inputs.boolean(1, false)) {
    step = (step + 1) % count;
    again = true;
  }
  if (inputs.has_arrived(2) && inputs.boolean(2, false)) {
    step = step <= 0 ? count - 1 : step - 1;
    again = true;
  }
  if (step < 0 || (step == memory.step && !again)) return {};
  memory.step = step;
  return {{0, {values[static_cast<std::size_t>(step)]}}};
}

Sent wake_filter(bool value) {
  return {{value ? 0U : 1U, {value ? 1.0 : 0.0}}, {2, {value ? 0.0 : 1.0}}};
}

/// X3D 4.1, 7.2.2: what is bound by TRUE comes to the top of the stack, FALSE takes a node out of it. Events of one time come
/// in the order of the nodes; all at once, since each alone would move all that lie above.
void change_stack(const EventNodeInputs& inputs, std::vector<std::uint32_t>& stack) {
  std::vector<std::uint32_t> arrived(inputs.arrived.begin(), inputs.arrived.end());
  std::ranges::sort(arrived);
  const auto has_arrived = [&](std::uint32_t node) { return std::ranges::binary_search(arrived, inputs.slot(node)); };
  std::erase_if(stack, has_arrived);
  for (std::uint32_t node = 0; node < inputs.node.inputs()->size(); ++node) {
    if (has_arrived(node) && inputs.boolean(node, false)) stack.push_back(node);
  }
}

std::int64_t top_of(const std::vector<std::uint32_t>& stack) {
  return stack.empty() ? -1 : static_cast<std::int64_t>(stack.back());
}

/// Whenever another node is on top, both say so.
Sent wake_bind_stack(const EventNodeInputs& inputs, EventMemory& memory) {
  const std::int64_t before = top_of(memory.stack);
  if (!std::exchange(memory.has_begun, true) && inputs.node.subject() >= 0)
    memory.stack.push_back(static_cast<std::uint32_t>(inputs.node.subject()));
  const std::uint32_t count = inputs.node.inputs()->size();
  change_stack(inputs, memory.stack);
  const std::int64_t now = top_of(memory.stack);
  if (now == before) return {};
  Sent sent{{0, {static_cast<double>(now)}}};
  for (const auto& [node, is_bound] : {std::pair(before, 0.0), std::pair(now, 1.0)}) {
    if (node < 0) continue;
    const auto place = static_cast<std::size_t>(node);
    sent.push_back({1 + place, {is_bound}});
    sent.push_back({1 + count + place, {inputs.time}});
  }
  return sent;
}

/// The value for -1 stands before those of the nodes.
Sent wake_choose(const EventNodeInputs& inputs) {
  constexpr std::size_t kOtherwise = 1;
  const double index = inputs.number(0, -1);
  const double count = inputs.node.inputs()->size() - 2.0;
  const bool is_one = index >= 0 && index < count;
  const std::span<const double> values = inputs.values(is_one ? kOtherwise + 1 + static_cast<std::size_t>(index) : kOtherwise);
  const std::size_t size = inputs.slots.values(inputs.node.outputs()->Get(0)).size();
  return {{0, {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(size, values.size()))}}};
}

}  // namespace

bool wakes(const PackedEventNode& node, const EventMemory& memory, std::uint32_t input) {
  switch (node.kind()) {
    case PackedEventKind::script: return script_listens(memory.script_fields, input);
    case PackedEventKind::time_sensor:
    case PackedEventKind::bind_stack:
    case PackedEventKind::choose: return true;
    case PackedEventKind::proximity_sensor:
    case PackedEventKind::camera: return false;
    case PackedEventKind::sequence: return input < 3;
    default: return input == 0;
  }
}

std::vector<SentEvent> wake(const EventNodeInputs& inputs, EventMemory& memory, std::uint64_t& script_work_left) {
  if (inputs.node.kind() == PackedEventKind::script) return wake_script(inputs, memory, script_work_left);
  const bool value =
      inputs.node.kind() != PackedEventKind::time_sensor && inputs.node.inputs()->size() != 0 && inputs.boolean(0, false);
  switch (inputs.node.kind()) {
    case PackedEventKind::time_sensor: return wake_time_sensor(inputs, memory);
    case PackedEventKind::proximity_sensor:
    case PackedEventKind::camera: return {};
    case PackedEventKind::bind_stack: return wake_bind_stack(inputs, memory);
    case PackedEventKind::choose: return wake_choose(inputs);
    case PackedEventKind::ease: return {{0, {ease(inputs.number(0, 0), inputs.values(1), inputs.values(2))}}};
    case PackedEventKind::sequence: return wake_sequence(inputs, memory);
    case PackedEventKind::boolean_filter: return wake_filter(value);
    case PackedEventKind::boolean_toggle:
      if (!value) return {};
      return {{0, {inputs.boolean(1, false) ? 0.0 : 1.0}}};
    case PackedEventKind::boolean_trigger: return {{0, {1.0}}};
    case PackedEventKind::integer_trigger: return {{0, {inputs.number(1, -1)}}};
    case PackedEventKind::time_trigger: return {{0, {inputs.time}}};
    default: return wake_interpolator(inputs);
  }
}

TimeSensorFields time_sensor_fields(const EventNodeInputs& inputs) {
  TimeSensorFields fields;
  fields.enabled = inputs.boolean(0, true);
  fields.loop = inputs.boolean(1, false);
  fields.cycle_interval = inputs.number(2, 1);
  fields.start_time = inputs.number(3, 0);
  fields.stop_time = inputs.number(4, 0);
  fields.pause_time = inputs.number(5, 0);
  fields.resume_time = inputs.number(6, 0);
  fields.start_sent = inputs.has_arrived(3);
  return fields;
}

}  // namespace plugc
