// For every plug function, in call order: find the markers that it reaches (plug_markers.h), check that it fits, give it a
// name of its own and note its call there. A piece of the renderer whose plug nobody offers is dropped.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/limits.h"
#include "compose/plug_markers.h"
#include "compose/plug_reports.h"
#include "compose/plug_signature.h"

namespace plugc {
namespace {

/// What became of a function at its markers: it is called, or its overload is, or the texture or material is of another kind,
/// or its author erred.
struct CallResults {
  bool called = false, for_overload = false, other_kind = false, misfit = false;
};

class PlugResolver {
 public:
  explicit PlugResolver(Composition& composition) : c_(composition), markers_(composition) {}
  void resolve();

 private:
  void resolve_unit(std::size_t unit);
  void resolve_function(std::size_t unit, const PlugFunction& function);
  CallResults call_at_all(std::size_t unit, const PlugFunction& function, std::span<const MarkerPlace> places);
  void call_at(std::size_t unit, const PlugFunction& function, const MarkerPlace& place, CallResults& results);
  bool add_call(std::size_t unit, const PlugFunction& function, const MarkerPlace& place);
  void note_author_calls(const PlacedUnit& unit, const PlugFunction& function, std::span<const MarkerPlace> places,
                         const CallResults& results);
  void note_only_provider(const PlacedUnit& unit, std::span<const MarkerPlace> places);
  void give_name(PlacedUnit& unit, const PlugFunction& function);
  void list_plugs() const;
  void note_missing_shadows() const;

  Composition& c_;
  PlugMarkers markers_;
  std::set<std::string_view> filled_;
  std::set<PlugScope> dropped_scopes_, dropped_shadows_;
  std::size_t call_bytes_ = 0;
};

/// All that guards the called code, save what guards its caller anyway.
std::vector<std::size_t> guards_of_call(const PlacedUnit& called, const PlacedUnit& caller) {
  std::vector<std::size_t> guards = called.guards;
  std::erase_if(guards, [&](std::size_t guard) { return std::ranges::find(caller.guards, guard) != caller.guards.end(); });
  return guards;
}

/// Notes the call, unless the program's calls have grown beyond what a stage may hold.
bool PlugResolver::add_call(std::size_t index, const PlugFunction& plug, const MarkerPlace& place) {
  const PlacedUnit& unit = c_.units[index];
  const FunctionOutline& function = unit.code->outline.functions[plug.function];
  const MarkerOutline& marker = markers_.outline(place);
  call_bytes_ += unit.function_names[plug.function].size() + marker.arguments.size() + 8;
  if (call_bytes_ > kMaxStageBytes) {
    report_at_plug(c_, DiagnosticId::shader_limit, unit, plug,
                   fmt::format("the calls of all plugs of this shape are longer than {} bytes", kMaxStageBytes));
    c_.mark_faulty(unit);
    return false;
  }
  const bool rgb_only =
      is_per_light_color(marker.name) && !function.parameters.empty() && function.parameters.front().type == "vec3";
  PlacedUnit& caller = c_.units[place.unit];
  caller.calls[place.marker].push_back({index, plug.function, rgb_only, guards_of_call(unit, caller)});
  return true;
}

void PlugResolver::call_at(std::size_t index, const PlugFunction& plug, const MarkerPlace& place, CallResults& results) {
  const PlacedUnit& unit = c_.units[index];
  const CodeUnit& target = *c_.units[place.unit].code;
  const MarkerOutline& marker = markers_.outline(place);
  const auto& functions = unit.code->outline.functions;
  const auto fits = [&](const PlugFunction& each) {
    return each.plug == plug.plug && fits_marker(functions[each.function], target, marker, plug.overloaded);
  };
  if (fits(plug)) {
    (add_call(index, plug, place) ? results.called : results.misfit) = true;
  } else if (plug.overloaded && std::ranges::any_of(unit.code->plug_functions, fits)) {
    results.for_overload = true;
  } else if (marker.name == "texture_color" || marker.name == "add_light") {
    results.other_kind = true;
  } else {
    report_misfit(c_, unit, plug, markers_, place);
    results.misfit = true;
  }
}

CallResults PlugResolver::call_at_all(std::size_t unit, const PlugFunction& function, std::span<const MarkerPlace> places) {
  CallResults results;
  for (std::size_t i = 0; i < places.size() && !results.misfit; ++i) call_at(unit, function, places[i], results);
  return results;
}

void PlugResolver::give_name(PlacedUnit& unit, const PlugFunction& function) {
  const std::string_view written = unit.code->outline.functions[function.function].name;
  const StageMask stage = in_stage(unit.stage);
  constexpr std::size_t kNobody = SIZE_MAX;
  const std::string_view name =
      c_.taken.is_free(written, stage, kNobody) ? written : c_.taken.new_name(written, unit.owner, c_.units);
  c_.taken.take(name, stage, unit.owner);
  unit.function_names[function.function] = name;
}

void PlugResolver::note_author_calls(const PlacedUnit& unit, const PlugFunction& function, std::span<const MarkerPlace> places,
                                     const CallResults& results) {
  if (results.called) {
    filled_.insert(function.plug);
    note_only_provider(unit, places);
    c_.result.moves_vertices = c_.result.moves_vertices || moves_vertices(unit.code->outline.functions[function.function]);
  }
  c_.result.calls.insert(c_.result.calls.end(), places.size(), {function.plug, unit.stage});
  if (!results.called && !results.for_overload && !c_.recipe.depth_pass) report_unreached(c_, unit, function, markers_);
}

void PlugResolver::resolve_function(std::size_t index, const PlugFunction& function) {
  PlacedUnit& unit = c_.units[index];
  if (call_bytes_ > kMaxStageBytes) return c_.mark_faulty(unit);
  const std::vector<MarkerPlace> places = markers_.reached_by(index, function);
  const bool by_author = c_.by_author(unit);
  if (places.empty() && !by_author) {
    unit.dropped = true;
    return;
  }
  give_name(unit, function);
  if (by_author && !is_sound_plug(c_, unit, function, places)) return c_.mark_faulty(unit);
  const CallResults results = call_at_all(index, function, places);
  if (by_author && !results.misfit) note_author_calls(unit, function, places, results);
}

/// Where all markers that a function reaches are one author's, the effect needs that author.
void PlugResolver::note_only_provider(const PlacedUnit& unit, std::span<const MarkerPlace> places) {
  const std::size_t provider = c_.units[places.front().unit].owner;
  const bool only = std::ranges::all_of(places, [&](const MarkerPlace& place) {
    const Owner& owner = c_.owners[c_.units[place.unit].owner];
    return owner.kind == c_.owners[provider].kind && owner.index == c_.owners[provider].index;
  });
  if (only) c_.note_need(unit, provider, NeedKind::plug, places.front().plug);
}

/// A light or texture whose own code found no place in the base shader takes its effects and its shadow with it.
void PlugResolver::resolve_unit(std::size_t index) {
  PlacedUnit& unit = c_.units[index];
  if (dropped_scopes_.contains(unit.scope) || (unit.of_shadow && dropped_shadows_.contains(unit.scope))) unit.dropped = true;
  const auto& functions = unit.code->plug_functions;
  for (std::size_t f = 0; f < functions.size() && !unit.dropped; ++f) resolve_function(index, functions[f]);
  const bool limited = unit.scope.kind != ScopeKind::shape;
  if (unit.dropped && limited) (unit.of_shadow ? dropped_shadows_ : dropped_scopes_).insert(unit.scope);
}

void PlugResolver::list_plugs() const {
  std::vector<std::string_view> empty;
  for (const MarkerPlace& place : markers_.all()) {
    const bool known = !empty.empty() && empty.back() == place.plug;
    if (!known && !c_.units[place.unit].dropped && !filled_.contains(place.plug)) empty.push_back(place.plug);
  }
  std::ranges::sort(empty);
  const auto repeated = std::ranges::unique(empty);
  c_.result.plugs_filled.assign(filled_.begin(), filled_.end());
  c_.result.plugs_empty.assign(empty.begin(), repeated.begin());
  std::ranges::sort(c_.result.calls);
}

/// A ComposedShader shows a shadow where its plugs let the renderer's lights in (thesis 9.2); else its author is told.
void PlugResolver::note_missing_shadows() const {
  const bool wanted = std::ranges::any_of(c_.recipe.lights, &LightRecipe::shadow);
  if (c_.recipe.shader < 0 || !wanted) return;
  const bool shown = std::ranges::any_of(
      c_.units, [&](const PlacedUnit& unit) { return !unit.dropped && unit.of_shadow && unit.stage == ShaderStage::fragment; });
  if (shown) return;
  c_.diagnostics.report(
      DiagnosticId::composed_shader_no_shadows, c_.input.scene.shaders[static_cast<std::size_t>(c_.recipe.shader)].span,
      "this `ComposedShader` shows no shadow: it has no plug `add_light_contribution` that the shadowed light could fill");
}

void PlugResolver::resolve() {
  for (std::size_t unit = 0; unit < c_.units.size(); ++unit) resolve_unit(unit);
  list_plugs();
  note_missing_shadows();
}

}  // namespace

void resolve_plugs(Composition& composition) {
  PlugResolver(composition).resolve();
}

}  // namespace plugc
