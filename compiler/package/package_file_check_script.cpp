// The code of Scripts: ranges, and numbers of variables and fields. Whether steps fit together is left to whoever runs them,
// where it shows at once.

#include "package/package_file_check.h"

namespace plugc {
namespace {

/// A Script's lists, at hand for all that points into them.
struct ScriptCheck {
  PackageCheck& check;
  const PackedScript& script;
  std::size_t field_count;
  std::uint64_t numbers = 0;  ///< Of the variables so far.

  bool field(const Place& place, std::int32_t index) {
    return is_index_or_none(index, field_count) || check.fail(place, fmt::format("field {} does not exist", index));
  }
  bool variable(const Place& place, std::uint32_t index) {
    return check.require_index(place, "variable", index, script.variables()->size());
  }
  bool parameter(const Place& place, std::uint32_t index) { return index == kNoSlot || variable(place, index); }
};

bool check_variable(ScriptCheck& script, const PackedScriptVariable& variable, const Place& place) {
  const std::uint64_t end = std::uint64_t{variable.first()} + variable.count();
  script.numbers += variable.count();
  if (end > script.script.values()->size() || script.numbers > script.script.values()->size())
    return script.check.fail(place, "its value does not lie in the list, each in a place of its own");
  return script.field(place, variable.field());
}

bool check_function(ScriptCheck& script, const PackedScriptFunction& function, const Place& place) {
  if (function.begin() > function.end() || function.end() > script.script.steps()->size())
    return script.check.fail(place, "its steps do not exist");
  return script.field(place, function.field()) && script.parameter(place, function.value()) &&
         script.parameter(place, function.time());
}

bool check_step(ScriptCheck& script, const PackedScriptStep& step, const Place& place) {
  if (!is_enumerator(step.op())) return script.check.fail(place, "its kind is unknown");
  const bool names_variable = step.op() == PackedScriptOp::load || step.op() == PackedScriptOp::store;
  return !names_variable || script.variable(place, step.operand());
}

}  // namespace

bool check_script(PackageCheck& check, const PackedEventNode& node, const Place& place) {
  const PackedScript& packed = *node.script();
  ScriptCheck script{check, packed, node.inputs()->size()};
  if (!check.charge(place, *packed.values())) return false;
  if (!is_aligned(packed.values()->data(), alignof(double))) return check.fail(place, "its values are not aligned");
  return check_origin(check, *packed.origin(), place) &&
         check.each(&place, "variable", *packed.variables(),
                    [&](const PackedScriptVariable* one, const Place& at) { return check_variable(script, *one, at); }) &&
         check.each(&place, "function", *packed.functions(),
                    [&](const PackedScriptFunction* one, const Place& at) { return check_function(script, *one, at); }) &&
         check.each(&place, "step", *packed.steps(),
                    [&](const PackedScriptStep* one, const Place& at) { return check_step(script, *one, at); });
}

}  // namespace plugc
