#pragma once
// Whether a plug function suits its plug: by the table for the plugs of templates, by the arguments that a marker passes for
// all others.

#include <string_view>
#include <vector>

#include <optional>

#include "compose/code_unit.h"
#include "compose/plug_table.h"

namespace plugc {

/// How a function's parameters suit the table's: qualifiers may be weakened (thesis, appendix A), and where the template
/// reads the variable afterwards an `inout` in place of a `const in` has a meaning too.
enum class PlugFit : unsigned char { no, strengthened, yes };
PlugFit fit_plug(const FunctionOutline& function, const PlugInfo& plug);
/// The first parameter that does not suit, or the `)` where one is missing.
std::optional<TextRange> find_misfit(const FunctionOutline& function, const PlugInfo& plug);

/// The first parameter that is changed though the plug passes it as const.
const Parameter* strengthened_parameter(const FunctionOutline& function, const PlugInfo& plug);

/// Whether a definition of this function moves the vertices of its shape.
bool moves_vertices(const FunctionOutline& function);

/// Whether a `texture_color` function takes a texture that this sampler reads; "" for one without a sampler.
bool takes_texture(const FunctionOutline& function, std::string_view sampler);

/// Whether the marker's call suits the function: as many arguments, and where a type matters (samplers always, others when
/// the plug has overloads) no argument that is known to have another one.
bool fits_marker(const FunctionOutline& function, const CodeUnit& code, const MarkerOutline& marker, bool has_overloads);

/// material_light_ambient and _specular: the thesis has vec4, the newer engine vec3; both are taken.
bool is_per_light_color(std::string_view plug);

}  // namespace plugc
