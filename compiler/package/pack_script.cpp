#include "package/pack_script.h"

namespace plugc {

static_assert(static_cast<int>(ScriptOp::slerp) == static_cast<int>(PackedScriptOp::slerp), "the same list");

std::unique_ptr<PackedScriptT> pack_script(const ScriptProgram& program,
                                           const std::function<std::uint32_t(const Span&)>& line_of) {
  auto packed = std::make_unique<PackedScriptT>();
  for (const ScriptVariable& variable : program.variables) {
    packed->variables.emplace_back(static_cast<std::uint32_t>(packed->values.size()),
                                   static_cast<std::uint32_t>(variable.initial.size()), variable.field);
    packed->values.insert(packed->values.end(), variable.initial.begin(), variable.initial.end());
  }
  for (const ScriptFunction& function : program.functions)
    packed->functions.emplace_back(function.field, function.value.value_or(kNoSlot), function.time.value_or(kNoSlot),
                                   function.begin, function.end);
  for (const ScriptStep& step : program.steps)
    packed->steps.emplace_back(step.operand, line_of(step.span), static_cast<PackedScriptOp>(step.op));
  return packed;
}

}  // namespace plugc
