// The type of an argument is known when it is a plain name that the enclosing function or a global declares: the nearest
// declaration in front of the marker counts. No expression is typed; an unknown type fits everything, and glslang judges.

#include "compose/plug_signature.h"

#include <algorithm>

#include "compose/sampler_type.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

bool is_strengthened(const Parameter& parameter, const PlugParameter& plug) {
  return parameter.direction != Direction::in && plug.direction != "inout";
}

bool parameter_fits(const Parameter& parameter, const PlugParameter& plug, bool per_light_color) {
  const bool direction_fits = !is_strengthened(parameter, plug) || plug.keeps_changes;
  const bool type_fits = parameter.type == plug.type || (plug.type == "samplerT" && is_sampler(parameter.type)) ||
                         (per_light_color && plug.type == "vec4" && parameter.type == "vec3");
  return direction_fits && type_fits && parameter.array.empty();
}

bool is_name(std::string_view text) {
  return !text.empty() && is_identifier_start(text.front()) && std::all_of(text.begin(), text.end(), is_identifier_part);
}

/// The word in front of the last `type name` in [begin, end); "" when there is none.
std::string_view local_type(const CodeUnit& code, std::string_view name, std::uint32_t begin, std::uint32_t end) {
  const auto& tokens = code.tokens.tokens;
  const auto before = [](const Token& token, std::uint32_t at) { return token.begin < at; };
  auto token = std::lower_bound(tokens.begin(), tokens.end(), end, before);
  while (token != tokens.begin() && (--token)->begin > begin) {
    const bool named = token->kind == TokenKind::identifier && code.at(*token) == name && token != tokens.begin();
    const bool declared = named && (token - 1)->kind == TokenKind::identifier && code.at(*(token - 1)) != "return";
    if (declared) return code.at(*(token - 1));
  }
  return "";
}

std::string_view argument_type(const CodeUnit& code, const MarkerOutline& marker, std::string_view argument) {
  if (!is_name(argument)) return "";
  if (marker.enclosing_function < code.outline.functions.size()) {
    const FunctionOutline& function = code.outline.functions[marker.enclosing_function];
    const std::string_view local = local_type(code, argument, function.body_begin, marker.begin);
    if (!local.empty()) return local;
    for (const Parameter& parameter : function.parameters) {
      if (parameter.name == argument) return parameter.type;
    }
  }
  for (const GlobalOutline& global : code.outline.globals) {
    if (global.name == argument) return global.type;
  }
  return "";
}

}  // namespace

bool is_per_light_color(std::string_view plug) {
  return plug == "material_light_ambient" || plug == "material_light_specular";
}

const Parameter* strengthened_parameter(const FunctionOutline& function, const PlugInfo& plug) {
  for (std::size_t i = 0; i < std::min(function.parameters.size(), plug.parameters.size()); ++i) {
    if (is_strengthened(function.parameters[i], plug.parameters[i])) return &function.parameters[i];
  }
  return nullptr;
}

bool moves_vertices(const FunctionOutline& function) {
  const std::string_view name = plug_name(function.name);
  if (!function.is_definition() || function.parameters.empty()) return false;
  const bool changes = function.parameters.front().direction != Direction::in;
  return name == "vertex_object_space_change" ||
         (changes && (name == "vertex_object_space" || name == "vertex_eye_space" || name == "vertex_eye_space_extended"));
}

PlugFit fit_plug(const FunctionOutline& function, const PlugInfo& plug) {
  if (find_misfit(function, plug)) return PlugFit::no;
  return strengthened_parameter(function, plug) == nullptr ? PlugFit::yes : PlugFit::strengthened;
}

std::optional<TextRange> find_misfit(const FunctionOutline& function, const PlugInfo& plug) {
  std::vector<PlugParameter> wanted = plug.parameters;
  const std::vector<Parameter>& given = function.parameters;
  const bool sampler_left_out = plug.name == "texture_color" && given.size() + 1 == wanted.size();
  if (sampler_left_out) std::erase_if(wanted, [](const PlugParameter& parameter) { return parameter.type == "samplerT"; });
  const bool view_added = plug.name == "add_light" && given.size() == wanted.size() + 1 && given.back().type == "vec3";
  if (view_added) wanted.push_back({true, "in", "vec3", "view"});  // as physical materials pass it
  for (std::size_t i = 0; i < std::min(given.size(), wanted.size()); ++i) {
    if (!parameter_fits(given[i], wanted[i], is_per_light_color(plug.name))) return TextRange{given[i].begin, given[i].end};
  }
  if (given.size() > wanted.size()) return TextRange{given[wanted.size()].begin, given[wanted.size()].end};
  if (given.size() < wanted.size()) return TextRange{function.parameters_end, function.parameters_end + 1};
  return std::nullopt;
}

bool takes_texture(const FunctionOutline& function, std::string_view sampler) {
  const bool has_sampler = function.parameters.size() == 3;
  return sampler.empty() ? !has_sampler : has_sampler && function.parameters[1].type == sampler;
}

bool fits_marker(const FunctionOutline& function, const CodeUnit& code, const MarkerOutline& marker, bool has_overloads) {
  const std::vector<std::string_view>& arguments = marker.argument_list;
  if (arguments.size() != function.parameters.size()) return false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view wanted = function.parameters[i].type;
    const bool typed = is_sampler(wanted) || has_overloads;
    if (!typed || (is_per_light_color(marker.name) && wanted == "vec3")) continue;
    const std::string_view type = argument_type(code, marker, arguments[i]);
    if (!type.empty() && type != wanted) return false;
  }
  return true;
}

}  // namespace plugc
