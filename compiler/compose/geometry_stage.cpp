// The stage's units are, in this order: the template's three functions, the renderer's varyings on their way through, then
// the authors' parts; behind each vertex part with passthrough markers stands a unit of the same effect that passes those
// varyings on, so that they are renamed together with the effect's other names. Only what some fragment code reads passes.
// The input layout is written in the head of the stage: arrays of inputs get their size from it, and the parts that have
// such arrays may stand in front of the one that has the layout.

#include "compose/geometry_stage.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/geometry_layout.h"
#include "compose/varying_passthrough.h"

namespace plugc {
namespace {

std::string_view drawn_as(Primitive primitive) {
  constexpr std::string_view kNames[] = {"triangles", "points", "lines", "triangles"};
  return kNames[static_cast<std::size_t>(primitive)];
}

Span main_span(const CodeUnit& code) {
  const FunctionOutline* function = find_main(code);
  return function == nullptr ? code.span(0, 1) : name_span(code, function->name, function->name_begin);
}

bool writes(const CodeUnit& code, std::string_view name) {
  return std::ranges::any_of(
      code.outline.globals, [&](const GlobalOutline& global) { return global.storage == Storage::out && global.name == name; });
}

bool uses_castle_name(const CodeUnit& code, std::string_view name) {
  return std::ranges::find(code.castle_names, name) != code.castle_names.end();
}

class GeometryPlacer {
 public:
  explicit GeometryPlacer(Composition& composition) : c_(composition) {}
  bool place();

 private:
  bool check_mains();
  bool check_layouts(const PlacedUnit& main);
  bool check_primitive(const PlacedUnit& unit, const InputLayout& layout);
  bool refuse(const PlacedUnit& unit, DiagnosticId id, const Span& span, std::string message);
  std::vector<std::string> renderer_varyings() const;
  bool is_written(const std::string& varying) const;
  bool finds_marker(const PlacedUnit& unit) const;
  void note_fragment_inputs();
  PlacedUnit renderer_unit() const;
  PlacedUnit effect_unit(const PlacedUnit& vertex_unit) const;
  PlacedUnit passing_unit(const std::vector<PassedVarying>& varyings, const PlacedUnit& of, const Span& origin) const;
  const std::string& label(const PlacedUnit& unit) const { return c_.author(c_.owners[unit.owner]).label; }
  bool any_unit(ShaderStage stage, auto predicate) const {
    return std::ranges::any_of(c_.units, [&](const PlacedUnit& unit) { return unit.stage == stage && predicate(unit); });
  }

  Composition& c_;
  std::set<std::string_view> fragment_inputs_;
};

/// A program has one `main` a stage: the first that can be it. Every further one is at fault. False: none can.
bool GeometryPlacer::check_mains() {
  const PlacedUnit* main = nullptr;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.stage != ShaderStage::geometry || find_main(*unit.code) == nullptr) continue;
    if (main == nullptr) {
      if (check_layouts(unit)) main = &unit;
      continue;
    }
    const std::string first = main->owner == unit.owner ? "another part of it" : fmt::format("`{}`", label(*main));
    c_.diagnostics.report(
        DiagnosticId::geometry_two_mains, main_span(*unit.code),
        fmt::format("a shape can have one geometry shader, and {} has its `main`; `{}` is left out", first, label(unit)),
        {{main_span(*main->code), "the other `main` is here"}});
    c_.mark_faulty(unit);
  }
  return main != nullptr;
}

bool GeometryPlacer::refuse(const PlacedUnit& unit, DiagnosticId id, const Span& span, std::string message) {
  c_.diagnostics.report(id, span, std::move(message));
  c_.mark_faulty(unit);
  return false;
}

bool GeometryPlacer::check_primitive(const PlacedUnit& unit, const InputLayout& layout) {
  const std::string_view drawn = drawn_as(c_.recipe.primitive);
  const Span span = unit.code->span(layout.range.begin, layout.range.end);
  if (layout.primitive == drawn) {
    c_.geometry = {input_size(drawn), fmt::format("layout({}) in;\n", drawn), span, unit.owner};
    return true;
  }
  const std::string_view why = layout.primitive.ends_with("adjacency") ? " (plugc draws nothing with adjacency)" : "";
  return refuse(unit, DiagnosticId::geometry_primitive, span,
                fmt::format("this geometry shader takes `{}`, but its shape is drawn as `{}`{}; `{}` is left out there",
                            layout.primitive, drawn, why, label(unit)));
}

bool GeometryPlacer::check_layouts(const PlacedUnit& main) {
  const PlacedUnit* input = nullptr;
  bool output = false;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.stage != ShaderStage::geometry || unit.owner != main.owner) continue;
    if (input == nullptr && find_input_layout(*unit.code)) input = &unit;
    output = output || has_output_layout(*unit.code);
  }
  if (input == nullptr) {
    return refuse(
        main, DiagnosticId::geometry_layout, main_span(*main.code),
        fmt::format("this geometry shader does not say what it takes; write `layout({}) in;`", drawn_as(c_.recipe.primitive)));
  }
  if (!output) {
    return refuse(main, DiagnosticId::geometry_layout, main_span(*main.code),
                  "this geometry shader does not say what it makes; write `layout(triangle_strip, max_vertices = 3) out;` "
                  "or the like");
  }
  return check_primitive(*input, *find_input_layout(*input->code));
}

/// Whether a piece of the renderer has a plug to stand in, as far as vertex code goes: a ComposedShader may lack it.
bool GeometryPlacer::finds_marker(const PlacedUnit& unit) const {
  return c_.by_author(unit) || std::ranges::all_of(unit.code->outline.functions, [&](const FunctionOutline& function) {
           const std::string_view plug = plug_name(function.name);
           return plug.empty() || any_unit(unit.stage, [&](const PlacedUnit& other) {
                    return std::ranges::find(other.code->outline.markers, plug, &MarkerOutline::name) !=
                           other.code->outline.markers.end();
                  });
         });
}

/// Whether the vertex stage has the renderer's varying. One that only a ComposedShader reads is declared there too.
bool GeometryPlacer::is_written(const std::string& varying) const {
  return any_unit(ShaderStage::vertex,
                  [&](const PlacedUnit& unit) { return uses_castle_name(*unit.code, varying) && finds_marker(unit); }) ||
         any_unit(ShaderStage::fragment, [&](const PlacedUnit& unit) {
           return c_.owners[unit.owner].kind == OwnerKind::shader && uses_castle_name(*unit.code, varying);
         });
}

/// Those that the fragment stage reads, or that an author's geometry code writes, and that no such code passes on itself.
std::vector<std::string> GeometryPlacer::renderer_varyings() const {
  std::vector<std::string> names;
  const auto add = [&](std::string_view name) {
    const auto meaning = find_castle_name(name);
    if (!meaning || meaning->kind != CastleKind::varying || std::ranges::find(names, name) != names.end()) return;
    const bool passed_by_author =
        any_unit(ShaderStage::geometry, [&](const PlacedUnit& unit) { return writes(*unit.code, name); });
    if (!passed_by_author && is_written(std::string(name))) names.emplace_back(name);
  };
  for (const PlacedUnit& unit : c_.units) {
    for (const std::string& name : unit.code->castle_names) {
      if (unit.stage == ShaderStage::fragment) add(name);
      if (unit.stage == ShaderStage::geometry) add(name_before_geometry(name));
    }
  }
  std::ranges::sort(names);
  return names;
}

PlacedUnit GeometryPlacer::passing_unit(const std::vector<PassedVarying>& varyings, const PlacedUnit& of,
                                        const Span& origin) const {
  if (varyings.empty()) return {};
  MappedText text;
  text.append_generated(passthrough_text(varyings, c_.geometry.input_size), origin);
  PlacedUnit unit = make_placed_unit(make_code_unit(text, ShaderStage::geometry), ShaderStage::geometry, of.owner, of.scope);
  for (const PassedVarying& varying : varyings) unit.passes.push_back(varying.name);
  return unit;
}

PlacedUnit GeometryPlacer::renderer_unit() const {
  std::vector<PassedVarying> varyings;
  for (const std::string& name : renderer_varyings()) varyings.push_back({"", std::string(find_castle_name(name)->type), name});
  return passing_unit(varyings, PlacedUnit(), {});
}

void GeometryPlacer::note_fragment_inputs() {
  for (const PlacedUnit& unit : c_.units) {
    if (unit.stage != ShaderStage::fragment) continue;
    for (const GlobalOutline& global : unit.code->outline.globals) {
      if (global.storage == Storage::in) fragment_inputs_.insert(global.name);
    }
  }
}

PlacedUnit GeometryPlacer::effect_unit(const PlacedUnit& vertex_unit) const {
  std::vector<PassedVarying> varyings;
  Span origin;
  for (const MarkerOutline& marker : vertex_unit.code->outline.markers) {
    if (marker.kind != MarkerKind::varying_passthrough) continue;
    for (const GlobalOutline* global : marked_varyings(*vertex_unit.code, marker)) {
      if (!fragment_inputs_.contains(global->name) || find_castle_name(global->name)) continue;
      varyings.push_back({std::string(global->qualifiers), std::string(global->type), std::string(global->name)});
      if (!origin.valid()) origin = vertex_unit.code->span(marker.begin, marker.end);
    }
  }
  return passing_unit(varyings, vertex_unit, origin);
}

bool GeometryPlacer::place() {
  if (!check_mains()) return false;
  note_fragment_inputs();
  std::vector<PlacedUnit> units;
  const auto add = [&](PlacedUnit unit) {
    if (!unit.passes.empty()) units.push_back(std::move(unit));
  };
  units.push_back(make_placed_unit(c_.input.templates.get("geometry.geom", {}), ShaderStage::geometry));
  add(renderer_unit());
  std::vector<PlacedUnit> passing;
  for (const PlacedUnit& unit : c_.units)
    passing.push_back(unit.stage == ShaderStage::vertex ? effect_unit(unit) : PlacedUnit());
  for (std::size_t i = 0; i < passing.size(); ++i) {
    units.push_back(std::move(c_.units[i]));
    add(std::move(passing[i]));
  }
  c_.units = std::move(units);
  return true;
}

void report_target(Composition& c, const EffectCode& code, std::string_view label, std::string_view instead) {
  for (const EffectCode::Part& part : code.parts) {
    if (!part.in_geometry || find_main(*part.in_geometry) == nullptr) continue;
    c.diagnostics.report(
        DiagnosticId::geometry_target, main_span(*part.in_geometry),
        fmt::format("target `{}` has no geometry shaders; `{}` is left out of it{}", to_text(c.target), label, instead));
  }
}

}  // namespace

bool wants_geometry_stage(Composition& c) {
  std::vector<int> bringing = all_effects(c.recipe);
  std::erase_if(bringing, [&](int effect) { return !c.input.effects[static_cast<std::size_t>(effect)].has_geometry_main; });
  const auto shader = static_cast<std::size_t>(std::max(c.recipe.shader, 0));
  const bool by_shader = c.recipe.shader >= 0 && c.input.shaders[shader].has_geometry_main;
  if (c.target != Target::essl300) return by_shader || !bringing.empty();
  for (const int effect : bringing) {
    const auto index = static_cast<std::size_t>(effect);
    report_target(c, c.input.effects[index], c.input.scene.effects[index].label, "");
    c.result.faulty_effects.push_back(effect);
  }
  if (by_shader) {
    report_target(c, c.input.shaders[shader], c.input.scene.shaders[shader].label, ", where the base shader is used");
    c.result.faulty_shader = true;
  }
  return false;
}

bool place_geometry_stage(Composition& composition) {
  return !composition.has_geometry || GeometryPlacer(composition).place();
}

void note_passed_varyings(Composition& composition) {
  for (const PlacedUnit& unit : composition.units) {
    if (unit.dropped) continue;
    for (const std::string& name : unit.passes) {
      const std::string_view behind = composition.taken.keep(name + std::string(kBehindGeometry));
      composition.passed.emplace(composition.final_name(unit, name), composition.final_name(unit, behind));
    }
  }
}

}  // namespace plugc
