// A value is taken by what it looks like: numbers, booleans and lists of strings say what they are. One plain string is kept
// as text that the scene room reads by the field's type, as it does with an XML attribute: `"@value": "0.5"` may be a number.
// The first item of a list decides what the list holds; an item of another kind is reported and left out.

#include <utility>

#include <fmt/format.h>

#include "document/json_reader.h"

namespace plugc {

ValueSyntax JsonReader::read_value() {
  const std::size_t mistakes = build_.mistake_count();
  if (scan_.next() == '[') return read_list();
  ValueSyntax value;
  const std::uint32_t begin = scan_.offset();
  const std::size_t first_number = build_.document.numbers.size();
  if (scan_.next() == '"') {
    const Span place = scan_.next_span();
    MappedText text;
    scan_.take_string(text);
    value.hold(build_.add_string(std::move(text), place));
    if (value.count != 0) value.kind = ValueKind::lexical;  // none when not admitted
  } else if (scan_.next_is_number()) {
    value.kind = ValueKind::numbers;
    take_number();
  } else if (boolean_is_next()) {
    value.kind = ValueKind::booleans;
    take_boolean();
  } else if (scan_.peek_word() == "null") {
    value.kind = ValueKind::nodes;
    scan_.take_word();
  } else {
    reject_value();
  }
  value.span = scan_.span_from(begin);
  value.damaged = build_.mistake_count() != mistakes;
  if (value.holds_numbers()) value.hold(build_.numbers_since(first_number));
  return value;
}

ValueSyntax JsonReader::read_list() {
  ValueSyntax value;
  value.bracketed = true;
  const std::size_t mistakes = build_.mistake_count();
  const std::uint32_t begin = scan_.offset();
  const std::size_t first_number = build_.document.numbers.size();
  const std::size_t first_string = build_.document.strings.size();
  for (JsonBracket list = scan_.open(); scan_.next_item(list);) {
    if (scan_.next_is_number()) {
      if (accept_in_list(value, ValueKind::numbers)) take_number();
    } else if (scan_.next() == '"') {
      const Span place = scan_.next_span();
      MappedText text;
      if (!accept_in_list(value, ValueKind::strings)) continue;
      scan_.take_string(text);
      build_.add_string(std::move(text), place);
    } else if (boolean_is_next()) {
      if (accept_in_list(value, ValueKind::booleans)) take_boolean();
    } else {
      reject_value();
    }
  }
  if (value.kind == ValueKind::none) value.kind = ValueKind::empty;
  value.span = scan_.span_from(begin);
  value.damaged = build_.mistake_count() != mistakes;
  if (value.holds_numbers()) value.hold(build_.numbers_since(first_number));
  if (value.holds_strings()) value.hold(build_.strings_since(first_string));
  return value;
}

/// The code of a shader: a string, or a list of its lines.
void JsonReader::read_source() {
  MappedText text;
  const std::uint32_t begin = scan_.offset();
  const auto read_line = [&] { scan_.next() == '"' ? scan_.take_string(text) : reject_value(); };
  if (scan_.next() != '[') {
    read_line();
  } else {
    bool first = true;
    for (JsonBracket list = scan_.open(); scan_.next_item(list);) {
      const std::uint32_t behind_line = scan_.span_from(begin).end;
      if (!std::exchange(first, false)) text.append_generated("\n", {build_.document.source, behind_line, behind_line});
      read_line();
    }
  }
  build_.add_cdata(std::move(text), scan_.span_from(begin));
}

/// The nodes that are the value of an interface field.
ValueSyntax JsonReader::read_node_value() {
  ValueSyntax value;
  const std::uint32_t begin = scan_.offset();
  const std::size_t mark = build_.nodes.open();
  value.kind = ValueKind::nodes;
  value.bracketed = scan_.next() == '[';
  read_nodes(NodesAre::values, {});
  value.span = scan_.span_from(begin);
  value.hold(build_.nodes.close(mark, build_.document.nodes));
  return value;
}

/// Whether an item of this kind may stand in the list; one that may not is reported and skipped.
bool JsonReader::accept_in_list(ValueSyntax& value, ValueKind kind) {
  if (value.kind == ValueKind::none || value.kind == kind) {
    value.kind = kind;
    return true;
  }
  if (value.kind != ValueKind::strings && kind != ValueKind::strings) {
    value.kind = ValueKind::numbers;
    return true;
  }
  scan_.mistake(scan_.next_span(),
                fmt::format("this list holds {}; {} cannot stand in it", in_words(value.kind), scan_.describe_next()));
  scan_.skip_value();
  return false;
}

void JsonReader::take_number() {
  const std::uint32_t begin = scan_.offset();
  const double number = scan_.take_number();
  if (build_.may_add_number({build_.document.source, begin, begin + 1})) build_.document.numbers.push_back(number);
}

void JsonReader::take_boolean() {
  build_.document.numbers.push_back(scan_.peek_word() == "true" ? 1 : 0);
  scan_.take_word();
}

void JsonReader::reject_value() {
  const char c = scan_.next();
  if (c == '{') {
    scan_.mistake(scan_.next_span(), "expected a value, found an object; nodes stand behind a key with `-`");
  } else if (c == '[') {
    scan_.mistake(scan_.next_span(), "a list stands inside a list; write its items into one");
  } else {
    scan_.mistake(scan_.next_span(),
                  fmt::format("expected a number, a string in quotes, `true` or `false`, found {}", scan_.describe_next()));
  }
  scan_.skip_value();
}

}  // namespace plugc
