// Fragment code behind a geometry stage reads what that writes, and what passes it.

#include "compose/bind_inputs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "compose/borrow_functions.h"
#include "compose/name_use.h"

namespace plugc {

void InputBinder::index_outputs() {
  if (std::exchange(indexed_, true)) return;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.dropped) continue;
    for (const GlobalOutline& global : unit.code->outline.globals) {
      if (global.storage == Storage::out)
        outputs_[static_cast<std::size_t>(unit.stage)][global.name].push_back({&unit, &global});
    }
  }
}

/// Those that do more than declare it; several of one owner where it contradicts itself.
InputBinder::Outputs InputBinder::written_in(ShaderStage stage, std::string_view name) {
  index_outputs();
  const auto& outputs = outputs_[static_cast<std::size_t>(stage)];
  const auto found = outputs.find(name);
  Outputs written;
  if (found == outputs.end()) return written;
  std::ranges::copy_if(found->second, std::back_inserter(written),
                       [&](const Output& output) { return is_used(*output.unit->code, name, output.global->name_begin); });
  return written;
}

/// Who writes the name for a stage to read.
InputBinder::Outputs InputBinder::writers(ShaderStage reader, std::string_view name) {
  Outputs all = written_in(ShaderStage::vertex, name);
  if (reader == ShaderStage::geometry || !c_.has_geometry) return all;
  std::erase_if(all, [&](const Output& output) { return !c_.passed.contains(c_.name_of(output.unit->owner, name)); });
  std::ranges::copy(written_in(ShaderStage::geometry, name), std::back_inserter(all));
  return all;
}

namespace {

bool any_of_owner(const auto& outputs, std::size_t owner) {
  return std::ranges::any_of(outputs, [&](const auto& output) { return output.unit->owner == owner; });
}

/// Those whose output is what the input asks for; a geometry stage reads an array of it.
std::set<std::size_t> owners_that_fit(const auto& outputs, const GlobalOutline& input, ShaderStage reader) {
  std::set<std::size_t> owners;
  for (const auto& output : outputs) {
    const bool sizes_fit = reader == ShaderStage::geometry ? !input.array.empty() : output.global->array == input.array;
    if (sizes_fit && output.global->type == input.type) owners.insert(output.unit->owner);
  }
  return owners;
}

}  // namespace

std::string InputBinder::unwritten_message(const PlacedUnit& unit, const GlobalOutline& input) {
  const Outputs in_vertex = writers(ShaderStage::geometry, input.name);
  if (unit.stage == ShaderStage::fragment && c_.has_geometry && !owners_that_fit(in_vertex, input, unit.stage).empty()) {
    return fmt::format(
        "`{}` is written in the vertex stage and does not get through the geometry shader of this shape; write "
        "`/* VARYING-PASSTHROUGH-GEOMETRY-SHADERS */` in front of `varying {} {};` in the `VERTEX` part",
        input.name, input.type, input.name);
  }
  return fmt::format("nothing writes `{}`; declare it as `varying {} {};` in a `VERTEX` part too and write it there",
                     input.name, input.type, input.name);
}

/// What geometry code writes is there as long as some effect brings the `main` of that stage.
void InputBinder::note_geometry(const PlacedUnit& unit, std::string_view name, const Outputs& all) {
  if (!c_.has_geometry || unit.stage != ShaderStage::fragment) return;
  const Outputs written = written_in(ShaderStage::geometry, name);
  const bool reads = std::ranges::any_of(written, [&](const Output& output) { return any_of_owner(all, output.unit->owner); });
  if (reads) c_.note_need(unit, c_.geometry.owner, NeedKind::geometry_shader, "");
}

void InputBinder::bind_input(const PlacedUnit& unit, const GlobalOutline& input) {
  const std::string_view read = unit.code->macro_word(input.name);
  const Outputs all = writers(unit.stage, read);
  note_geometry(unit, read, all);
  if (any_of_owner(all, unit.owner) || !is_used(*unit.code, input.name, input.name_begin)) return;
  const std::set<std::size_t> candidates = one_for_each_author(c_, owners_that_fit(all, input, unit.stage));
  if (candidates.size() != 1) return report_unwritten(unit, input, candidates.size());
  c_.note_need(unit, *candidates.begin(), NeedKind::varying, read);
  borrow_name(c_, unit, read, *candidates.begin());
}

void InputBinder::report_unwritten(const PlacedUnit& unit, const GlobalOutline& input, std::size_t candidates) {
  if (candidates == 0) {
    return c_.report_fault(DiagnosticId::varying_unwritten, unit, input.name, input.name_begin, unwritten_message(unit, input),
                           unwritten_causes(unit, unit.code->macro_word(input.name)));
  }
  c_.report_fault(
      DiagnosticId::varying_unwritten, unit, input.name, input.name_begin,
      fmt::format("`{}` is read here and written by {} other effects; write it in this one", input.name, candidates));
}

/// Where it is declared and not written; else code that is not understood and may have been meant to write it, or to bring the
/// geometry stage in which it is written.
std::vector<RelatedPlace> InputBinder::unwritten_causes(const PlacedUnit& unit, std::string_view name) {
  for (const PlacedUnit& other : c_.units) {
    for (const GlobalOutline& global : other.code->outline.globals) {
      if (global.storage == Storage::out && global.name == name && other.stage != ShaderStage::fragment)
        return {{name_span(*other.code, global.name, global.name_begin), "it is declared here"}};
    }
  }
  std::vector<RelatedPlace> causes = doubtful_places(c_.input, ShaderStage::vertex, name);
  const bool by_geometry = !written_in(ShaderStage::geometry, name).empty() || !c_.has_geometry;
  if (causes.empty() && unit.stage == ShaderStage::fragment && by_geometry)
    causes = doubtful_places(c_.input, ShaderStage::geometry, "");
  return causes;
}

bool InputBinder::in_vertex_stage(std::string_view castle_name) const {
  return std::ranges::any_of(c_.units, [&](const PlacedUnit& unit) {
    const auto& names = unit.code->castle_names;
    return unit.stage == ShaderStage::vertex && !unit.dropped && std::ranges::find(names, castle_name) != names.end();
  });
}

/// castle_ varyings that this shape's vertex stage does not have: `castle_Color` under Phong shading, say.
void InputBinder::check_castle_inputs(const PlacedUnit& unit) {
  if (c_.owners[unit.owner].kind != OwnerKind::effect || c_.recipe.depth_only) return;
  for (const std::string& name : unit.code->castle_names) {
    const auto meaning = find_castle_name(name);
    if (!meaning || meaning->kind != CastleKind::varying || in_vertex_stage(name)) continue;
    const auto& tokens = unit.code->tokens.tokens;
    const auto token = std::ranges::find_if(
        tokens, [&](const Token& t) { return t.kind == TokenKind::identifier && unit.code->at(t) == name; });
    c_.report_fault(DiagnosticId::varying_unwritten, unit, name, token == tokens.end() ? 0 : token->begin,
                    fmt::format("nothing writes `{}` in the vertex stage of this shape{}", name,
                                name == "castle_Color" ? "; it is there under `GOURAUD` shading only" : ""));
  }
}

void InputBinder::bind(const PlacedUnit& unit) {
  if (unit.stage == ShaderStage::vertex) return;
  for (const GlobalOutline& global : unit.code->outline.globals) {
    if (global.storage == Storage::in && !global.name.starts_with("castle_")) bind_input(unit, global);
  }
  check_castle_inputs(unit);
}

}  // namespace plugc
