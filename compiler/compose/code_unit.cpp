// Texts are upgraded first, so that everything behind this file sees one dialect; then tokens and outline are taken from
// the upgraded text, whose map still leads to the author.

#include "compose/code_unit.h"

#include <algorithm>
#include <set>
#include <span>

#include <fmt/format.h>

#include "base/limits.h"
#include "compose/plug_signature.h"
#include "compose/varying_passthrough.h"
#include "glsl/scan.h"
#include "glsl/shader_size.h"

namespace plugc {
namespace {

Storage varying_storage(ShaderStage stage) {
  return stage == ShaderStage::vertex ? Storage::out : Storage::in;
}

void report_problem(const CodeUnit& unit, const OutlineProblem& problem, Diagnostics& diagnostics) {
  std::vector<RelatedPlace> related;
  if (!problem.cause_message.empty())
    related.push_back({unit.span(problem.cause.begin, problem.cause.end), problem.cause_message});
  diagnostics.report(DiagnosticId::shader_syntax, unit.span(problem.begin, problem.end), problem.message, std::move(related));
}

/// Of what can never be valid the first is said, as others may only be due to it.
void take_problems(const CodeUnit& unit, EffectCode& code, Diagnostics& diagnostics) {
  if (unit.tokens.too_many) {
    code.broken = true;
    return diagnostics.report(
        DiagnosticId::shader_limit, unit.span(0, 1),
        fmt::format("this part has more than {} tokens, which is more than plugc takes", kMaxShaderTokens));
  }
  if (const auto problem = find_size_problem(unit.text.text(), unit.tokens)) {
    code.broken = true;
    return diagnostics.report(DiagnosticId::shader_limit, unit.span(problem->begin, problem->end), problem->message);
  }
  for (const Span& place : unit.merged_directions) {
    diagnostics.report(DiagnosticId::parameter_direction, place,
                       "a parameter has one of `in`, `out` and `inout`; other compilers refuse several");
  }
  bool broken = false;
  for (const OutlineProblem& problem : unit.outline.problems) {
    const bool fatal = problem.kind == ProblemKind::fatal;
    if (problem.kind == ProblemKind::doubtful)
      code.doubts.push_back({unit.span(problem.begin, problem.end), problem.message});
    else if (!fatal || !broken)
      report_problem(unit, problem, diagnostics);
    broken = broken || fatal;
  }
  code.broken = code.broken || broken;
}

constexpr std::string_view kGeometryQuestion = "HAS_GEOMETRY_SHADER";
constexpr std::string_view kEsslQuestions[] = {"GL_ES", "__VERSION__"};

EffectCode::Part make_part(const ShaderSource& source, Target target) {
  EffectCode::Part part;
  part.stage = source.stage;
  const auto make = [&](ShaderStage stage) { return make_code_unit(source.text, stage, target); };
  const bool light = source.stage == PartStage::light;
  if (light || source.stage == PartStage::vertex) part.in_vertex = make(ShaderStage::vertex);
  if (light || source.stage == PartStage::fragment) part.in_fragment = make(ShaderStage::fragment);
  if (source.stage == PartStage::geometry) part.in_geometry = make(ShaderStage::geometry);
  if (part.in_fragment && source.text.text().find(kGeometryQuestion) != std::string::npos)
    part.behind_geometry = make_code_unit(source.text, ShaderStage::fragment, target, true);
  return part;
}

std::unordered_map<std::string_view, std::string_view> find_macro_words(const CodeUnit& unit) {
  std::unordered_map<std::string_view, std::string_view> words;
  for (const MacroOutline& macro : unit.outline.macros) {
    const std::size_t name_end = macro.name_begin + macro.name.size();
    if (unit.text.text().substr(name_end, 1) == "(") continue;  // it has parameters
    const std::vector<Token> body = scan_range(unit.text.text(), macro.body_begin, macro.end);
    if (body.size() == 1 && body.front().kind == TokenKind::identifier) words.try_emplace(macro.name, unit.at(body.front()));
  }
  return words;
}

bool asks_for_essl(const ShaderSource& source) {
  return std::any_of(std::begin(kEsslQuestions), std::end(kEsslQuestions),
                     [&](std::string_view name) { return source.text.text().find(name) != std::string::npos; });
}

/// An empty part must leave no trace.
bool has_no_code(const EffectCode::Part& part) {
  const auto is_blank = [](const std::shared_ptr<const CodeUnit>& unit) { return !unit || unit->tokens.tokens.empty(); };
  return is_blank(part.in_vertex) && is_blank(part.in_fragment) && is_blank(part.in_geometry);
}

bool says_discard(const CodeUnit& unit) {
  return std::ranges::any_of(unit.tokens.tokens, [&](const Token& token) {
    return token.kind == TokenKind::directive ? unit.at(token).find("discard") != std::string_view::npos
                                              : unit.at(token) == "discard";
  });
}

void sort_unique(std::vector<std::string>& names) {
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

void note_names(const CodeUnit& unit, EffectCode& code) {
  code.castle_names.insert(code.castle_names.end(), unit.castle_names.begin(), unit.castle_names.end());
  for (const FunctionOutline& function : unit.outline.functions) {
    const std::string_view plug = plug_name(function.name);
    if (!plug.empty() && function.is_definition()) code.plugs.emplace_back(plug);
    code.moves_vertices = code.moves_vertices || moves_vertices(function);
  }
}

}  // namespace

std::string_view plug_name(std::string_view function_name) {
  constexpr std::string_view kPrefix = "PLUG_";
  return function_name.starts_with(kPrefix) ? function_name.substr(kPrefix.size()) : std::string_view();
}

std::string_view CodeUnit::written_name(std::string_view name) const {
  const auto found =
      std::find_if(renamed_names.begin(), renamed_names.end(), [&](const RenamedName& r) { return r.renamed == name; });
  return found == renamed_names.end() ? name : std::string_view(found->written);
}

std::string_view CodeUnit::macro_word(std::string_view name) const {
  const auto found = macro_words.find(name);
  return found == macro_words.end() ? name : found->second;
}

std::string_view CodeUnit::declared_name(const GlobalOutline& global) const {
  if (!macro_words.contains(global.name)) return global.name;
  const auto in_front = [&](const auto& range) { return range.end <= global.name_begin; };
  const auto& macros = outline.macros;
  const auto macro = std::find_if(macros.rbegin(), macros.rend(),
                                  [&](const MacroOutline& each) { return each.name == global.name && in_front(each); });
  if (macro == macros.rend()) return global.name;
  const bool ended = std::ranges::any_of(outline.undefs, [&](const TextRange& undef) {
    return in_front(undef) && undef.begin > macro->begin &&
           text.text().substr(undef.begin, undef.end - undef.begin).ends_with(global.name);
  });
  return ended ? global.name : macro_word(global.name);
}

void note_plugs(CodeUnit& unit) {
  std::unordered_map<std::string_view, std::size_t> first;  // of each name: into plug_functions
  for (std::size_t f = 0; f < unit.outline.functions.size(); ++f) {
    const FunctionOutline& function = unit.outline.functions[f];
    const std::string_view plug = plug_name(function.name);
    if (plug.empty() || !function.is_definition()) continue;
    const auto [known, added] = first.try_emplace(plug, unit.plug_functions.size());
    if (!added) unit.plug_functions[known->second].overloaded = true;
    unit.plug_functions.push_back({f, plug, !added});
  }
  for (const Token& token : unit.tokens.tokens) {
    if (token.kind == TokenKind::identifier && !plug_name(unit.at(token)).empty()) unit.plug_words.push_back(token);
  }
}

const FunctionOutline* find_main(const CodeUnit& unit) {
  const auto& functions = unit.outline.functions;
  const auto found = std::find_if(functions.begin(), functions.end(), [](const FunctionOutline& function) {
    return function.name == "main" && function.is_definition();
  });
  return found == functions.end() ? nullptr : &*found;
}

std::shared_ptr<const CodeUnit> make_code_unit(const MappedText& text, ShaderStage stage, Target target, bool behind_geometry) {
  static const std::vector<MacroDefinition> kNone, kEssl = {{"GL_ES", "1"}, {"__VERSION__", "300"}},
                                                   kBehind = {{std::string(kGeometryQuestion), "1"}};
  const auto& predefined = target == Target::essl300 ? kEssl : behind_geometry ? kBehind : kNone;
  auto unit = std::make_shared<CodeUnit>();
  UpgradedText upgraded = upgrade(text, stage, predefined);
  unit->text = std::move(upgraded.text);
  unit->castle_names = std::move(upgraded.used_names);
  unit->renamed_names = std::move(upgraded.renamed_names);
  unit->merged_directions = std::move(upgraded.merged_directions);
  unit->names_precision = names_precision(unit->text.text());
  unit->tokens = tokenize(unit->text.text(), predefined);
  unit->outline = outline(unit->text.text(), unit->tokens, varying_storage(stage));
  unit->macro_words = find_macro_words(*unit);
  note_plugs(*unit);
  return unit;
}

bool EffectCode::fills(std::string_view plug) const {
  return std::binary_search(plugs.begin(), plugs.end(), plug);
}

bool EffectCode::uses(std::string_view castle_name) const {
  return std::binary_search(castle_names.begin(), castle_names.end(), castle_name);
}

EffectCode make_effect_code(const SceneEffect& effect, Diagnostics& diagnostics) {
  EffectCode code;
  std::set<NodeId> seen;
  for (const ShaderSource& source : effect.parts) {
    if (!seen.insert(source.node).second) continue;
    EffectCode::Part part = make_part(source, Target::glsl330);
    if (asks_for_essl(source)) part.for_essl = std::make_shared<const EffectCode::Part>(make_part(source, Target::essl300));
    bool too_large = false;
    for (const auto& [unit, stage] :
         {std::pair(part.in_vertex, ShaderStage::vertex), std::pair(part.in_fragment, ShaderStage::fragment),
          std::pair(part.in_geometry, ShaderStage::geometry)}) {
      if (!unit) continue;
      take_problems(*unit, code, diagnostics);
      code.has_problems = code.has_problems || !unit->outline.problems.empty() || unit->tokens.too_many;
      if (source.stage != PartStage::light) check_passthrough_markers(*unit, stage, diagnostics);
      too_large = too_large || unit->tokens.too_many;
      if (!too_large) note_names(*unit, code);
    }
    if (too_large || has_no_code(part)) continue;
    if (part.behind_geometry) note_names(*part.behind_geometry, code);
    for (const auto& unit : {part.in_fragment, part.behind_geometry})
      code.discards = code.discards || (source.stage == PartStage::fragment && unit && says_discard(*unit));
    code.has_geometry_main = code.has_geometry_main || (part.in_geometry && find_main(*part.in_geometry) != nullptr);
    code.parts.push_back(std::move(part));
  }
  sort_unique(code.plugs);
  sort_unique(code.castle_names);
  return code;
}

}  // namespace plugc
