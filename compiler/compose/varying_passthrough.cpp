// A marker belongs to the declaration that the very next token begins. Each of the three plugs gets one function a unit with a
// statement a varying; numbers that are no floats are scaled as floats and cut back.

#include "compose/varying_passthrough.h"

#include <algorithm>

#include <fmt/format.h>

namespace plugc {
namespace {

/// The float type of as many components: `ivec2` -> `vec2`; "" for a type that is float itself.
std::string float_type(std::string_view type) {
  if (type == "int" || type == "uint") return "float";
  const bool other = type.starts_with("ivec") || type.starts_with("uvec");
  return other ? std::string(type.substr(1)) : std::string();
}

/// GLSL 3.30, 4.3.4: what a stage may hand on, structs aside.
bool can_pass(const GlobalOutline& global) {
  if (global.storage != Storage::out || !global.array.empty()) return false;
  const std::string floats = float_type(global.type);
  const std::string_view type = floats.empty() ? global.type : std::string_view(floats);
  return type == "float" || (type.starts_with("vec") && type.size() == 4) || type.starts_with("mat");
}

std::string scaled(const PassedVarying& varying) {
  const std::string floats = float_type(varying.type);
  if (floats.empty()) return fmt::format("{}[index] * scale", varying.name);
  return fmt::format("{}({}({}[index]) * scale)", varying.type, floats, varying.name);
}

}  // namespace

std::string_view name_before_geometry(std::string_view name) {
  return name.ends_with(kBehindGeometry) ? name.substr(0, name.size() - kBehindGeometry.size()) : std::string_view();
}

std::vector<const GlobalOutline*> marked_varyings(const CodeUnit& code, const MarkerOutline& marker) {
  const auto next = std::ranges::lower_bound(code.tokens.tokens, marker.end, {}, &Token::begin);
  std::vector<const GlobalOutline*> varyings;
  if (next == code.tokens.tokens.end()) return varyings;
  for (const GlobalOutline& global : std::ranges::equal_range(code.outline.globals, next->begin, {}, &GlobalOutline::begin)) {
    if (can_pass(global)) varyings.push_back(&global);
  }
  return varyings;
}

void check_passthrough_markers(const CodeUnit& code, ShaderStage stage, Diagnostics& diagnostics) {
  for (const MarkerOutline& marker : code.outline.markers) {
    if (marker.kind != MarkerKind::varying_passthrough) continue;
    if (stage == ShaderStage::vertex && !marked_varyings(code, marker).empty()) continue;
    diagnostics.report(DiagnosticId::varying_passthrough, code.span(marker.begin, marker.end),
                       stage == ShaderStage::vertex
                           ? "this marker passes on the varying declared right behind it, no array and no struct; there is none"
                           : fmt::format("this marker counts in a vertex part, where the varying is written; in a {} part it "
                                         "does nothing",
                                         to_text(stage)));
  }
}

std::string passthrough_text(std::span<const PassedVarying> varyings, int input_size) {
  std::string declarations, set, zero, add;
  for (const PassedVarying& varying : varyings) {
    const std::string qualifiers = varying.qualifiers.empty() ? "" : varying.qualifiers + " ";
    const std::string behind = varying.name + std::string(kBehindGeometry);
    declarations += fmt::format("{}in {} {}[{}];\n", qualifiers, varying.type, varying.name, input_size);
    declarations += fmt::format("{}out {} {};\n", qualifiers, varying.type, behind);
    set += fmt::format("  {} = {}[index];\n", behind, varying.name);
    zero += fmt::format("  {} = {}({});\n", behind, varying.type, float_type(varying.type).empty() ? "0.0" : "0");
    add += fmt::format("  {} += {};\n", behind, scaled(varying));
  }
  return fmt::format(
      "{}void PLUG_geometry_vertex_set(const in int index)\n{{\n{}}}\nvoid PLUG_geometry_vertex_zero()\n{{\n{}}}\n"
      "void PLUG_geometry_vertex_add(const in int index, const in float scale)\n{{\n{}}}\n",
      declarations, set, zero, add);
}

}  // namespace plugc
