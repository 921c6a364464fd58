// The table's default texts are parsed once into one list that runs beside field_table(). They are plugc's own words, so the
// reading here is simple: numbers and `true` or `false` between blanks, one string as it stands, several in quotes.

#include "scene/default_values.h"

#include <cstdlib>

#include "base/check.h"

namespace plugc {
namespace {

struct DefaultValue {
  std::vector<double> numbers;
  std::vector<MappedText> strings;
  FieldValue value;
};

std::vector<double> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const std::size_t end = text.find(' ');
    const std::string word(text.substr(0, end));
    if (!word.empty()) numbers.push_back(word == "true" ? 1 : std::strtod(word.c_str(), nullptr));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return numbers;
}

MappedText generated(std::string_view text) {
  MappedText mapped;
  mapped.append_generated(text);
  return mapped;
}

/// `"EXAMINE" "ANY"` to two strings.
std::vector<MappedText> parse_quoted(std::string_view text) {
  std::vector<MappedText> strings;
  for (std::size_t open = text.find('"'); open != std::string_view::npos;) {
    const std::size_t close = text.find('"', open + 1);
    PLUGC_CHECK(close != std::string_view::npos, "a default's quotes come in pairs");
    strings.push_back(generated(text.substr(open + 1, close - open - 1)));
    open = text.find('"', close + 1);
  }
  return strings;
}

/// Elements of SF types are there even when the table has no default (an output).
void complete(std::vector<double>& numbers, FieldType type) {
  if (is_multiple(type)) return;
  numbers.resize(type == FieldType::SFImage ? 3 : component_count(type));
}

void parse(const FieldInfo& field, DefaultValue& into) {
  into.value.type = field.type;
  if (field.type == FieldType::SFString) {
    into.strings.push_back(generated(field.default_text));
  } else if (field.type == FieldType::MFString) {
    into.strings = parse_quoted(field.default_text);
  } else if (is_numeric(field.type)) {
    into.numbers = parse_numbers(field.default_text);
    complete(into.numbers, field.type);
  }
  into.value.numbers = into.numbers;
  into.value.strings = into.strings;
}

std::vector<DefaultValue> parse_all() {
  const std::span<const FieldInfo> fields = field_table();
  std::vector<DefaultValue> defaults(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) parse(fields[i], defaults[i]);
  return defaults;
}

}  // namespace

const FieldValue& default_value(const FieldInfo& field) {
  static const std::vector<DefaultValue> defaults = parse_all();
  const auto index = static_cast<std::size_t>(&field - field_table().data());
  PLUGC_CHECK(index < defaults.size(), "a field of the table");
  return defaults[index].value;
}

}  // namespace plugc
