// A stack of values. What is counted is numbers that are moved, so that long lists cost what they cost: that bounds the time
// and the memory at once.

#include "runtime/script_machine.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace plugc {
namespace {

constexpr std::size_t kMaxWork = 5'000'000;  ///< For one function: a fraction of a second.
constexpr std::size_t kMaxStack = 100'000;   ///< More than the longest script has words, so only what loops gets there.

class ScriptMachine {
 public:
  ScriptMachine(const PackedScript& script, ScriptMemory& memory, std::set<std::uint32_t>& stored)
      : script_(script), memory_(memory), stored_(stored) {
    for (const ScriptValue& variable : memory.variables) held_ += variable.size();
  }

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
    if (stack_.size() == kMaxStack) return stop("it goes on without end");
    if (work(value.size())) stack_.push_back(std::move(value));
  }

  void store(std::uint32_t index) {
    ScriptValue& variable = memory_.variables[index];
    const std::size_t held = held_ - variable.size() + stack_.back().size();
    if (held > kMaxScriptNumbers) return stop(fmt::format("its variables would hold more than {} numbers", kMaxScriptNumbers));
    if (!work(stack_.back().size())) return;
    held_ = held;
    variable = stack_.back();
    stored_.insert(index);
  }

  void jump(std::uint32_t to) {
    if (work(0)) at_ = to;
  }

  bool work(std::size_t numbers) {
    work_ += numbers + 1;
    if (work_ > kMaxWork) stop("it goes on without end");
    return work_ <= kMaxWork;
  }

  void stop(std::string_view why) {
    const std::uint32_t line = script_.steps()->Get(at_ - 1)->line();
    memory_.stopped = true;
    memory_.message = fmt::format("line {}: the script is stopped: {}", line, why);
  }

  const PackedScript& script_;
  ScriptMemory& memory_;
  std::set<std::uint32_t>& stored_;
  std::vector<ScriptValue> stack_;
  std::uint32_t at_ = 0;
  std::size_t work_ = 0, held_ = 0;
};

}  // namespace

void start_script(const PackedScript& script, ScriptMemory& memory) {
  memory = {};
  for (const PackedScriptVariable* variable : *script.variables()) {
    const auto first = script.values()->begin() + variable->first();
    memory.variables.emplace_back(first, first + variable->count());
  }
}

void run_script_function(const PackedScript& script, const PackedScriptFunction& function, std::span<const double> value,
                         double time, ScriptMemory& memory, std::set<std::uint32_t>& stored) {
  if (memory.stopped) return;
  if (function.value() != kNoSlot) memory.variables[function.value()].assign(value.begin(), value.end());
  if (function.time() != kNoSlot) memory.variables[function.time()] = {time};
  ScriptMachine(script, memory, stored).run(function.begin(), function.end());
}

}  // namespace plugc
