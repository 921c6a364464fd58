// A stack of values. What is counted is numbers that are moved, and jumps: that bounds the time and the memory at once.

#include "runtime/script_machine.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/script_limits.h"

namespace plugc {
namespace {

void stop_script(ScriptMemory& memory, std::uint32_t line, std::string_view why) {
  memory.stopped = true;
  if (memory.message.empty()) memory.message = fmt::format("line {}: the script is stopped: {}", line, why);
}

/// False when less than that is left, which stops the script.
bool spend(AwakeScript& awake, std::uint64_t work, std::uint32_t line) {
  if (work > awake.work_left)
    stop_script(awake.memory, line, "the scripts of the scene do more between two frames than may be done");
  else
    awake.work_left -= work;
  return !awake.memory.stopped;
}

class ScriptMachine {
 public:
  explicit ScriptMachine(AwakeScript& awake) : awake_(awake), script_(awake.script), memory_(awake.memory) {}

  void run(std::uint32_t begin, std::uint32_t end) {
    for (at_ = begin; at_ < end && !memory_.stopped;) {
      const PackedScriptStep& step = *script_.steps()->Get(at_++);
      if (stack_.size() < argument_count(step.op(), step.operand()))
        stop("its code is damaged: a value is missing");
      else
        take(step);
    }
  }

 private:
  void take(const PackedScriptStep& step) {
    switch (step.op()) {
      case PackedScriptOp::load: return push(memory_.variables[step.operand()]);
      case PackedScriptOp::store: return store(step.operand());
      case PackedScriptOp::drop: stack_.pop_back(); return;
      case PackedScriptOp::jump: return jump(step.operand());
      case PackedScriptOp::jump_if_not:
        if (pop() == ScriptValue{0.0}) jump(step.operand());
        return;
      default: break;
    }
    const std::size_t count = argument_count(step.op(), step.operand());
    const std::span<const ScriptValue> arguments(stack_.data() + (stack_.size() - count), count);
    ScriptResult result = apply_step(step.op(), step.operand(), arguments, memory_.random);
    if (!result.fault.empty()) return stop(result.fault);
    stack_.resize(stack_.size() - count);
    push(std::move(result.value));
  }

  ScriptValue pop() {
    ScriptValue value = std::move(stack_.back());
    stack_.pop_back();
    return value;
  }

  void push(ScriptValue value) {
    if (stack_.size() == kMaxScriptStack) return stop("it goes on without end");
    if (work(value.size())) stack_.push_back(std::move(value));
  }

  void store(std::uint32_t index) {
    ScriptValue& variable = memory_.variables[index];
    const std::size_t held = memory_.held - variable.size() + stack_.back().size();
    if (held > kMaxScriptNumbers) return stop(fmt::format("its variables would hold more than {} numbers", kMaxScriptNumbers));
    if (!work(stack_.back().size())) return;
    memory_.held = held;
    variable = stack_.back();
    awake_.stored.insert(index);
  }

  void jump(std::uint32_t to) {
    if (work(0)) at_ = to;
  }

  bool work(std::size_t numbers) {
    work_ += numbers + 1;
    if (work_ > kMaxScriptWork) stop("it goes on without end");
    return !memory_.stopped && spend(awake_, numbers + 1, line());
  }

  void stop(std::string_view why) { stop_script(memory_, line(), why); }
  std::uint32_t line() const { return script_.steps()->Get(at_ - 1)->line(); }

  AwakeScript& awake_;
  const PackedScript& script_;
  ScriptMemory& memory_;
  std::vector<ScriptValue> stack_;
  std::uint32_t at_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace

void start_script(const PackedScript& script, ScriptMemory& memory) {
  memory = {};
  memory.started = true;
  for (const PackedScriptVariable* variable : *script.variables()) {
    const auto first = script.values()->begin() + variable->first();
    memory.variables.emplace_back(first, first + variable->count());
    memory.held += variable->count();
  }
}

void give_script(AwakeScript& awake, std::uint32_t variable, std::span<const double> value) {
  if (awake.memory.stopped || !spend(awake, value.size() + 1, awake.script.origin()->line())) return;
  awake.memory.held += value.size() - awake.memory.variables[variable].size();
  awake.memory.variables[variable].assign(value.begin(), value.end());
}

void run_script_function(AwakeScript& awake, const PackedScriptFunction& function, std::span<const double> value, double time) {
  if (function.value() != kNoSlot) give_script(awake, function.value(), value);
  if (function.time() != kNoSlot) give_script(awake, function.time(), {&time, 1});
  if (!awake.memory.stopped) ScriptMachine(awake).run(function.begin(), function.end());
}

}  // namespace plugc
