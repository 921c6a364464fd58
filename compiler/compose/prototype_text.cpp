// A parameter is written from what the outline knows of it, with the final name of its type.

#include "compose/prototype_text.h"

#include <fmt/format.h>

namespace plugc {
namespace {

/// `inout float, const in vec3`; with names `inout float argument_0, const in vec3 argument_1`.
std::string parameter_list(const Composition& composition, const PlacedUnit& unit, const FunctionOutline& function,
                           bool with_names) {
  constexpr std::string_view kDirections[] = {"in", "out", "inout"};
  std::string list;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    list +=
        fmt::format("{}{}{} {}{}{}", i == 0 ? "" : ", ", parameter.is_const ? "const " : "",
                    kDirections[static_cast<std::size_t>(parameter.direction)], composition.final_name(unit, parameter.type),
                    with_names ? fmt::format(" argument_{}", i) : "", parameter.array);
  }
  return list;
}

}  // namespace

std::string plug_prototype(const Composition& composition, const PlugCall& call) {
  const PlacedUnit& unit = composition.units[call.unit];
  const FunctionOutline& function = unit.code->outline.functions[call.function];
  return fmt::format("void {}({});\n", unit.function_names[call.function], parameter_list(composition, unit, function, false));
}

std::string forwarding_text(const Composition& composition, const PlacedUnit& unit, const FunctionOutline& prototype,
                            std::string_view target) {
  const std::string type = composition.final_name(unit, prototype.return_type);
  std::string arguments;
  for (std::size_t i = 0; i < prototype.parameters.size(); ++i)
    arguments += fmt::format("{}argument_{}", i == 0 ? "" : ", ", i);
  return fmt::format("\n{0} {1}({2});\n{0} {3}({4}) {{ {5}{1}({6}); }}", type, target,
                     parameter_list(composition, unit, prototype, false), composition.final_name(unit, prototype.name),
                     parameter_list(composition, unit, prototype, true), type == "void" ? "" : "return ", arguments);
}

}  // namespace plugc
