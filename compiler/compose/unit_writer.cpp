// The steps collect edits of the unit's text (unit_edits.h), which are applied when all are known. Removals come first, as
// nothing else is edited inside of them.

#include "compose/unit_writer.h"

#include <set>

#include <fmt/format.h>

namespace plugc {
namespace {

/// Macros end with their part.
void end_macros(UnitDraft& draft) {
  const auto& macros = draft.code.outline.macros;
  if (macros.empty()) return;
  std::set<std::string_view> names;
  for (const MacroOutline& macro : macros) names.insert(macro.name);
  std::string text = "\n";
  for (const std::string_view name : names) text += fmt::format("#undef {}\n", draft.final_name(name));
  draft.edits.insert(draft.code.text.size(), std::move(text));
}

}  // namespace

void write_unit(Composition& composition, const PlacedUnit& unit, Declared& declared, MappedText& stage) {
  UnitDraft draft(composition, unit);
  write_declarations(draft, declared);
  write_calls(draft);
  write_names(draft);
  end_macros(draft);
  append_edited(draft.code.text, draft.edits.take(), stage);
  if (stage.text().back() != '\n') stage.append_generated("\n");
}

}  // namespace plugc
