// Functions, and the names in them. Behind the first mistake in a function the next one begins.

#include <algorithm>
#include <iterator>

#include "script/script_compiler.h"

namespace plugc {

ScriptProgram ScriptCompiler::run() {
  program_.span = code_.locate(0, code_.size());
  add_fields();
  if (tokens_[at_].kind != ScriptTokenKind::function)
    fail(tokens_[at_], "a script is a list of functions: `function name(value, timestamp)` and what it does");
  while (at_ + 1 < tokens_.size()) {
    if (tokens_[at_++].kind == ScriptTokenKind::function) function();
  }
  return std::move(program_);
}

/// Of two names that differ in case alone, the first answers events, and the last is the variable.
void ScriptCompiler::add_fields() {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const ScriptField& field = fields_[i];
    const std::string name = lower_case(field.name);
    const auto place = static_cast<int>(i);
    if (field.receives) heard_.emplace(name, place);
    if (!field.is_variable) continue;
    variable_of_field_[name] = variables_.size();
    variables_.push_back({name, field.type, steps_.add_variable(field.value, place), place});
  }
  field_variables_ = variables_.size();
}

/// `function name(value, timestamp) sequence`; the first word is read.
void ScriptCompiler::function() {
  failed_ = false;
  depth_ = 0;
  stored_.clear();
  ScriptFunction made;
  made.begin = steps_.here();
  const ScriptToken name = take_name("the function's name");
  begin_function(name, made);
  sequence();
  if (!ends(next())) fail(next(), fmt::format("`{}` is not expected here: instructions are divided by `;`", written(next())));
  if (next().kind == ScriptTokenKind::lost) fail(next(), "");
  steps_.add(ScriptOp::drop, 0, span(name));
  made.end = steps_.here();
  made.sends.assign(stored_.begin(), stored_.end());
  const bool answers = name.text == "initialize" || made.field >= 0;
  if (failed_ || !answers)
    steps_.take_back(made.begin);
  else
    program_.functions.push_back(std::move(made));
  variables_.resize(field_variables_);
}

void ScriptCompiler::begin_function(const ScriptToken& name, ScriptFunction& made) {
  const std::vector<std::string> names = parameters();
  if (failed_) return;
  const bool is_moment = name.text == "initialize" || name.text == "shutdown";
  const auto field = heard_.find(name.text);
  if (!is_moment && field != heard_.end()) made.field = field->second;
  if (!is_moment && made.field < 0)
    return fail(
        name,
        fmt::format("the `Script` has no field `{}` that receives events, so this function is never called", written(name)),
        DiagnosticId::script_ignored);
  const bool again = std::ranges::any_of(program_.functions, [&](const ScriptFunction& other) {
    return other.field == made.field && (made.field >= 0 || name.text == "initialize");
  });
  if (again) return fail(name, fmt::format("there is a function `{}` already", written(name)));
  const std::size_t wanted = is_moment ? 1 : 2;
  if (names.size() != wanted)
    return fail(name, is_moment ? fmt::format("`{}` takes one parameter, the time", written(name))
                                : std::string("a function takes two parameters, the value that has come and the time"));
  add_parameters(name, names, made);
}

std::vector<std::string> ScriptCompiler::parameters() {
  std::vector<std::string> names;
  expect("(");
  while (!failed_ && !next_is(")")) {
    if (!names.empty()) expect(",");
    names.push_back(take_name("a parameter's name").text);
  }
  expect(")");
  return names;
}

void ScriptCompiler::add_parameters(const ScriptToken& name, const std::vector<std::string>& names, ScriptFunction& made) {
  if (names.size() == 2) {
    const ScriptType type = made.field < 0 ? kNothing : fields_[static_cast<std::size_t>(made.field)].type;
    made.value = steps_.add_variable({});
    variables_.push_back({names.front(), type, *made.value, -1});
  }
  if (names.size() == 2 && names.front() == names.back()) return fail(name, "both parameters have one name");
  made.time = steps_.add_variable({0.0});
  variables_.push_back({names.back(), kNumber, *made.time, -1});
}

bool ScriptCompiler::take(std::string_view symbol) {
  if (!next_is(symbol)) return false;
  ++at_;
  return true;
}

void ScriptCompiler::expect(std::string_view symbol) {
  if (take(symbol)) return;
  fail(next(), ends(next()) ? fmt::format("`{}` is missing: the function ends", symbol)
                            : fmt::format("`{}` is missing in front of `{}`", symbol, written(next())));
}

ScriptToken ScriptCompiler::take_name(std::string_view what) {
  const ScriptToken token = next();
  if (token.kind == ScriptTokenKind::name)
    ++at_;
  else
    fail(token, fmt::format("{} is missing here", what));
  return token;
}

std::string ScriptCompiler::written(const ScriptToken& token) const {
  return std::string(code_.text().substr(token.begin, token.end - token.begin));
}

const Variable* ScriptCompiler::find_variable(std::string_view lower) const {
  for (std::size_t i = variables_.size(); i > field_variables_; --i) {
    if (variables_[i - 1].name == lower) return &variables_[i - 1];
  }
  const auto field = variable_of_field_.find(std::string(lower));
  return field == variable_of_field_.end() ? nullptr : &variables_[field->second];
}

/// Null when there is none, which is reported.
const Variable* ScriptCompiler::expect_variable(const ScriptToken& name) {
  if (failed_) return nullptr;
  const Variable* variable = find_variable(name.text);
  if (variable == nullptr) fail_unknown(name);
  return variable;
}

void ScriptCompiler::fail_unknown(const ScriptToken& name) {
  std::vector<std::string_view> names;
  if (--proposals_left_ >= 0) std::ranges::transform(variables_, std::back_inserter(names), &Variable::name);
  fail(name,
       heard_.contains(name.text)
           ? fmt::format("`{}` is an event: its value is the first parameter of the function that answers it", written(name))
           : fmt::format("no field of the `Script`, and no parameter, is named `{}`{}", written(name),
                         did_you_mean(name.text, names)));
}

/// Only the first mistake of a function is told; what follows may come of it. Where something is missing at the end, the last
/// word is marked.
void ScriptCompiler::fail(const ScriptToken& at, std::string message, DiagnosticId id) {
  if (std::exchange(failed_, true) || at.kind == ScriptTokenKind::lost) return;
  diagnostics_.report(id, span(ends(at) && at_ != 0 ? tokens_[at_ - 1] : at), std::move(message));
}

ScriptProgram compile_script(const MappedText& code, std::span<const ScriptField> fields, Diagnostics& diagnostics) {
  return ScriptCompiler(code, fields, diagnostics).run();
}

}  // namespace plugc
