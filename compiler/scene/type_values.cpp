// Text is read by the readers that the graph builder uses too, but what they report is dropped: a text with a mistake stays
// text, so that whoever reads the written file is told of it again.

#include "scene/type_values.h"

#include <algorithm>

#include "document/read_lexical.h"

namespace plugc {
namespace {

constexpr std::string_view kBlank = " \t\r\n,";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
}

bool is_boolean(FieldType type) {
  return type == FieldType::SFBool || type == FieldType::MFBool;
}

void keep_as_text(ValueSyntax& value) {
  value.kind = ValueKind::strings;
  value.bracketed = false;
}

/// False when the text holds anything else, or nothing.
bool read_numbers(Document& document, ValueSyntax& value, ValueKind kind) {
  const SourceSet no_sources;
  Diagnostics mistakes(no_sources);
  const MappedText text = document.of(value.strings()).front();
  const LexicalKind words = kind == ValueKind::booleans ? LexicalKind::booleans : LexicalKind::numbers;
  const auto [numbers, damaged, cut] = read_lexical_numbers(text, words, mistakes);
  if (damaged || cut || !mistakes.all().empty() || numbers.empty()) return false;
  value.kind = kind;
  value.hold(Range<double>{static_cast<std::uint32_t>(document.numbers.size()), static_cast<std::uint32_t>(numbers.size())});
  document.numbers.insert(document.numbers.end(), numbers.begin(), numbers.end());
  return true;
}

void read_strings(Document& document, ValueSyntax& value) {
  const SourceSet no_sources;
  Diagnostics mistakes(no_sources);
  const MappedText text = document.of(value.strings()).front();
  std::vector<MappedText> strings = read_lexical_strings(text, mistakes);
  value.kind = strings.empty() ? ValueKind::empty : ValueKind::strings;
  value.hold(
      Range<MappedText>{static_cast<std::uint32_t>(document.strings.size()), static_cast<std::uint32_t>(strings.size())});
  std::move(strings.begin(), strings.end(), std::back_inserter(document.strings));
  value.bracketed = true;
}

void guess(Document& document, ValueSyntax& value, std::string_view text) {
  if (document.encoding != Encoding::xml || text.empty()) return keep_as_text(value);
  if (text.front() == '"') return read_strings(document, value);
  const bool is_word = std::string_view("tTfF").find(text.front()) != std::string_view::npos;
  if (!read_numbers(document, value, is_word ? ValueKind::booleans : ValueKind::numbers)) keep_as_text(value);
}

void read_text(Document& document, ValueSyntax& value, FieldType type) {
  const std::string text(trimmed(document.of(value.strings()).front().text()));
  if (type == FieldType::unknown) return guess(document, value, text);
  if (type == FieldType::MFString) return read_strings(document, value);
  if (text.empty() && is_multiple(type)) {
    value.kind = ValueKind::empty;
  } else if (is_node(type) && text == "NULL") {
    value.kind = ValueKind::nodes;
  } else if (!is_numeric(type) || !read_numbers(document, value, is_boolean(type) ? ValueKind::booleans : ValueKind::numbers)) {
    return keep_as_text(value);
  }
  if (!value.holds_numbers()) value.count = 0;
}

}  // namespace

void type_value(Document& document, ValueSyntax& value, FieldType type) {
  if (value.kind == ValueKind::lexical && value.count > 0) read_text(document, value, type);
  value.components = static_cast<std::uint8_t>(component_count(type));
  if (type == FieldType::unknown || value.kind == ValueKind::none || value.kind == ValueKind::is) return;
  if (value.count == 0 && is_multiple(type)) value.kind = is_node(type) ? ValueKind::nodes : ValueKind::empty;
  const bool several_are_no_single = value.count > 1 && (value.kind == ValueKind::strings || value.kind == ValueKind::nodes);
  value.bracketed = is_multiple(type) || value.kind == ValueKind::empty || several_are_no_single;
}

}  // namespace plugc
