// Functions run one after the other, in the order in which events have come; what they have stored is sent when all have ended,
// each field's last value once.

#include "runtime/script_node.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace plugc {
namespace {

class WokenScript {
 public:
  WokenScript(const EventNodeInputs& inputs, ScriptMemory& memory)
      : inputs_(inputs), script_(*inputs.node.script()), memory_(memory) {}

  std::vector<SentEvent> run() {
    if (memory_.variables.empty()) {
      start_script(script_, memory_);
      answer(-1, {});
    }
    for (const std::uint32_t slot : inputs_.arrived) receive(slot);
    return sent();
  }

 private:
  /// A field that holds its value takes it before the function sees it.
  void receive(std::uint32_t slot) {
    const auto& fields = *inputs_.node.inputs();
    for (std::size_t field = 0; field < fields.size(); ++field) {
      if (inputs_.slot(field) != slot) continue;
      const std::span<const double> value = inputs_.values(field);
      for (flatbuffers::uoffset_t i = 0; i < script_.variables()->size(); ++i) {
        if (script_.variables()->Get(i)->field() == static_cast<std::int32_t>(field))
          memory_.variables[i].assign(value.begin(), value.end());
      }
      answer(static_cast<std::int32_t>(field), value);
    }
  }

  void answer(std::int32_t field, std::span<const double> value) {
    for (const PackedScriptFunction* function : *script_.functions()) {
      if (function->field() == field) run_script_function(script_, *function, value, inputs_.time, memory_, stored_);
    }
  }

  std::vector<SentEvent> sent() {
    std::vector<SentEvent> events;
    for (const std::uint32_t variable : stored_) {
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
  ScriptMemory& memory_;
  std::set<std::uint32_t> stored_;
};

}  // namespace

bool script_listens(const PackedEventNode& node, std::size_t field) {
  const auto is_field = [&](const auto* part) { return part->field() == static_cast<std::int32_t>(field); };
  return std::ranges::any_of(*node.script()->functions(), is_field) ||
         std::ranges::any_of(*node.script()->variables(), is_field);
}

std::vector<SentEvent> wake_script(const EventNodeInputs& inputs, ScriptMemory& memory) {
  return WokenScript(inputs, memory).run();
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
