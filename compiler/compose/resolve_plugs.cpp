// For every plug function, in call order: find the markers that it reaches, check that it fits, give it a name of its own
// and note its call there. A light's or texture's function looks at its own light or texture first, then at the shape
// (thesis 9.1.1); a marker in an effect serves what comes later, any other marker serves all. Markers are looked up by stage
// and name, so that a thousand effects cost a thousand times one.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/limits.h"
#include "compose/placed_unit.h"
#include "compose/plug_signature.h"
#include "compose/plug_table.h"
#include "compose/sampler_type.h"

namespace plugc {
namespace {

struct MarkerPlace {
  std::size_t unit = 0;
  std::size_t marker = 0;
};

/// At a marker a function is called, or its overload is, or the texture or material is of another kind, or its author erred.
enum class CallResult { called, for_overload, other_kind, misfit };

class PlugResolver {
 public:
  explicit PlugResolver(Composition& composition) : c_(composition) {}
  void resolve();

 private:
  void index_markers();
  void resolve_unit(std::size_t unit);
  void resolve_function(std::size_t unit, std::size_t function);
  bool is_sound(const PlacedUnit& unit, const FunctionOutline& function, const std::vector<MarkerPlace>& markers);
  std::vector<MarkerPlace> reached_markers(std::size_t unit, std::size_t function) const;
  std::vector<MarkerPlace> find_markers(std::size_t unit, std::size_t function, bool own_scope) const;
  CallResult call_at(std::size_t unit, std::size_t function, const MarkerPlace& place);
  CallResult add_call(std::size_t unit, std::size_t function, const MarkerPlace& place);
  void note_only_provider(const PlacedUnit& unit, const std::vector<MarkerPlace>& markers);
  void report_unreached(const PlacedUnit& unit, const FunctionOutline& function);
  bool report_sampler_kind(const PlacedUnit& unit, const FunctionOutline& function);
  void report_absent_or_wrong_stage(const PlacedUnit& unit, const FunctionOutline& function, const PlugInfo& plug);
  const MarkerPlace* find_offer(std::string_view name, ShaderStage stage, bool in_stage) const;
  void report_unknown(const PlacedUnit& unit, const FunctionOutline& function);
  void report_strengthened(const PlacedUnit& unit, const FunctionOutline& function, const PlugInfo& plug);
  void report_misfit(const PlacedUnit& unit, const FunctionOutline& function, const MarkerPlace& place);
  void give_name(PlacedUnit& unit, std::size_t function);
  void report(DiagnosticId id, const PlacedUnit& unit, const FunctionOutline& function, std::string message,
              std::vector<RelatedPlace> related = {}) const;
  void list_plugs() const;
  void note_missing_shadows() const;
  const MarkerOutline& marker_at(const MarkerPlace& place) const {
    return c_.units[place.unit].code->outline.markers[place.marker];
  }
  Span marker_span(const MarkerPlace& place) const {
    return c_.units[place.unit].code->span(marker_at(place).begin, marker_at(place).end);
  }

  Composition& c_;
  std::map<std::pair<ShaderStage, std::string_view>, std::vector<MarkerPlace>> markers_;
  std::set<std::string, std::less<>> filled_;
  std::set<PlugScope> dropped_scopes_, dropped_shadows_;
  std::map<std::string_view, std::size_t> definitions_;  // of the unit at hand: how many functions have the name
  std::size_t call_bytes_ = 0;
};

/// All that guards the called code, save what guards its caller anyway.
std::vector<std::size_t> guards_of_call(const PlacedUnit& called, const PlacedUnit& caller) {
  std::vector<std::size_t> guards = called.guards;
  std::erase_if(guards, [&](std::size_t guard) { return std::ranges::find(caller.guards, guard) != caller.guards.end(); });
  return guards;
}

bool is_in_function(const MarkerOutline& marker) {
  return marker.enclosing_function != UINT32_MAX;
}

void PlugResolver::index_markers() {
  for (std::size_t u = 0; u < c_.units.size(); ++u) {
    const auto& markers = c_.units[u].code->outline.markers;
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (markers[m].kind == MarkerKind::plug && is_in_function(markers[m]))
        markers_[{c_.units[u].stage, markers[m].name}].push_back({u, m});
    }
  }
}

void PlugResolver::report(DiagnosticId id, const PlacedUnit& unit, const FunctionOutline& function, std::string message,
                          std::vector<RelatedPlace> related) const {
  c_.diagnostics.report(id, name_span(*unit.code, function.name, function.name_begin), std::move(message), std::move(related));
}

std::vector<MarkerPlace> PlugResolver::find_markers(std::size_t index, std::size_t f, bool own_scope) const {
  const PlacedUnit& unit = c_.units[index];
  const auto indexed = markers_.find({unit.stage, plug_name(unit.code->outline.functions[f].name)});
  std::vector<MarkerPlace> found;
  if (indexed == markers_.end()) return found;
  const bool limited = unit.scope.kind != ScopeKind::shape;
  for (const MarkerPlace& place : indexed->second) {
    const PlacedUnit& other = c_.units[place.unit];
    const bool of_effect = c_.owners[other.owner].kind == OwnerKind::effect;
    const bool in_itself = place.unit == index && marker_at(place).enclosing_function == f;
    if (in_itself || other.dropped || (of_effect && place.unit >= index)) continue;
    if (!limited && other.offers_to_scope_alone) continue;
    if (limited && other.scope != (own_scope ? unit.scope : PlugScope())) continue;
    found.push_back(place);
  }
  return found;
}

std::vector<MarkerPlace> PlugResolver::reached_markers(std::size_t unit, std::size_t function) const {
  std::vector<MarkerPlace> found = find_markers(unit, function, true);
  const bool limited = c_.units[unit].scope.kind != ScopeKind::shape;
  return found.empty() && limited ? find_markers(unit, function, false) : found;
}

/// Notes the call, unless the program's calls have grown beyond what a stage may hold.
CallResult PlugResolver::add_call(std::size_t index, std::size_t f, const MarkerPlace& place) {
  const PlacedUnit& unit = c_.units[index];
  const FunctionOutline& function = unit.code->outline.functions[f];
  const MarkerOutline& marker = marker_at(place);
  call_bytes_ += unit.function_names[f].size() + marker.arguments.size() + 8;
  if (call_bytes_ > kMaxStageBytes) {
    report(DiagnosticId::shader_limit, unit, function,
           fmt::format("the calls of all plugs of this shape are longer than {} bytes", kMaxStageBytes));
    c_.mark_faulty(unit);
    return CallResult::misfit;
  }
  const bool rgb_only =
      is_per_light_color(marker.name) && !function.parameters.empty() && function.parameters.front().type == "vec3";
  c_.units[place.unit].calls[place.marker].push_back({index, f, rgb_only, guards_of_call(unit, c_.units[place.unit])});
  return CallResult::called;
}

void PlugResolver::report_misfit(const PlacedUnit& unit, const FunctionOutline& function, const MarkerPlace& place) {
  const std::size_t passed = split_arguments(marker_at(place).arguments).size();
  if (!c_.by_author(unit)) {
    c_.diagnostics.report(DiagnosticId::effect_wrong_signature, marker_span(place),
                          fmt::format("this plug passes {} arguments, but the renderer's `{}` takes {}", passed, function.name,
                                      function.parameters.size()));
    return;
  }
  const std::string message =
      passed == function.parameters.size()
          ? fmt::format("no parameter list of `{}` has the types that its plug passes", function.name)
          : fmt::format("`{}` takes {} arguments, but its plug passes {}", function.name, function.parameters.size(), passed);
  report(DiagnosticId::effect_wrong_signature, unit, function, message, {{marker_span(place), "the plug stands here"}});
  c_.mark_faulty(unit);
}

CallResult PlugResolver::call_at(std::size_t index, std::size_t f, const MarkerPlace& place) {
  const PlacedUnit& unit = c_.units[index];
  const CodeUnit& code = *unit.code;
  const FunctionOutline& function = code.outline.functions[f];
  const CodeUnit& target = *c_.units[place.unit].code;
  const MarkerOutline& marker = marker_at(place);
  const bool overloaded = definitions_[function.name] > 1;
  if (fits_marker(function, target, marker, overloaded)) return add_call(index, f, place);
  const bool for_another =
      std::any_of(code.outline.functions.begin(), code.outline.functions.end(), [&](const FunctionOutline& other) {
        return other.name == function.name && other.is_definition() && fits_marker(other, target, marker, overloaded);
      });
  if (for_another) return CallResult::for_overload;
  if (marker.name == "texture_color" || marker.name == "add_light") return CallResult::other_kind;
  report_misfit(unit, function, place);
  return CallResult::misfit;
}

/// A marker of the name, in the stage or out of it; null when there is none.
const MarkerPlace* PlugResolver::find_offer(std::string_view name, ShaderStage stage, bool in_stage) const {
  for (const auto& [key, places] : markers_) {
    if (key.second == name && (key.first == stage) == in_stage) return &places.front();
  }
  return nullptr;
}

void PlugResolver::report_unknown(const PlacedUnit& unit, const FunctionOutline& function) {
  const std::string_view name = plug_name(function.name);
  if (const MarkerPlace* later = find_offer(name, unit.stage, true)) {
    return report(
        DiagnosticId::effect_unknown_plug, unit, function,
        fmt::format("plug `{}` is offered only behind this function; a plug of an effect serves what comes later", name),
        {{marker_span(*later), "the plug stands here"}});
  }
  if (const MarkerPlace* elsewhere = find_offer(name, unit.stage, false)) {
    return report(DiagnosticId::effect_wrong_stage, unit, function,
                  fmt::format("plug `{}` is called in the {} stage, not in the {} stage", name,
                              to_text(c_.units[elsewhere->unit].stage), to_text(unit.stage)),
                  {{marker_span(*elsewhere), "the plug stands here"}});
  }
  std::vector<std::string_view> known(plug_names().begin(), plug_names().end());
  for (const auto& [key, places] : markers_) known.push_back(key.second);
  report(DiagnosticId::effect_unknown_plug, unit, function,
         fmt::format("no plug `{}` in a {} stage{}", name, to_text(unit.stage), did_you_mean(name, known)),
         doubtful_places(c_.input, unit.stage, name));
}

void PlugResolver::report_absent_or_wrong_stage(const PlacedUnit& unit, const FunctionOutline& function, const PlugInfo& plug) {
  const bool wrong_stage = (plug.stage == PlugStage::vertex && unit.stage != ShaderStage::vertex) ||
                           (plug.stage == PlugStage::fragment && unit.stage != ShaderStage::fragment) ||
                           (plug.stage == PlugStage::geometry && unit.stage != ShaderStage::geometry);
  if (wrong_stage) {
    report(DiagnosticId::effect_wrong_stage, unit, function,
           fmt::format("plug `{}` is not called in a {} stage; put it into a part of type `{}`", plug.name, to_text(unit.stage),
                       to_text(plug.stage)));
  } else {
    report(
        DiagnosticId::effect_plug_absent, unit, function,
        fmt::format("plug `{}` is not called for every shape that uses this effect (it is called {})", plug.name, plug.when));
  }
}

/// What an effect of the texture itself would have to declare; false where that is not what is wrong. An effect that serves
/// textures of several kinds has a function for each.
bool PlugResolver::report_sampler_kind(const PlacedUnit& unit, const FunctionOutline& function) {
  const bool samples = unit.stage == ShaderStage::fragment && plug_name(function.name) == "texture_color";
  if (!samples || unit.scope.kind != ScopeKind::texture) return false;
  const TextureKind kind = c_.recipe.textures[static_cast<std::size_t>(unit.scope.number)].kind;
  const auto fits = [&](const PlacedUnit& other) {
    return other.owner == unit.owner && other.stage == unit.stage &&
           std::ranges::any_of(other.code->outline.functions, [&](const FunctionOutline& each) {
             return each.name == function.name && each.is_definition() && takes_texture(each, sampler_type(kind));
           });
  };
  if (std::ranges::any_of(c_.units, fits)) return true;
  report(DiagnosticId::sampler_kind, unit, function,
         kind == TextureKind::shader
             ? std::string("a `ShaderTexture` has no sampler; leave that parameter out")
             : fmt::format("this texture is read by a `{0}`; declare `const in {0}` as second parameter", sampler_type(kind)));
  return true;
}

/// No marker was reached: tell a name that nobody offers from one that this shape merely has not.
void PlugResolver::report_unreached(const PlacedUnit& unit, const FunctionOutline& function) {
  if (report_sampler_kind(unit, function)) return;
  const PlugInfo* plug = find_plug(plug_name(function.name));
  plug == nullptr ? report_unknown(unit, function) : report_absent_or_wrong_stage(unit, function, *plug);
}

void PlugResolver::report_strengthened(const PlacedUnit& unit, const FunctionOutline& function, const PlugInfo& plug) {
  const Parameter& parameter = *strengthened_parameter(function, plug);
  c_.diagnostics.report(
      DiagnosticId::effect_strengthened_parameter, unit.code->span(parameter.begin, parameter.end),
      fmt::format("plug `{}` passes this as `const in`; what is made of it counts here, but other programs "
                  "may refuse it{}",
                  plug.name, moves_vertices(function) ? "; use `vertex_object_space_change` to move vertices" : ""));
}

/// What can be said of an author's function without looking at each marker. A marker of the templates, or none, goes by the
/// table.
bool PlugResolver::is_sound(const PlacedUnit& unit, const FunctionOutline& function, const std::vector<MarkerPlace>& markers) {
  if (function.return_type != "void") {
    report(DiagnosticId::effect_plug_not_void, unit, function,
           fmt::format("`{}` returns `{}`; a plug function returns `void`", function.name, function.return_type));
    return false;
  }
  const PlugInfo* plug = find_plug(plug_name(function.name));
  if (plug == nullptr) return true;
  if (!plug->replaced_by.empty()) {
    report(DiagnosticId::effect_deprecated_plug, unit, function,
           fmt::format("plug `{}` is an old name; use `{}` (or `fragment_modify` for the final colour)", plug->name,
                       plug->replaced_by));
  }
  const bool by_table = markers.empty() || std::any_of(markers.begin(), markers.end(), [&](const MarkerPlace& place) {
                          return !c_.by_author(c_.units[place.unit]);
                        });
  const PlugFit fit = fit_plug(function, *plug);
  if (by_table && fit == PlugFit::strengthened) report_strengthened(unit, function, *plug);
  if (!by_table || fit != PlugFit::no) return true;
  const TextRange misfit = *find_misfit(function, *plug);
  c_.diagnostics.report(
      DiagnosticId::effect_wrong_signature, unit.code->span(misfit.begin, misfit.end),
      fmt::format("`{}` does not fit its plug; declare `void PLUG_{}({})`", function.name, plug->name, plug->signature));
  return false;
}

void PlugResolver::give_name(PlacedUnit& unit, std::size_t f) {
  const std::string written(unit.code->outline.functions[f].name);
  const StageMask stage = in_stage(unit.stage);
  constexpr std::size_t kNobody = SIZE_MAX;
  std::string name = c_.taken.is_free(written, stage, kNobody) ? written : c_.taken.new_name(written, unit.owner, c_.units);
  c_.taken.take(name, stage, unit.owner);
  unit.function_names[f] = std::move(name);
}

void PlugResolver::resolve_function(std::size_t index, std::size_t f) {
  PlacedUnit& unit = c_.units[index];
  const FunctionOutline& function = unit.code->outline.functions[f];
  const std::string_view name = plug_name(function.name);
  if (name.empty() || !function.is_definition()) return;
  if (call_bytes_ > kMaxStageBytes) return c_.mark_faulty(unit);
  const std::vector<MarkerPlace> markers = reached_markers(index, f);
  const bool by_author = c_.by_author(unit);
  if (markers.empty() && !by_author) {
    unit.dropped = true;
    return;
  }
  give_name(unit, f);
  if (by_author && !is_sound(unit, function, markers)) return c_.mark_faulty(unit);
  std::set<CallResult> results;
  for (std::size_t m = 0; m < markers.size() && !results.contains(CallResult::misfit); ++m)
    results.insert(call_at(index, f, markers[m]));
  if (!by_author || results.contains(CallResult::misfit)) return;
  if (results.contains(CallResult::called)) {
    filled_.emplace(name);
    note_only_provider(unit, markers);
    c_.result.moves_vertices = c_.result.moves_vertices || moves_vertices(function);
  }
  for (std::size_t m = 0; m < markers.size(); ++m) c_.result.calls.push_back(fmt::format("{} {}", name, to_text(unit.stage)));
  const bool of_use = results.contains(CallResult::called) || results.contains(CallResult::for_overload);
  if (!of_use && !c_.recipe.depth_only) report_unreached(unit, function);
}

/// Where all markers that a function reaches are one author's, the effect needs that author.
void PlugResolver::note_only_provider(const PlacedUnit& unit, const std::vector<MarkerPlace>& markers) {
  const std::size_t provider = c_.units[markers.front().unit].owner;
  const bool only = std::all_of(markers.begin(), markers.end(), [&](const MarkerPlace& place) {
    const Owner& owner = c_.owners[c_.units[place.unit].owner];
    return owner.kind == c_.owners[provider].kind && owner.index == c_.owners[provider].index;
  });
  if (only) c_.note_need(unit, provider, NeedKind::plug, marker_at(markers.front()).name);
}

/// A light or texture whose own code found no place in the base shader takes its effects and its shadow with it.
void PlugResolver::resolve_unit(std::size_t index) {
  PlacedUnit& unit = c_.units[index];
  if (dropped_scopes_.contains(unit.scope) || (unit.of_shadow && dropped_shadows_.contains(unit.scope))) unit.dropped = true;
  definitions_.clear();
  for (const FunctionOutline& function : unit.code->outline.functions) {
    if (function.is_definition()) ++definitions_[function.name];
  }
  for (std::size_t f = 0; f < unit.code->outline.functions.size() && !unit.dropped; ++f) resolve_function(index, f);
  const bool limited = unit.scope.kind != ScopeKind::shape;
  if (unit.dropped && limited) (unit.of_shadow ? dropped_shadows_ : dropped_scopes_).insert(unit.scope);
}

void PlugResolver::list_plugs() const {
  std::vector<std::string_view> empty;
  for (const auto& [key, places] : markers_) {
    const bool offered =
        std::any_of(places.begin(), places.end(), [&](const MarkerPlace& place) { return !c_.units[place.unit].dropped; });
    if (offered && !filled_.contains(key.second)) empty.push_back(key.second);
  }
  std::ranges::sort(empty);
  const auto repeated = std::ranges::unique(empty);
  c_.result.plugs_filled.assign(filled_.begin(), filled_.end());
  c_.result.plugs_empty.assign(empty.begin(), repeated.begin());
  std::ranges::sort(c_.result.calls);
}

/// A ComposedShader shows a shadow where its plugs let the renderer's lights in (thesis 9.2); else its author is told.
void PlugResolver::note_missing_shadows() const {
  const auto& lights = c_.recipe.lights;
  const bool wanted = std::any_of(lights.begin(), lights.end(), [](const LightRecipe& light) { return light.shadow; });
  if (c_.recipe.shader < 0 || !wanted) return;
  const bool shown = std::any_of(c_.units.begin(), c_.units.end(), [&](const PlacedUnit& unit) {
    return !unit.dropped && unit.of_shadow && unit.stage == ShaderStage::fragment;
  });
  if (shown) return;
  c_.diagnostics.report(
      DiagnosticId::composed_shader_no_shadows, c_.input.scene.shaders[static_cast<std::size_t>(c_.recipe.shader)].span,
      "this `ComposedShader` shows no shadow: it has no plug `add_light_contribution` that the shadowed light could fill");
}

void PlugResolver::resolve() {
  index_markers();
  for (std::size_t unit = 0; unit < c_.units.size(); ++unit) resolve_unit(unit);
  list_plugs();
  note_missing_shadows();
}

}  // namespace

void resolve_plugs(Composition& composition) {
  PlugResolver(composition).resolve();
}

}  // namespace plugc
