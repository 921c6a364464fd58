// Functions of the language. A call leaves its arguments on the stack, and its step puts the result in their place; `if` and
// the loops are jumps.

#include <array>

#include "script/script_compiler.h"

namespace plugc {

ScriptType ScriptCompiler::call(const ScriptToken& name) {
  switch (script_function_kind(name.text)) {
    case ScriptFunctionKind::plain: return call_plain(name);
    case ScriptFunctionKind::folded: return call_folded(name);
    case ScriptFunctionKind::setter: return call_setter(name);
    case ScriptFunctionKind::joined: return call_joined(name);
    case ScriptFunctionKind::control: return call_control(name);
    case ScriptFunctionKind::not_made:
      fail(name, fmt::format("plugc does not evaluate `{}`; this function is left out", written(name)),
           DiagnosticId::script_ignored);
      return kNothing;
    case ScriptFunctionKind::unknown: break;
  }
  fail(name, fmt::format("there is no function `{}`{}", written(name), did_you_mean(name.text, script_function_names())));
  return kNothing;
}

std::vector<ScriptType> ScriptCompiler::arguments() {
  std::vector<ScriptType> types;
  expect("(");
  while (!failed_ && !next_is(")")) {
    if (!types.empty()) expect(",");
    types.push_back(sequence());
  }
  expect(")");
  return types;
}

ScriptType ScriptCompiler::call_plain(const ScriptToken& name) {
  return apply(name, arguments());
}

/// `max(a, b, c)` is the greater of the greater of a and b, and c.
ScriptType ScriptCompiler::call_folded(const ScriptToken& name) {
  expect("(");
  ScriptType type = sequence();
  if (!failed_ && !find_script_call(name.text, std::array{type, type}))
    fail(name, fmt::format("`{}` does not take {}", written(name), to_text(type)));
  while (take(",")) {
    const ScriptType other = sequence();
    type = apply(name, {type, other});
  }
  expect(")");
  return type;
}

/// `array_set(list, 2, x)`: the variable takes the list with x in it, which is the result, too.
ScriptType ScriptCompiler::call_setter(const ScriptToken& name) {
  expect("(");
  const ScriptToken target = take_name("the variable that is to change");
  const Variable* variable = expect_variable(target);
  if (failed_) return kNothing;
  std::vector<ScriptType> types = {load(target, *variable)};
  while (take(",")) types.push_back(sequence());
  expect(")");
  const ScriptType made = apply(name, types);
  return failed_ ? kNothing : store(target, *variable, made);
}

ScriptType ScriptCompiler::call_joined(const ScriptToken& name) {
  const std::vector<ScriptType> types = arguments();
  if (failed_) return kNothing;
  const auto type = joined_type(name.text, types);
  if (!type) {
    fail(name, fmt::format("`{}` makes nothing of {}", written(name), to_text(types)));
    return kNothing;
  }
  steps_.add(ScriptOp::join, static_cast<std::uint32_t>(types.size()), span(name));
  return *type;
}

ScriptType ScriptCompiler::call_control(const ScriptToken& name) {
  expect("(");
  const ScriptType type = name.text == "while" ? call_while(name) : name.text == "for" ? call_for(name) : call_if(name);
  expect(")");
  return type;
}

void ScriptCompiler::condition() {
  const ScriptToken first = next();
  const ScriptType type = sequence();
  if (!failed_ && type != kBoolean) fail(first, fmt::format("a condition is a boolean, not {}", to_text(type)));
}

ScriptType ScriptCompiler::nothing(const ScriptToken& name) {
  steps_.constant({}, span(name));
  return kNothing;
}

/// `if(condition, then, else)`, and `when(condition, then)`, which is `false` otherwise.
ScriptType ScriptCompiler::call_if(const ScriptToken& name) {
  condition();
  const std::uint32_t to_else = steps_.jump(ScriptOp::jump_if_not, span(name));
  expect(",");
  const ScriptType then = sequence();
  const std::uint32_t to_end = steps_.jump(ScriptOp::jump, span(name));
  steps_.land(to_else);
  ScriptType otherwise = kBoolean;
  if (name.text == "when") {
    steps_.constant({0.0}, span(name));
  } else {
    expect(",");
    otherwise = sequence();
  }
  steps_.land(to_end);
  if (fits(then, otherwise)) return otherwise;
  return fits(otherwise, then) ? then : kNothing;
}

ScriptType ScriptCompiler::call_while(const ScriptToken& name) {
  const std::uint32_t again = steps_.here();
  condition();
  const std::uint32_t to_end = steps_.jump(ScriptOp::jump_if_not, span(name));
  expect(",");
  sequence();
  steps_.add(ScriptOp::drop, 0, span(name));
  steps_.add(ScriptOp::jump, again, span(name));
  steps_.land(to_end);
  return nothing(name);
}

/// Into a variable of its own.
std::uint32_t ScriptCompiler::keep(const ScriptToken& name) {
  const std::uint32_t variable = steps_.add_variable({0.0});
  steps_.add(ScriptOp::store, variable, span(name));
  steps_.add(ScriptOp::drop, 0, span(name));
  return variable;
}

/// `for(counter, first, last, body)`: both ends are evaluated once, and the counter keeps the last number that was counted.
ScriptType ScriptCompiler::call_for(const ScriptToken& name) {
  const ScriptToken target = take_name("the counter");
  const Variable* counter = expect_variable(target);
  expect(",");
  const ScriptType first = sequence();
  const std::uint32_t count = keep(name);
  expect(",");
  const ScriptType last = sequence();
  const std::uint32_t end = keep(name);
  expect(",");
  if (!failed_ && (counter->type != kInteger || first != kInteger || last != kInteger))
    fail(target, "`for` counts integers: the counter, its first and its last value");
  if (failed_) return kNothing;
  const std::uint32_t again = steps_.here();
  steps_.add(ScriptOp::load, count, span(name));
  steps_.add(ScriptOp::load, end, span(name));
  steps_.add(ScriptOp::less_equal, 0, span(name));
  const std::uint32_t to_end = steps_.jump(ScriptOp::jump_if_not, span(name));
  steps_.add(ScriptOp::load, count, span(name));
  store(target, *counter, kInteger);
  steps_.constant({1.0}, span(name));
  steps_.add(ScriptOp::add, 0, span(name));
  steps_.add(ScriptOp::store, count, span(name));
  steps_.add(ScriptOp::drop, 0, span(name));
  sequence();
  steps_.add(ScriptOp::drop, 0, span(name));
  steps_.add(ScriptOp::jump, again, span(name));
  steps_.land(to_end);
  return nothing(name);
}

}  // namespace plugc
