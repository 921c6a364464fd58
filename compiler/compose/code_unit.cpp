// Texts are upgraded first, so that everything behind this file sees one dialect; then tokens and outline are taken from
// the upgraded text, whose map still leads to the author.

#include "compose/code_unit.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {
namespace {

Storage varying_storage(ShaderStage stage) { return stage == ShaderStage::vertex ? Storage::out : Storage::in; }

void report_problems(const CodeUnit& unit, Diagnostics& diagnostics) {
  if (unit.tokens.too_many) {
    diagnostics.report(DiagnosticId::shader_limit, unit.span(0, 1),
                       fmt::format("this part has more than {} tokens; what follows is left out", kMaxShaderTokens));
  }
  for (const OutlineProblem& problem : unit.outline.problems) {
    diagnostics.report(DiagnosticId::shader_syntax, unit.span(problem.begin, problem.end), problem.message);
  }
}

template <typename Predicate>
bool any_unit(const EffectCode& code, Predicate predicate) {
  return std::any_of(code.parts.begin(), code.parts.end(), [&](const EffectCode::Part& part) {
    return (part.in_vertex && predicate(*part.in_vertex)) || (part.in_fragment && predicate(*part.in_fragment)) ||
           (part.in_geometry && predicate(*part.in_geometry));
  });
}

}  // namespace

std::string_view plug_name(std::string_view function_name) {
  constexpr std::string_view kPrefix = "PLUG_";
  return function_name.starts_with(kPrefix) ? function_name.substr(kPrefix.size()) : std::string_view();
}

std::string_view CodeUnit::written_name(std::string_view name) const {
  const auto found = std::find_if(renamed_names.begin(), renamed_names.end(), [&](const RenamedName& r) { return r.renamed == name; });
  return found == renamed_names.end() ? name : std::string_view(found->written);
}

std::shared_ptr<const CodeUnit> make_code_unit(const MappedText& text, ShaderStage stage) {
  auto unit = std::make_shared<CodeUnit>();
  UpgradedText upgraded = upgrade(text, stage, {});
  unit->text = std::move(upgraded.text);
  unit->castle_names = std::move(upgraded.used_names);
  unit->renamed_names = std::move(upgraded.renamed_names);
  unit->tokens = tokenize(unit->text.text(), {});
  unit->outline = outline(unit->text.text(), unit->tokens, varying_storage(stage));
  return unit;
}

bool EffectCode::fills(std::string_view plug) const {
  return any_unit(*this, [&](const CodeUnit& unit) {
    return std::any_of(unit.outline.functions.begin(), unit.outline.functions.end(), [&](const FunctionOutline& function) {
      return function.is_definition() && plug_name(function.name) == plug;
    });
  });
}

bool EffectCode::uses(std::string_view castle_name) const {
  return any_unit(*this, [&](const CodeUnit& unit) {
    return std::find(unit.castle_names.begin(), unit.castle_names.end(), castle_name) != unit.castle_names.end();
  });
}

EffectCode make_effect_code(const SceneEffect& effect, Diagnostics& diagnostics) {
  EffectCode code;
  std::vector<NodeId> seen;
  for (const ShaderSource& source : effect.parts) {
    if (std::find(seen.begin(), seen.end(), source.node) != seen.end()) continue;
    seen.push_back(source.node);
    EffectCode::Part part;
    part.stage = source.stage;
    const bool light = source.stage == PartStage::light;
    if (light || source.stage == PartStage::vertex) part.in_vertex = make_code_unit(source.text, ShaderStage::vertex);
    if (light || source.stage == PartStage::fragment) part.in_fragment = make_code_unit(source.text, ShaderStage::fragment);
    if (source.stage == PartStage::geometry) part.in_geometry = make_code_unit(source.text, ShaderStage::geometry);
    for (const auto& unit : {part.in_vertex, part.in_fragment, part.in_geometry}) {
      if (unit) report_problems(*unit, diagnostics);
    }
    code.parts.push_back(std::move(part));
  }
  return code;
}

}  // namespace plugc
