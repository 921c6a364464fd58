// Two candidates are an error, as nothing says which is meant. What no outline shows (a macro may define functions) is left to
// the compiler.

#include "compose/bind_functions.h"

#include <algorithm>

#include <fmt/format.h>

#include "compose/name_use.h"

namespace plugc {
namespace {

/// Whether a macro of the unit may define functions that no outline shows: one that opens a body does.
bool macros_define_functions(const CodeUnit& code) {
  const auto& macros = code.outline.macros;
  return std::any_of(macros.begin(), macros.end(), [&](const MacroOutline& macro) {
    return std::string_view(code.text.text()).substr(macro.body_begin, macro.end - macro.body_begin).find('{') !=
           std::string_view::npos;
  });
}

}  // namespace

void FunctionBinder::index_definitions() {
  if (!definitions_.empty()) return;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.dropped) continue;
    for (const FunctionOutline& function : unit.code->outline.functions) {
      if (function.is_definition()) definitions_[{unit.stage, function.name}].push_back({unit.owner, &function});
    }
  }
}

/// A function that nobody defines and nobody calls must not meet another owner's name either, unless an overload of it has
/// been found there.
void FunctionBinder::step_aside(const PlacedUnit& unit, std::string_view name) {
  auto& borrowed = c_.owners[unit.owner].borrowed[static_cast<std::size_t>(unit.stage)];
  if (borrowed.contains(name) || c_.taken.is_free(c_.final_name(unit, name), in_stage(unit.stage), unit.owner)) return;
  borrowed.insert_or_assign(name, c_.taken.new_name(name, unit.owner, c_.units));
}

/// Another effect's function of that name with other parameters, else code that is not understood.
std::vector<RelatedPlace> FunctionBinder::undefined_causes(const PlacedUnit& unit, const FunctionOutline& prototype) const {
  for (const PlacedUnit& other : c_.units) {
    for (const FunctionOutline& function : other.code->outline.functions) {
      const bool same_name = other.stage == unit.stage && function.is_definition() && function.name == prototype.name;
      if (same_name) return {{name_span(*other.code, function.name, function.name_begin), "it has other parameters here"}};
    }
  }
  return doubtful_places(c_.input, unit.stage, prototype.name);
}

/// Those that define the function in the unit's stage.
std::set<std::size_t> FunctionBinder::definers(const PlacedUnit& unit, const FunctionOutline& prototype) {
  index_definitions();
  std::set<std::size_t> owners;
  for (const Definition& definition : definitions_[{unit.stage, prototype.name}]) {
    if (same_parameters(*definition.function, prototype)) owners.insert(definition.owner);
  }
  return owners;
}

void FunctionBinder::bind_prototype(const PlacedUnit& unit, const FunctionOutline& prototype) {
  const std::set<std::size_t> all = definers(unit, prototype);
  if (all.contains(unit.owner)) return;
  const std::set<std::size_t> candidates = one_for_each_author(c_, all);
  if (candidates.empty()) return note_undefined(unit, prototype);
  if (candidates.size() > 1) {
    return c_.report_fault(
        DiagnosticId::ambiguous_function, unit, prototype.name, prototype.name_begin,
        fmt::format("`{}` is declared here and defined by {} other effects; define it in one, or in this one", prototype.name,
                    candidates.size()));
  }
  if (is_used(*unit.code, prototype.name, prototype.name_begin))
    c_.note_need(unit, *candidates.begin(), NeedKind::function, prototype.name);
  borrowings_.push_back({static_cast<std::size_t>(&unit - c_.units.data()), &prototype, *candidates.begin()});
}

void FunctionBinder::note_undefined(const PlacedUnit& unit, const FunctionOutline& prototype) {
  if (macros_define_functions(*unit.code)) return;
  if (!is_used(*unit.code, prototype.name, prototype.name_begin)) {
    idle_.emplace_back(&unit, prototype.name);
    return;
  }
  c_.report_fault(DiagnosticId::shader_invalid, unit, prototype.name, prototype.name_begin,
                  fmt::format("`{}` is declared and called, but nothing defines it in the {} stage of this shape",
                              prototype.name, to_text(unit.stage)),
                  undefined_causes(unit, prototype));
}

void FunctionBinder::bind(const PlacedUnit& unit) {
  for (const FunctionOutline& function : unit.code->outline.functions) {
    if (!function.is_definition()) bind_prototype(unit, function);
  }
}

void FunctionBinder::finish() {
  borrow_functions(c_, borrowings_);
  for (const auto& [unit, name] : idle_) step_aside(*unit, name);
}

}  // namespace plugc
