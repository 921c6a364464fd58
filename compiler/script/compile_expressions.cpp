// A recursive descent over the grammar:
//
//   sequence    assignment { ";" assignment }
//   assignment  variable ":=" assignment  or  comparison
//   comparison  sum { ( "<" | ">" | "<=" | ">=" | "=" | "<>" ) sum }
//   sum         product { ( "+" | "-" ) product }
//   product     factor { ( "*" | "/" | "%" | "^" ) factor }       all four bind alike, from left to right
//   factor      variable, constant, "-" factor, "(" sequence ")", name [ "(" sequence { "," sequence } ")" ]

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>

#include "base/limits.h"
#include "script/script_compiler.h"

namespace plugc {
namespace {

struct NamedConstant {
  std::string_view name;
  ScriptKind kind;
  double value;
};

/// The keys as KeySensor numbers them (X3D 4.1, table 21.1).
constexpr std::array kConstants = {
    NamedConstant{"pi", ScriptKind::number, std::numbers::pi},
    NamedConstant{"enat", ScriptKind::number, std::numbers::e},
    NamedConstant{"false", ScriptKind::boolean, 0},
    NamedConstant{"true", ScriptKind::boolean, 1},
    NamedConstant{"action_key_f1", ScriptKind::integer, 1},
    NamedConstant{"action_key_f2", ScriptKind::integer, 2},
    NamedConstant{"action_key_f3", ScriptKind::integer, 3},
    NamedConstant{"action_key_f4", ScriptKind::integer, 4},
    NamedConstant{"action_key_f5", ScriptKind::integer, 5},
    NamedConstant{"action_key_f6", ScriptKind::integer, 6},
    NamedConstant{"action_key_f7", ScriptKind::integer, 7},
    NamedConstant{"action_key_f8", ScriptKind::integer, 8},
    NamedConstant{"action_key_f9", ScriptKind::integer, 9},
    NamedConstant{"action_key_f10", ScriptKind::integer, 10},
    NamedConstant{"action_key_f11", ScriptKind::integer, 11},
    NamedConstant{"action_key_f12", ScriptKind::integer, 12},
    NamedConstant{"action_key_home", ScriptKind::integer, 13},
    NamedConstant{"action_key_end", ScriptKind::integer, 14},
    NamedConstant{"action_key_pgup", ScriptKind::integer, 15},
    NamedConstant{"action_key_pgdn", ScriptKind::integer, 16},
    NamedConstant{"action_key_up", ScriptKind::integer, 17},
    NamedConstant{"action_key_down", ScriptKind::integer, 18},
    NamedConstant{"action_key_left", ScriptKind::integer, 19},
    NamedConstant{"action_key_right", ScriptKind::integer, 20},
};

}  // namespace

void ScriptCompiler::enter(const ScriptToken& at) {
  if (++depth_ > kMaxExpressionNesting)
    fail(at, fmt::format("expressions are nested more than {} deep", kMaxExpressionNesting));
}

ScriptType ScriptCompiler::sequence() {
  enter(next());
  ScriptType type = assignment();
  while (next_is(";")) {
    const ScriptToken divider = next();
    take(";");
    steps_.add(ScriptOp::drop, 0, span(divider));
    type = assignment();
  }
  --depth_;
  return failed_ ? kNothing : type;
}

ScriptType ScriptCompiler::assignment() {
  const bool assigns = !failed_ && next().kind == ScriptTokenKind::name && at_ + 1 < tokens_.size() &&
                       tokens_[at_ + 1].kind == ScriptTokenKind::symbol && tokens_[at_ + 1].text == ":=";
  if (!assigns) return binary(0);
  enter(next());
  const ScriptToken name = take_name("a variable");
  const Variable* variable = expect_variable(name);
  expect(":=");
  const ScriptType value = assignment();
  --depth_;
  return failed_ ? kNothing : store(name, *variable, value);
}

/// Operators by level, those that bind least first.
ScriptType ScriptCompiler::binary(std::size_t level) {
  static constexpr std::array<std::string_view, 3> kLevels = {" < > <= >= = <> ", " + - ", " * / % ^ "};
  if (level == kLevels.size()) return factor();
  ScriptType left = binary(level + 1);
  while (next().kind == ScriptTokenKind::symbol && kLevels[level].find(" " + next().text + " ") != std::string_view::npos) {
    const ScriptToken sign = next();
    ++at_;
    const ScriptType right = binary(level + 1);
    left = apply(sign, {left, right});
  }
  return left;
}

ScriptType ScriptCompiler::factor() {
  const ScriptToken token = next();
  switch (token.kind) {
    case ScriptTokenKind::name: ++at_; return named(token);
    case ScriptTokenKind::whole_number:
    case ScriptTokenKind::number:
    case ScriptTokenKind::text: ++at_; return constant(token);
    default: break;
  }
  if (take("(")) {
    const ScriptType type = sequence();
    expect(")");
    return type;
  }
  if (next_is("-")) {
    take("-");
    enter(token);
    const ScriptType type = factor();
    --depth_;
    return apply(token, {type});
  }
  fail(token, ends(token) ? std::string("an expression is missing here: the function ends")
                          : fmt::format("an expression is missing here: `{}` begins none", written(token)));
  return kNothing;
}

ScriptType ScriptCompiler::named(const ScriptToken& name) {
  if (next_is("(")) return call(name);
  if (const Variable* variable = find_variable(name.text)) return load(name, *variable);
  const auto constant = std::ranges::find(kConstants, name.text, &NamedConstant::name);
  if (constant != kConstants.end()) {
    steps_.constant({constant->value}, span(name));
    return {constant->kind, false};
  }
  if (script_function_kind(name.text) == ScriptFunctionKind::plain) return apply(name, {});
  fail_unknown(name);
  return kNothing;
}

ScriptType ScriptCompiler::constant(const ScriptToken& token) {
  if (token.kind == ScriptTokenKind::text) {
    std::vector<double> codes;
    for (const char c : token.text) codes.push_back(static_cast<unsigned char>(c));
    steps_.constant(codes, span(token));
    return kText;
  }
  steps_.constant({std::strtod(token.text.c_str(), nullptr)}, span(token));
  return token.kind == ScriptTokenKind::whole_number ? kInteger : kNumber;
}

ScriptType ScriptCompiler::load(const ScriptToken& name, const Variable& variable) {
  if (variable.type.kind == ScriptKind::other) {
    fail(name,
         fmt::format("`{}` holds {}, which plugc does not evaluate; this function is left out", written(name),
                     to_text(variable.type)),
         DiagnosticId::script_ignored);
    return kNothing;
  }
  steps_.add(ScriptOp::load, variable.index, span(name));
  return variable.type;
}

/// The value is on the stack, and stays there. What plugc does not evaluate goes nowhere.
ScriptType ScriptCompiler::store(const ScriptToken& name, const Variable& variable, ScriptType value) {
  if (variable.type.kind == ScriptKind::other) {
    diagnostics_.report(DiagnosticId::script_ignored, span(name),
                        fmt::format("`{}` takes {}, which plugc does not evaluate: it keeps what it has", written(name),
                                    to_text(variable.type)));
    return value;
  }
  if (!fits(value, variable.type)) {
    fail(name, fmt::format("`{}` takes {}, not {}", written(name), to_text(variable.type), to_text(value)));
    return kNothing;
  }
  if (variable.field >= 0) stored_.insert(variable.field);
  steps_.add(ScriptOp::store, variable.index, span(name));
  return variable.type;
}

/// The arguments are on the stack.
ScriptType ScriptCompiler::apply(const ScriptToken& name, const std::vector<ScriptType>& arguments) {
  if (failed_) return kNothing;
  const auto found = find_script_call(name.text, arguments);
  if (!found) {
    fail(name, fmt::format("`{}` does not take {}", written(name), to_text(arguments)));
    return kNothing;
  }
  if (found->op) steps_.add(*found->op, found->operand, span(name));
  return found->result;
}

}  // namespace plugc
