// A parameter is written from what the outline knows of it, with the final name of its type.

#include "compose/prototype_text.h"

#include <fmt/format.h>

namespace plugc {
namespace {

std::string argument_name(std::size_t index) {
  return fmt::format("argument_{}", index);
}

/// `inout float, const in vec3`; with names `inout float argument_0, const in vec3 argument_1`.
void append_parameters(const Composition& composition, const PlacedUnit& unit, const FunctionOutline& function, bool with_names,
                       std::string& list) {
  constexpr std::string_view kDirections[] = {"in ", "out ", "inout "};
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    if (i > 0) list += ", ";
    if (parameter.is_const) list += "const ";
    list.append(kDirections[static_cast<std::size_t>(parameter.direction)]);
    list.append(composition.final_name(unit, parameter.type));
    if (with_names) list.append(1, ' ').append(argument_name(i));
    list.append(parameter.array);
  }
}

}  // namespace

std::string plug_prototype(const Composition& composition, const PlugCall& call) {
  const PlacedUnit& unit = composition.units[call.unit];
  const FunctionOutline& function = unit.code->outline.functions[call.function];
  std::string text = "void ";
  text.append(unit.function_names[call.function]).append(1, '(');
  append_parameters(composition, unit, function, false, text);
  return text += ");\n";
}

std::string forwarding_text(const Composition& composition, const PlacedUnit& unit, const FunctionOutline& prototype,
                            std::string_view target) {
  const std::string_view type = composition.final_name(unit, prototype.return_type);
  std::string types, parameters, arguments;
  append_parameters(composition, unit, prototype, false, types);
  append_parameters(composition, unit, prototype, true, parameters);
  for (std::size_t i = 0; i < prototype.parameters.size(); ++i) arguments += (i == 0 ? "" : ", ") + argument_name(i);
  return fmt::format("\n{0} {1}({2});\n{0} {3}({4}) {{ {5}{1}({6}); }}", type, target, types,
                     composition.final_name(unit, prototype.name), parameters, type == "void" ? "" : "return ", arguments);
}

}  // namespace plugc
