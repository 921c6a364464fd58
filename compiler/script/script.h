#pragma once
// The program of a Script node in CastleScript (castle-engine.io/castle_script.php): read, checked against the node's fields,
// and turned into steps of a machine with a stack. Knows nothing of nodes.
//
// Types are checked here, where the language checks them when it runs; so a function with a mistake in it is left out whole.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace plugc {

enum class ScriptKind : std::uint8_t {
  nothing,  ///< Of what has no value: a loop, or `if` with two kinds of result.
  boolean,
  integer,
  number,
  text,
  vec2,
  vec3,
  vec4,  ///< Rotations too.
  mat3,
  mat4,
  other  ///< Images, nodes and lists of texts: may be assigned to, which does nothing.
};

struct ScriptType {
  ScriptKind kind = ScriptKind::nothing;
  bool list = false;
  friend bool operator==(ScriptType, ScriptType) = default;
};

/// A field of the Script, as its code sees it.
struct ScriptField {
  std::string_view name;
  ScriptType type;
  bool receives = false;      ///< Events reach it: a function of its name answers them.
  bool is_variable = true;    ///< False for inputOnly fields.
  std::vector<double> value;  ///< At the start; a text as the codes of its characters.
};

/// As PackedScriptOp, which says what each does.
enum class ScriptOp : std::uint8_t {
  load,
  store,
  drop,
  jump,
  jump_if_not,
  join,
  count,
  element,
  replace,
  resize,
  add,
  subtract,
  negate,
  multiply,
  divide,
  modulo,
  power,
  least,
  greatest,
  lerp,
  equal,
  not_equal,
  less,
  less_equal,
  greater,
  greater_equal,
  not_,
  sin,
  cos,
  tan,
  cotan,
  arcsin,
  arccos,
  arctan,
  arccotan,
  sinh,
  cosh,
  tanh,
  cotanh,
  exp,
  exp2,
  ln,
  log2,
  log,
  square,
  sqrt,
  sign,
  abs,
  truncate,
  floor,
  ceil,
  round,
  not_zero,
  random,
  random_below,
  text_of_number,
  text_of_boolean,
  dot,
  cross,
  length,
  square_length,
  grayscale,
  rotate,
  direction,
  up,
  orientation,
  slerp
};

struct ScriptStep {
  ScriptOp op = ScriptOp::drop;
  std::uint32_t operand = 0;
  Span span;
};

/// A field, a constant (which nothing stores to), a parameter, or the end of a `for`.
struct ScriptVariable {
  std::vector<double> initial;
  int field = -1;
};

struct ScriptFunction {
  int field = -1;                      ///< Whose events it answers; -1 for `initialize`.
  std::optional<std::uint32_t> value;  ///< The variables that take what has come, and when.
  std::optional<std::uint32_t> time;
  std::uint32_t begin = 0, end = 0;  ///< Steps.
  std::vector<int> sends;            ///< Fields that it may store to, in order.
};

struct ScriptProgram {
  Span span;  ///< Of the code.
  std::vector<ScriptVariable> variables;
  std::vector<ScriptStep> steps;
  std::vector<ScriptFunction> functions;
};

/// The functions of a program that answer something. Mistakes are reported; what has one is left out.
ScriptProgram compile_script(const MappedText& code, std::span<const ScriptField> fields, Diagnostics& diagnostics);

}  // namespace plugc
