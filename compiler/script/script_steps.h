#pragma once
// Steps and variables of a program while it is made. A function that turns out to be wrong is taken back whole.

#include <map>
#include <utility>
#include <vector>

#include "script/script.h"

namespace plugc {

class ScriptSteps {
 public:
  explicit ScriptSteps(ScriptProgram& program) : program_(program) {}

  void add(ScriptOp op, std::uint32_t operand, const Span& span) { program_.steps.push_back({op, operand, span}); }
  /// A jump to a place that is not known yet; its step, for land().
  std::uint32_t jump(ScriptOp op, const Span& span) {
    add(op, 0, span);
    return here() - 1;
  }
  /// Leads the jump here.
  void land(std::uint32_t jump) { program_.steps[jump].operand = here(); }
  std::uint32_t here() const { return static_cast<std::uint32_t>(program_.steps.size()); }

  std::uint32_t add_variable(std::vector<double> initial, int field = -1) {
    program_.variables.push_back({std::move(initial), field});
    return static_cast<std::uint32_t>(program_.variables.size() - 1);
  }
  /// Puts a value on the stack. Equal ones share a variable.
  void constant(const std::vector<double>& value, const Span& span) {
    const auto next = static_cast<std::uint32_t>(program_.variables.size());
    const auto [found, added] = constants_.try_emplace(value, next);
    if (added) add_variable(value);
    add(ScriptOp::load, found->second, span);
  }

  /// Takes back all steps from that one on; what they used stays.
  void take_back(std::uint32_t first) { program_.steps.resize(first); }

 private:
  ScriptProgram& program_;
  std::map<std::vector<double>, std::uint32_t> constants_;
};

}  // namespace plugc
