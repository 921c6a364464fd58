// A declaration counts by its final name: the first of a stage stays, an equal one goes, an unequal one is reported and goes.
// Of several variables that are declared together only the new ones are written again.

#include <algorithm>

#include <fmt/format.h>

#include "compose/geometry_layout.h"
#include "compose/output_locations.h"
#include "compose/precision.h"
#include "compose/struct_text.h"
#include "compose/unit_draft.h"

namespace plugc {
namespace {

/// A uniform's initialiser is no part of its type.
bool has_constant(const GlobalOutline& global) {
  return global.storage != Storage::uniform && global.initializer_begin < global.initializer_end;
}

class DeclarationWriter {
 public:
  DeclarationWriter(UnitDraft& draft, Declared& declared) : draft_(draft), declared_(declared) {}
  void write();

 private:
  using Declarators = std::span<const GlobalOutline>;
  struct Earlier {
    const PlacedUnit* unit = nullptr;
    std::string_view name;
    std::uint32_t name_begin = 0;
  };

  void remove_hoisted();
  void write_globals(Declarators declarators);
  bool is_repeated(const GlobalOutline& global);
  bool is_equal(const Declared::Global& now, const Declared::Global& before) const;
  void write_struct(const StructOutline& type);
  void report_unequal(std::string_view name, std::uint32_t begin, std::string_view type, const Earlier& before);
  void write_new_ones(Declarators declarators, const std::vector<bool>& repeated);
  std::string declarator_text(const GlobalOutline& global) const;
  bool loses_initializer(const GlobalOutline& global) const;
  void remove_initializer(const GlobalOutline& global);
  void write_precision(const GlobalOutline& global);
  void write_locations(Declarators declarators);

  UnitDraft& draft_;
  Declared& declared_;
};

/// `#version`, `#extension`, precision statements, a `;` that ends nothing, and a geometry shader's input: the head of the
/// stage has them.
void DeclarationWriter::remove_hoisted() {
  const Outline& outline = draft_.code.outline;
  const auto remove = [&](const auto& range) { draft_.edits.remove_lines(range.begin, range.end); };
  if (outline.version.end > outline.version.begin) remove(outline.version);
  std::ranges::for_each(outline.extensions, remove);
  std::ranges::for_each(outline.precisions, remove);
  std::ranges::for_each(outline.empties, remove);
  if (draft_.unit.stage != ShaderStage::geometry) return;
  const auto input = find_input_layout(draft_.code);
  if (input && input->alone) remove(input->range);
}

bool DeclarationWriter::is_equal(const Declared::Global& now, const Declared::Global& before) const {
  if (now.storage != before.storage || now.type != before.type || now.array != before.array) return false;
  const bool constant = has_constant(*now.global);
  const bool constant_before = before.global != nullptr && has_constant(*before.global);
  if (!constant || !constant_before) return constant == constant_before;
  return token_line(draft_.code, now.global->initializer_begin, now.global->initializer_end) ==
         token_line(*before.unit->code, before.global->initializer_begin, before.global->initializer_end);
}

/// Whether an earlier unit (or an earlier line) of the stage has made this declaration; if not, it is noted as made.
bool DeclarationWriter::is_repeated(const GlobalOutline& global) {
  // the arrays of a geometry stage's inputs have all one size, whether or not it is written
  const bool sized_by_layout = draft_.unit.stage == ShaderStage::geometry && global.storage == Storage::in;
  const Declared::Global now = {global.storage, global.type, sized_by_layout ? std::string_view() : global.array, &draft_.unit,
                                &global};
  const auto [found, added] = declared_.globals.try_emplace(draft_.final_name(draft_.code.declared_name(global)), now);
  if (added) return false;
  const Declared::Global& before = found->second;
  if (is_equal(now, before)) return true;
  Earlier place;
  if (before.unit != nullptr) place = {before.unit, before.global->name, before.global->name_begin};
  report_unequal(global.name, global.name_begin, fmt::format("{}{}", global.type, global.array), place);
  return true;
}

void DeclarationWriter::report_unequal(std::string_view name, std::uint32_t begin, std::string_view type,
                                       const Earlier& before) {
  Composition& c = draft_.composition;
  // what another effect has borrowed fits what this one writes: it contradicts itself, which has been said
  const std::size_t other_owner = before.unit == nullptr ? 0 : before.unit->owner;
  if (other_owner != draft_.unit.owner && c.is_faulty(draft_.unit)) return;
  std::vector<RelatedPlace> related;
  const Span other = before.unit == nullptr ? Span{} : name_span(*before.unit->code, before.name, before.name_begin);
  if (other.valid()) related.push_back({other, "the other declaration"});
  c.diagnostics.report(DiagnosticId::unequal_declarations, name_span(draft_.code, name, begin),
                       fmt::format("`{}` is declared here as `{}`, and differently before", name, type), std::move(related));
  c.mark_faulty(draft_.unit);
}

/// ESSL 3.00 knows no initialised uniforms; their values come from the package.
bool DeclarationWriter::loses_initializer(const GlobalOutline& global) const {
  return draft_.composition.target == Target::essl300 && global.storage == Storage::uniform &&
         global.initializer_begin < global.initializer_end;
}

std::string DeclarationWriter::declarator_text(const GlobalOutline& global) const {
  std::string_view code = draft_.text.substr(global.declarator_begin, global.declarator_end - global.declarator_begin);
  if (loses_initializer(global)) code = code.substr(0, code.find('='));
  return renamed(draft_, code);
}

/// `uniform float a, b;` of which only `b` is new becomes `uniform float b;`.
void DeclarationWriter::write_new_ones(Declarators declarators, const std::vector<bool>& repeated) {
  const GlobalOutline& first = declarators.front();
  std::string code = renamed(draft_, draft_.text.substr(first.begin, first.declarator_begin - first.begin));
  bool any = false;
  for (std::size_t i = 0; i < declarators.size(); ++i) {
    if (repeated[i]) continue;
    code += (any ? ", " : "") + declarator_text(declarators[i]);
    any = true;
  }
  draft_.edits.replace(first.begin, first.end, code + ";");
}

void DeclarationWriter::remove_initializer(const GlobalOutline& global) {
  if (!loses_initializer(global) || draft_.edits.is_removed(global.begin)) return;
  const std::size_t equals = draft_.text.rfind('=', global.initializer_begin);
  if (equals != std::string_view::npos) draft_.edits.replace(static_cast<std::uint32_t>(equals), global.initializer_end, "");
}

/// The precision that all stages have for a uniform.
void DeclarationWriter::write_precision(const GlobalOutline& global) {
  const auto& precisions = draft_.composition.precisions;
  if (precisions.empty() || global.storage != Storage::uniform || draft_.edits.is_removed(global.begin)) return;
  const auto wanted = precisions.find(draft_.final_name(global.name));
  const auto word = precision_word(draft_.code, global);
  if (wanted != precisions.end() && word && draft_.code.at(*word) != wanted->second)
    draft_.edits.replace(word->begin, word->end, std::string(wanted->second));
}

/// Several outputs that are declared together get a declaration each, as each has a place of its own.
void DeclarationWriter::write_locations(Declarators declarators) {
  const GlobalOutline& first = declarators.front();
  const Composition& c = draft_.composition;
  const bool is_output = draft_.unit.stage == ShaderStage::fragment && first.storage == Storage::out;
  if (c.output_locations.empty() || !is_output || draft_.edits.is_removed(first.begin)) return;
  const auto location = [&](const GlobalOutline& global) { return location_text(c, draft_.final_name(global.name)); };
  if (declarators.size() == 1) return draft_.edits.insert(first.begin, location(first));
  const std::string qualified = renamed(draft_, draft_.text.substr(first.begin, first.declarator_begin - first.begin));
  std::string code;
  for (const GlobalOutline& each : declarators)
    code += (code.empty() ? "" : " ") + location(each) + qualified + declarator_text(each) + ";";
  draft_.edits.replace(first.begin, first.end, std::move(code));
}

/// The variables of one declaration.
void DeclarationWriter::write_globals(Declarators declarators) {
  const GlobalOutline& first = declarators.front();
  if (declarators.size() == 1) {
    if (is_repeated(first)) draft_.edits.remove_lines(first.begin, first.end);
  } else {
    std::vector<bool> repeated;
    for (const GlobalOutline& each : declarators) repeated.push_back(is_repeated(each));
    const auto count = std::ranges::count(repeated, true);
    if (count == std::ssize(declarators)) {
      draft_.edits.remove_lines(first.begin, first.end);
    } else if (count > 0) {
      write_new_ones(declarators, repeated);
    }
  }
  for (const GlobalOutline& each : declarators) remove_initializer(each);
  write_precision(first);
  write_locations(declarators);
}

/// A repeated `struct S {...};` goes; of a repeated `struct S {...} a;` the variable's type stays.
void DeclarationWriter::write_struct(const StructOutline& type) {
  if (type.storage != Storage::none || type.name.empty()) return;
  const std::string_view name = draft_.final_name(type.name);
  const auto [found, added] = declared_.structs.try_emplace(name, Declared::Struct{&draft_.unit, &type});
  if (added) return;
  const Declared::Struct& before = found->second;
  if (struct_text(*before.unit->code, *before.type) != struct_text(draft_.code, type))
    report_unequal(type.name, type.name_begin, "struct", {before.unit, before.type->name, before.type->name_begin});
  const bool alone = type.end > 0 && draft_.text[type.end - 1] == ';';
  alone ? draft_.edits.remove_lines(type.begin, type.end) : draft_.edits.replace(type.begin, type.end, std::string(name));
}

void DeclarationWriter::write() {
  remove_hoisted();
  const Declarators globals = draft_.code.outline.globals;
  for (std::size_t i = 0; i < globals.size();) {
    const std::size_t count = std::clamp<std::size_t>(globals[i].declarator_count, 1, globals.size() - i);
    write_globals(globals.subspan(i, count));
    i += count;
  }
  for (const StructOutline& type : draft_.code.outline.structs) write_struct(type);
}

}  // namespace

void write_declarations(UnitDraft& draft, Declared& declared) {
  DeclarationWriter(draft, declared).write();
}

}  // namespace plugc
