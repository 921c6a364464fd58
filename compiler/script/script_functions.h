#pragma once
// What types there are, and what the operators and functions of CastleScript take and give.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "script/script.h"

namespace plugc {

/// In words, for messages: "a list of vectors of 3 numbers".
std::string to_text(ScriptType type);
std::string to_text(std::span<const ScriptType> types);  ///< "a number and a text"
/// Numbers of one value that is no list; 1 for a text's character.
std::uint32_t width(ScriptKind kind);
/// What a list, a text, a vector or a matrix is made of.
ScriptType element_type(ScriptType type);
/// Whether a value of that type may be stored where one of the other is expected: integers are numbers too.
bool fits(ScriptType value, ScriptType wanted);

/// How a call is carried out.
struct ScriptCall {
  ScriptType result;
  std::optional<ScriptOp> op;  ///< None: the argument is the result.
  std::uint32_t operand = 0;
};

/// The operator or function of that name (lower case) for arguments of these types; nullopt where there is none.
std::optional<ScriptCall> find_script_call(std::string_view name, std::span<const ScriptType> arguments);

/// What the name stands for in general.
enum class ScriptFunctionKind : std::uint8_t {
  unknown,
  plain,     ///< Any fixed number of arguments: find_script_call() knows them.
  folded,    ///< One argument or more, taken two by two: `max`.
  setter,    ///< The first argument is a variable, which takes the result: `array_set`.
  joined,    ///< Makes a list, a vector or a matrix of its arguments.
  control,   ///< `if` and the like, whose arguments are not all evaluated.
  not_made,  ///< Known, but plugc does not evaluate it.
};
ScriptFunctionKind script_function_kind(std::string_view name);
/// All of them, for proposals.
std::span<const std::string_view> script_function_names();

/// The type of what `array`, `vector` or `matrix` makes; nullopt where the arguments do not fit together.
std::optional<ScriptType> joined_type(std::string_view name, std::span<const ScriptType> arguments);

}  // namespace plugc
