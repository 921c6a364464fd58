#include "compose/plug_reports.h"

#include <algorithm>

#include <fmt/format.h>

#include "compose/plug_signature.h"
#include "compose/plug_table.h"
#include "compose/sampler_type.h"

namespace plugc {
namespace {

/// One function, and where it is said.
class PlugReport {
 public:
  PlugReport(Composition& composition, const PlacedUnit& unit, const PlugFunction& plug)
      : c_(composition), unit_(unit), plug_(plug), function_(unit.code->outline.functions[plug.function]) {}

  bool is_sound(std::span<const MarkerPlace> markers);
  void misfit(const PlugMarkers& markers, const MarkerPlace& place);
  void unreached(const PlugMarkers& markers);
  void say(DiagnosticId id, std::string message, std::vector<RelatedPlace> related = {}) const {
    c_.diagnostics.report(id, name_span(*unit_.code, function_.name, function_.name_begin), std::move(message),
                          std::move(related));
  }

 private:
  bool fits_table(const PlugInfo& plug, bool by_table);
  void strengthened(const PlugInfo& plug) const;
  bool sampler_kind() const;
  bool serves_texture(TextureKind kind) const;
  void absent_or_wrong_stage(const PlugInfo& plug) const;
  void unknown(const PlugMarkers& markers) const;

  Composition& c_;
  const PlacedUnit& unit_;
  const PlugFunction& plug_;
  const FunctionOutline& function_;
};

void PlugReport::misfit(const PlugMarkers& markers, const MarkerPlace& place) {
  const std::size_t passed = markers.outline(place).argument_list.size();
  const std::size_t taken = function_.parameters.size();
  if (!c_.by_author(unit_)) {
    c_.diagnostics.report(
        DiagnosticId::effect_wrong_signature, markers.span(place),
        fmt::format("this plug passes {} arguments, but the renderer's `{}` takes {}", passed, function_.name, taken));
    return;
  }
  say(DiagnosticId::effect_wrong_signature,
      passed == taken ? fmt::format("no parameter list of `{}` has the types that its plug passes", function_.name)
                      : fmt::format("`{}` takes {} arguments, but its plug passes {}", function_.name, taken, passed),
      {{markers.span(place), "the plug stands here"}});
  c_.mark_faulty(unit_);
}

void PlugReport::unknown(const PlugMarkers& markers) const {
  const std::string_view name = plug_.plug;
  if (const MarkerPlace* later = markers.find(name, unit_.stage, true)) {
    return say(DiagnosticId::effect_unknown_plug,
               fmt::format("plug `{}` is offered only behind this function; a plug of an effect serves what comes later", name),
               {{markers.span(*later), "the plug stands here"}});
  }
  if (const MarkerPlace* elsewhere = markers.find(name, unit_.stage, false)) {
    return say(DiagnosticId::effect_wrong_stage,
               fmt::format("plug `{}` is called in the {} stage, not in the {} stage", name, to_text(elsewhere->stage),
                           to_text(unit_.stage)),
               {{markers.span(*elsewhere), "the plug stands here"}});
  }
  std::vector<std::string_view> known(plug_names().begin(), plug_names().end());
  for (const MarkerPlace& place : markers.all()) known.push_back(place.plug);
  say(DiagnosticId::effect_unknown_plug,
      fmt::format("no plug `{}` in a {} stage{}", name, to_text(unit_.stage), did_you_mean(name, known)),
      doubtful_places(c_.input, unit_.stage, name));
}

void PlugReport::absent_or_wrong_stage(const PlugInfo& plug) const {
  const bool wrong_stage = (plug.stage == PlugStage::vertex && unit_.stage != ShaderStage::vertex) ||
                           (plug.stage == PlugStage::fragment && unit_.stage != ShaderStage::fragment) ||
                           (plug.stage == PlugStage::geometry && unit_.stage != ShaderStage::geometry);
  if (wrong_stage) {
    say(DiagnosticId::effect_wrong_stage, fmt::format("plug `{}` is not called in a {} stage; put it into a part of type `{}`",
                                                      plug.name, to_text(unit_.stage), to_text(plug.stage)));
  } else {
    say(DiagnosticId::effect_plug_absent,
        fmt::format("plug `{}` is not called for every shape that uses this effect (it is called {})", plug.name, plug.when));
  }
}

/// An effect that serves textures of several kinds has a function for each.
bool PlugReport::serves_texture(TextureKind kind) const {
  return std::ranges::any_of(c_.units, [&](const PlacedUnit& other) {
    return other.owner == unit_.owner && other.stage == unit_.stage &&
           std::ranges::any_of(other.code->outline.functions, [&](const FunctionOutline& each) {
             return each.name == function_.name && each.is_definition() && takes_texture(each, sampler_type(kind));
           });
  });
}

/// What an effect of the texture itself would have to declare; false where that is not what is wrong.
bool PlugReport::sampler_kind() const {
  const bool samples = unit_.stage == ShaderStage::fragment && plug_.plug == "texture_color";
  if (!samples || unit_.scope.kind != ScopeKind::texture) return false;
  const TextureKind kind = c_.recipe.textures[static_cast<std::size_t>(unit_.scope.number)].kind;
  if (serves_texture(kind)) return true;
  say(DiagnosticId::sampler_kind,
      kind == TextureKind::shader
          ? std::string("a `ShaderTexture` has no sampler; leave that parameter out")
          : fmt::format("this texture is read by a `{0}`; declare `const in {0}` as second parameter", sampler_type(kind)));
  return true;
}

void PlugReport::unreached(const PlugMarkers& markers) {
  if (sampler_kind()) return;
  const PlugInfo* plug = find_plug(plug_.plug);
  plug == nullptr ? unknown(markers) : absent_or_wrong_stage(*plug);
}

void PlugReport::strengthened(const PlugInfo& plug) const {
  const Parameter& parameter = *strengthened_parameter(function_, plug);
  c_.diagnostics.report(
      DiagnosticId::effect_strengthened_parameter, unit_.code->span(parameter.begin, parameter.end),
      fmt::format("plug `{}` passes this as `const in`; what is made of it counts here, but other programs "
                  "may refuse it{}",
                  plug.name, moves_vertices(function_) ? "; use `vertex_object_space_change` to move vertices" : ""));
}

bool PlugReport::fits_table(const PlugInfo& plug, bool by_table) {
  const PlugFit fit = fit_plug(function_, plug);
  if (by_table && fit == PlugFit::strengthened) strengthened(plug);
  if (!by_table || fit != PlugFit::no) return true;
  const TextRange misfit = *find_misfit(function_, plug);
  c_.diagnostics.report(
      DiagnosticId::effect_wrong_signature, unit_.code->span(misfit.begin, misfit.end),
      fmt::format("`{}` does not fit its plug; declare `void PLUG_{}({})`", function_.name, plug.name, plug.signature));
  return false;
}

bool PlugReport::is_sound(std::span<const MarkerPlace> markers) {
  if (function_.return_type != "void") {
    say(DiagnosticId::effect_plug_not_void,
        fmt::format("`{}` returns `{}`; a plug function returns `void`", function_.name, function_.return_type));
    return false;
  }
  const PlugInfo* plug = find_plug(plug_.plug);
  if (plug == nullptr) return true;
  if (!plug->replaced_by.empty()) {
    say(DiagnosticId::effect_deprecated_plug,
        fmt::format("plug `{}` is an old name; use `{}` (or `fragment_modify` for the final colour)", plug->name,
                    plug->replaced_by));
  }
  const bool by_table = markers.empty() || std::ranges::any_of(markers, [&](const MarkerPlace& place) {
                          return !c_.by_author(c_.units[place.unit]);
                        });
  return fits_table(*plug, by_table);
}

}  // namespace

bool is_sound_plug(Composition& composition, const PlacedUnit& unit, const PlugFunction& function,
                   std::span<const MarkerPlace> markers) {
  return PlugReport(composition, unit, function).is_sound(markers);
}

void report_misfit(Composition& composition, const PlacedUnit& unit, const PlugFunction& function, const PlugMarkers& markers,
                   const MarkerPlace& place) {
  PlugReport(composition, unit, function).misfit(markers, place);
}

void report_unreached(Composition& composition, const PlacedUnit& unit, const PlugFunction& function,
                      const PlugMarkers& markers) {
  PlugReport(composition, unit, function).unreached(markers);
}

void report_at_plug(Composition& composition, DiagnosticId id, const PlacedUnit& unit, const PlugFunction& function,
                    std::string message, std::vector<RelatedPlace> related) {
  PlugReport(composition, unit, function).say(id, std::move(message), std::move(related));
}

}  // namespace plugc
