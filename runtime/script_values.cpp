// Which step is which operation. Arithmetic goes number by number; the rest takes values whole.

#include "runtime/script_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "runtime/script_operations.h"

namespace plugc {

using Op = PackedScriptOp;

std::size_t argument_count(Op op, std::uint32_t operand) {
  switch (op) {
    case Op::load:
    case Op::jump:
    case Op::random: return 0;
    case Op::join: return operand;
    case Op::replace:
    case Op::lerp: return 3;
    case Op::element:
    case Op::resize:
    case Op::multiply:
    case Op::divide:
    case Op::equal:
    case Op::not_equal:
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal:
    case Op::dot: return 2;
    default: break;
  }
  if (const std::size_t vectors = vector_sizes(op).size(); vectors != 0) return vectors;
  return binary_function(op) != nullptr ? 2 : 1;
}

ScriptResult apply_step(Op op, std::uint32_t operand, ScriptArguments arguments, std::uint64_t& random) {
  const std::size_t width = std::max<std::size_t>(operand, 1);
  switch (op) {
    case Op::join: return join(arguments);
    case Op::count: return script_number(static_cast<double>(arguments[0].size() / width));
    case Op::element: return element(arguments[0], arguments[1], width);
    case Op::replace: return replace(arguments[0], arguments[1], arguments[2], width);
    case Op::resize: return resize(arguments[0], arguments[1], width);
    case Op::multiply: return multiply(arguments[0], arguments[1]);
    case Op::divide: return divide(arguments[0], arguments[1]);
    case Op::lerp: return lerp(arguments);
    case Op::equal:
    case Op::not_equal:
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal: return compare(op, arguments);
    case Op::random: return script_number(next_random(random));
    case Op::random_below: return random_below(arguments[0], random);
    case Op::text_of_number: return script_text(fmt::format("{:.15g}", arguments[0].empty() ? 0.0 : arguments[0][0]));
    case Op::text_of_boolean: return script_text(arguments[0] == ScriptValue{0.0} ? "false" : "true");
    case Op::length: return script_number(std::sqrt(dot(arguments[0], arguments[0])));
    case Op::square_length: return script_number(dot(arguments[0], arguments[0]));
    default: break;
  }
  if (const UnaryFunction function = unary_function(op)) return by_numbers(function, arguments[0]);
  if (!vector_sizes(op).empty()) return apply_to_vectors(op, arguments);
  if (arguments.size() != 2 || arguments[0].size() != arguments[1].size()) return script_misfit();
  if (op == Op::dot) return script_number(dot(arguments[0], arguments[1]));
  if (operand == 1 && (op == Op::modulo || op == Op::power) && arguments[0].size() == 1)
    return apply_to_whole_numbers(op, arguments[0][0], arguments[1][0]);
  const BinaryFunction function = binary_function(op);
  return function == nullptr ? script_misfit() : by_numbers(function, arguments);
}

}  // namespace plugc
