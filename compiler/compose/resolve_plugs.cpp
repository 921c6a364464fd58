// For every plug function, in call order: find the markers that it reaches, check that it fits, give it a name of its own
// and add its call there. A light's or texture's function looks at its own light or texture first, then at the shape
// (thesis 9.1.1); a marker in an effect serves what comes later, any other marker serves all.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compose/placed_unit.h"
#include "compose/plug_table.h"

namespace plugc {
namespace {

struct MarkerPlace {
  std::size_t unit = 0;
  std::size_t marker = 0;
};

class PlugResolver {
 public:
  explicit PlugResolver(Composition& composition) : c_(composition) {}
  void resolve();

 private:
  void resolve_unit(std::size_t unit);
  void resolve_function(std::size_t unit, std::size_t function);
  std::vector<MarkerPlace> reached_markers(std::size_t unit, std::string_view plug) const;
  std::vector<MarkerPlace> find_markers(std::size_t unit, std::string_view plug, bool own_scope) const;
  bool fits(std::size_t unit, const FunctionOutline& function, const MarkerPlace& place);
  void add_call(std::size_t unit, std::size_t function, const MarkerPlace& place);
  void report_unreached(const PlacedUnit& unit, const FunctionOutline& function, std::string_view plug);
  bool check_signature(const PlacedUnit& unit, const FunctionOutline& function, const PlugInfo& plug);
  std::string unique_name(ShaderStage stage, const std::string& name, std::size_t owner);
  void report(DiagnosticId id, const PlacedUnit& unit, const FunctionOutline& function, std::string message) const;
  void list_plugs() const;

  Composition& c_;
  std::set<std::string, std::less<>> filled_;
};

std::size_t argument_count(std::string_view arguments) {
  if (arguments.find_first_not_of(" \t\r\n") == std::string_view::npos) return 0;
  std::size_t count = 1;
  int depth = 0;
  for (const char c : arguments) {
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (c == ',' && depth == 0) ++count;
  }
  return count;
}

bool is_sampler(std::string_view type) { return type.find("sampler") != std::string_view::npos; }

/// Whether a function's parameter may stand where the plug has `plug` (thesis, appendix A: qualifiers may be weakened).
bool parameter_fits(const Parameter& parameter, const PlugParameter& plug, bool per_light_color) {
  const bool direction_fits = parameter.direction == Direction::in || plug.direction == "inout";
  const bool type_fits = parameter.type == plug.type || (plug.type == "samplerT" && is_sampler(parameter.type)) ||
                         (per_light_color && plug.type == "vec4" && parameter.type == "vec3");
  return direction_fits && type_fits && parameter.array.empty();
}

/// material_light_ambient and _specular: the thesis has vec4, the newer engine vec3; both are taken.
bool is_per_light_color(std::string_view plug) { return plug == "material_light_ambient" || plug == "material_light_specular"; }

void PlugResolver::report(DiagnosticId id, const PlacedUnit& unit, const FunctionOutline& function, std::string message) const {
  const auto end = function.name_begin + static_cast<std::uint32_t>(function.name.size());
  c_.diagnostics.report(id, unit.code->span(function.name_begin, end), std::move(message));
}

bool PlugResolver::check_signature(const PlacedUnit& unit, const FunctionOutline& function, const PlugInfo& plug) {
  const auto& given = function.parameters;
  std::vector<PlugParameter> wanted = plug.parameters;
  const bool sampler_left_out = plug.name == "texture_color" && given.size() + 1 == wanted.size();
  if (sampler_left_out) std::erase_if(wanted, [](const PlugParameter& parameter) { return parameter.type == "samplerT"; });
  bool fits = given.size() == wanted.size();
  for (std::size_t i = 0; fits && i < given.size(); ++i) fits = parameter_fits(given[i], wanted[i], is_per_light_color(plug.name));
  if (fits) return true;
  report(DiagnosticId::effect_wrong_signature, unit, function,
         fmt::format("`{}` does not fit its plug; declare `void PLUG_{}({})`", function.name, plug.name, plug.signature));
  return false;
}

std::vector<MarkerPlace> PlugResolver::find_markers(std::size_t index, std::string_view plug, bool own_scope) const {
  const PlacedUnit& unit = c_.units[index];
  std::vector<MarkerPlace> found;
  for (std::size_t u = 0; u < c_.units.size(); ++u) {
    const PlacedUnit& other = c_.units[u];
    const bool of_effect = c_.owners[other.owner].kind == OwnerKind::effect;
    if (u == index || other.dropped || other.stage != unit.stage || (of_effect && u > index)) continue;
    const bool limited = unit.scope.kind != ScopeKind::shape;
    if (limited && other.scope != (own_scope ? unit.scope : Scope())) continue;
    const auto& markers = other.code->outline.markers;
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (markers[m].kind == MarkerKind::plug && markers[m].name == plug) found.push_back({u, m});
    }
  }
  return found;
}

std::vector<MarkerPlace> PlugResolver::reached_markers(std::size_t unit, std::string_view plug) const {
  std::vector<MarkerPlace> found = find_markers(unit, plug, true);
  const bool limited = c_.units[unit].scope.kind != ScopeKind::shape;
  return found.empty() && limited ? find_markers(unit, plug, false) : found;
}

/// Whether the call that the marker would make suits the function: as many arguments, and for textures the right sampler.
bool PlugResolver::fits(std::size_t index, const FunctionOutline& function, const MarkerPlace& place) {
  const MarkerOutline& marker = c_.units[place.unit].code->outline.markers[place.marker];
  if (marker.name == "texture_color") {
    const auto& parameters = function.parameters;
    return parameters.size() == 3 && parameters[1].type == "sampler2D";
  }
  if (argument_count(marker.arguments) == function.parameters.size()) return true;
  const PlacedUnit& unit = c_.units[index];
  const auto end = function.name_begin + static_cast<std::uint32_t>(function.name.size());
  c_.diagnostics.report(DiagnosticId::effect_wrong_signature, unit.code->span(function.name_begin, end),
                        fmt::format("`{}` takes {} arguments, but its plug passes {}", function.name, function.parameters.size(),
                                    argument_count(marker.arguments)),
                        {{c_.units[place.unit].code->span(marker.begin, marker.end), "the plug stands here"}});
  return false;
}

std::string PlugResolver::unique_name(ShaderStage stage, const std::string& name, std::size_t owner) {
  auto& taken = c_.taken_in(stage);
  std::string candidate = name;
  for (int i = 2; taken.contains(candidate); ++i) candidate = fmt::format("{}_{}", name, i);
  taken.emplace(candidate, owner);
  return candidate;
}

/// Parameter types only: `void PLUG_light_scale_2(inout float, vec3, vec3);`
std::string prototype(const CodeUnit& code, const FunctionOutline& function, const std::string& name) {
  const std::string_view parameters =
      std::string_view(code.text.text()).substr(function.parameters_begin, function.parameters_end - function.parameters_begin);
  std::string one_line;
  for (const char c : parameters) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank) one_line += c;
    else if (!one_line.empty() && one_line.back() != ' ') one_line += ' ';
  }
  return fmt::format("void {}({});\n", name, one_line);
}

void PlugResolver::add_call(std::size_t index, std::size_t f, const MarkerPlace& place) {
  PlacedUnit& unit = c_.units[index];
  PlacedUnit& target = c_.units[place.unit];
  const FunctionOutline& function = unit.code->outline.functions[f];
  const MarkerOutline& marker = target.code->outline.markers[place.marker];
  const Span origin = unit.code->span(function.name_begin, function.name_begin + static_cast<std::uint32_t>(function.name.size()));
  const std::string& name = unit.function_names[f];
  const bool as_vec3 = is_per_light_color(marker.name) && function.parameters.front().type == "vec3";
  target.calls[place.marker].push_back({fmt::format("{}({}{});", name, marker.arguments, as_vec3 ? ".rgb" : ""), origin});
  std::string text = prototype(*unit.code, function, name);
  const auto known = std::any_of(target.forward.begin(), target.forward.end(),
                                 [&](const ForwardDeclaration& declared) { return declared.text == text; });
  if (!known) target.forward.push_back({std::move(text), origin});
}

/// No marker was reached: tell a name that nobody offers from one that this shape merely has not.
void PlugResolver::report_unreached(const PlacedUnit& unit, const FunctionOutline& function, std::string_view name) {
  const PlugInfo* plug = find_plug(name);
  if (plug == nullptr) {
    std::vector<std::string_view> known(plug_names().begin(), plug_names().end());
    for (const PlacedUnit& other : c_.units) {
      for (const MarkerOutline& marker : other.code->outline.markers) known.push_back(marker.name);
    }
    report(DiagnosticId::effect_unknown_plug, unit, function,
           fmt::format("no plug `{}` in a {} stage{}", name, to_text(unit.stage), did_you_mean(name, known)));
    return;
  }
  const bool wrong_stage = (plug->stage == PlugStage::vertex && unit.stage != ShaderStage::vertex) ||
                           (plug->stage == PlugStage::fragment && unit.stage != ShaderStage::fragment) ||
                           (plug->stage == PlugStage::geometry && unit.stage != ShaderStage::geometry);
  if (wrong_stage) {
    report(DiagnosticId::effect_wrong_stage, unit, function,
           fmt::format("plug `{}` is not called in a {} stage; put it into a part of type `{}`", name, to_text(unit.stage),
                       to_text(plug->stage)));
  } else {
    report(DiagnosticId::effect_plug_absent, unit, function,
           fmt::format("plug `{}` is not called for every shape that uses this effect (it is called {})", name, plug->when));
  }
}

void PlugResolver::resolve_function(std::size_t index, std::size_t f) {
  PlacedUnit& unit = c_.units[index];
  const FunctionOutline& function = unit.code->outline.functions[f];
  const std::string_view name = plug_name(function.name);
  if (name.empty() || !function.is_definition()) return;
  const bool by_author = c_.owners[unit.owner].kind != OwnerKind::renderer;
  unit.function_names[f] = unique_name(unit.stage, std::string(function.name), unit.owner);
  if (function.return_type != "void") {
    report(DiagnosticId::effect_plug_not_void, unit, function,
           fmt::format("`{}` returns `{}`; a plug function returns `void`", function.name, function.return_type));
    return c_.mark_faulty(unit);
  }
  const PlugInfo* plug = find_plug(name);
  if (by_author && plug != nullptr && !check_signature(unit, function, *plug)) return c_.mark_faulty(unit);
  if (by_author && plug != nullptr && !plug->replaced_by.empty()) {
    report(DiagnosticId::effect_deprecated_plug, unit, function,
           fmt::format("plug `{}` is an old name; use `{}` (or `fragment_modify` for the final colour)", name, plug->replaced_by));
  }
  const std::vector<MarkerPlace> markers = reached_markers(index, name);
  for (const MarkerPlace& place : markers) {
    if (fits(index, function, place)) add_call(index, f, place);
  }
  if (by_author && !markers.empty()) filled_.emplace(name);
  if (markers.empty() && by_author && !c_.recipe.depth_only) report_unreached(unit, function, name);
  if (markers.empty() && !by_author) unit.dropped = true;
}

/// A light or texture whose own code found no place in the base shader takes its effects and its shadow with it.
void PlugResolver::resolve_unit(std::size_t index) {
  PlacedUnit& unit = c_.units[index];
  if (unit.scope.kind == ScopeKind::light || unit.scope.kind == ScopeKind::texture) {
    for (std::size_t i = 0; i < index; ++i) {
      if (c_.units[i].dropped && c_.units[i].scope == unit.scope) unit.dropped = true;
    }
  }
  for (std::size_t f = 0; f < unit.code->outline.functions.size() && !unit.dropped; ++f) resolve_function(index, f);
}

void PlugResolver::list_plugs() const {
  std::set<std::string, std::less<>> empty;
  for (const PlacedUnit& unit : c_.units) {
    for (const MarkerOutline& marker : unit.code->outline.markers) {
      if (marker.kind == MarkerKind::plug && !unit.dropped && !filled_.contains(marker.name)) empty.emplace(marker.name);
    }
  }
  c_.result.plugs_filled.assign(filled_.begin(), filled_.end());
  c_.result.plugs_empty.assign(empty.begin(), empty.end());
}

void PlugResolver::resolve() {
  for (std::size_t unit = 0; unit < c_.units.size(); ++unit) resolve_unit(unit);
  list_plugs();
}

}  // namespace

void resolve_plugs(Composition& composition) { PlugResolver(composition).resolve(); }

}  // namespace plugc
