// Functions run one after the other, in the order in which events have come; what they have stored is sent when all have ended,
// each field's last value once.

#include "runtime/script_node.h"

#include <fmt/format.h>

namespace plugc {
namespace {

class WokenScript {
 public:
  WokenScript(const EventNodeInputs& inputs, EventMemory& memory, std::uint64_t& work_left)
      : inputs_(inputs),
        script_(*inputs.node.script()),
        fields_(memory.script_fields),
        memory_(memory.script),
        awake_{script_, memory_, work_left} {}

  std::vector<SentEvent> run() {
    if (memory_.stopped) return {};
    if (!memory_.started) {
      start_script(script_, memory_);
      answer(ScriptFields::kNone, {});
    }
    for (const std::uint32_t slot : inputs_.arrived) receive(slot);
    return sent();
  }

 private:
  /// A field that holds its value takes it before the function sees it.
  void receive(std::uint32_t slot) {
    for (const std::uint32_t field : ScriptFields::beside(fields_.fields, slot)) {
      const std::span<const double> value = inputs_.slots.values(slot);
      for (const std::uint32_t variable : ScriptFields::beside(fields_.variables, field)) give_script(awake_, variable, value);
      answer(field, value);
    }
  }

  void answer(std::uint32_t field, std::span<const double> value) {
    for (const std::uint32_t function : ScriptFields::beside(fields_.functions, field))
      run_script_function(awake_, *script_.functions()->Get(function), value, inputs_.time);
  }

  std::vector<SentEvent> sent() {
    std::vector<SentEvent> events;
    for (const std::uint32_t variable : awake_.stored) {
      const std::int32_t field = script_.variables()->Get(variable)->field();
      if (field < 0) continue;
      check_length(field, memory_.variables[variable].size());
      events.push_back({static_cast<std::size_t>(field), memory_.variables[variable]});
    }
    return events;
  }

  /// Slots keep their lengths; what has another one reaches nobody.
  void check_length(std::int32_t field, std::size_t sent) {
    const std::uint32_t slot = inputs_.node.outputs()->Get(static_cast<flatbuffers::uoffset_t>(field));
    const std::size_t held = inputs_.slots.values(slot).size();
    if (slot == kNoSlot || sent == held || !memory_.message.empty()) return;
    memory_.message = fmt::format("line {}: the script sends a list of {} numbers to where {} are held, which is not followed",
                                  script_.origin()->line(), sent, held);
  }

  const EventNodeInputs& inputs_;
  const PackedScript& script_;
  const ScriptFields& fields_;
  ScriptMemory& memory_;
  AwakeScript awake_;
};

}  // namespace

std::vector<SentEvent> wake_script(const EventNodeInputs& inputs, EventMemory& memory, std::uint64_t& work_left) {
  return WokenScript(inputs, memory, work_left).run();
}

void report_scripts(const Package& package, const PackedScene& scene, const std::vector<EventMemory>& memory,
                    Messages& messages) {
  for (flatbuffers::uoffset_t i = 0; scene.event_nodes() != nullptr && i < scene.event_nodes()->size(); ++i) {
    const PackedScript* script = scene.event_nodes()->Get(i)->script();
    if (script == nullptr || memory[i].script.message.empty()) continue;
    messages.add(package.sources()->Get(script->origin()->source())->str() + ", " + memory[i].script.message);
  }
}

}  // namespace plugc
