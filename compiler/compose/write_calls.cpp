// Each call comes from the plug function that it calls: a message about it is told there.

#include <algorithm>
#include <set>

#include "compose/prototype_text.h"
#include "compose/unit_draft.h"

namespace plugc {
namespace {

/// The blanks that a line starts with.
std::string_view indent_at(std::string_view text, std::uint32_t offset) {
  const std::size_t line = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
  const std::size_t end = text.find_first_not_of(" \t", line);
  return text.substr(line, std::min<std::size_t>(end, offset) - line);
}

Span call_origin(const Composition& composition, const PlugCall& call) {
  const CodeUnit& code = *composition.units[call.unit].code;
  const FunctionOutline& function = code.outline.functions[call.function];
  return name_span(code, function.name, function.name_begin);
}

/// `if (plugc_on_0 && plugc_on_1) ` in front of a call that is not always made.
void append_condition(const Composition& composition, const PlugCall& call, std::string& text) {
  const char* before = "if (";
  for (const std::size_t guard : call.guards) {
    text.append(before).append(composition.result.switches[guard].name);
    before = " && ";
  }
  if (!call.guards.empty()) text += ") ";
}

void append_call(const Composition& composition, const PlugCall& call, std::string_view arguments, std::string& text) {
  append_condition(composition, call, text);
  const std::string_view name = composition.units[call.unit].function_names[call.function];
  text.append(name).append(1, '(').append(arguments).append(call.rgb_only ? ".rgb);" : ");");
}

void write_marker_calls(UnitDraft& draft, const MarkerOutline& marker, const std::vector<PlugCall>& calls) {
  const bool in_braces = marker.is_sole_statement;
  const std::string arguments = renamed(draft, marker.arguments);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    std::string text;
    if (i > 0) {
      text.append(1, '\n').append(indent_at(draft.text, marker.begin));
    } else if (in_braces) {
      text = "{ ";
    }
    append_call(draft.composition, calls[i], arguments, text);
    if (in_braces && i + 1 == calls.size()) text += " }";
    draft.edits.insert(marker.begin, std::move(text), call_origin(draft.composition, calls[i]));
  }
  draft.edits.replace(marker.begin, marker.end, calls.empty() ? "{}" : "");
}

void write_markers(UnitDraft& draft) {
  const auto& markers = draft.code.outline.markers;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const MarkerOutline& marker = markers[m];
    if (draft.edits.is_removed(marker.begin)) continue;
    const auto& calls = draft.unit.calls[m];
    const bool stays = marker.kind == MarkerKind::plug && (!calls.empty() || marker.is_sole_statement);
    stays ? write_marker_calls(draft, marker, calls) : draft.edits.remove_lines(marker.begin, marker.end);
  }
}

/// In front of the first function; types that the prototypes name are declared by then.
std::uint32_t place_of_prototypes(const UnitDraft& draft) {
  const Outline& outline = draft.code.outline;
  const auto marked = std::ranges::find(outline.markers, MarkerKind::declarations, &MarkerOutline::kind);
  const std::uint32_t place = marked != outline.markers.end() ? marked->begin
                              : outline.functions.empty()     ? draft.code.text.size()
                                                              : outline.functions.front().begin;
  const TextRange* removed = draft.edits.removed_at(place);
  return removed == nullptr ? place : removed->begin;
}

void write_prototypes(UnitDraft& draft) {
  const std::uint32_t place = place_of_prototypes(draft);
  std::set<std::pair<std::size_t, std::size_t>> written;
  for (const std::vector<PlugCall>& calls : draft.unit.calls) {
    for (const PlugCall& call : calls) {
      if (written.emplace(call.unit, call.function).second)
        draft.edits.insert(place, plug_prototype(draft.composition, call), call_origin(draft.composition, call));
    }
  }
}

void write_forwards(UnitDraft& draft) {
  for (const auto& [index, target] : draft.unit.forwards) {
    const FunctionOutline& function = draft.code.outline.functions[index];
    draft.edits.insert(function.end, forwarding_text(draft.composition, draft.unit, function, target),
                       name_span(draft.code, function.name, function.name_begin));
  }
}

}  // namespace

void write_calls(UnitDraft& draft) {
  write_markers(draft);
  write_prototypes(draft);
  write_forwards(draft);
}

}  // namespace plugc
