// Values by the types of their fields. What is written wrong is reported once and the value counts as not written; whoever
// called passes on to what follows.

#include <algorithm>

#include <fmt/format.h>

#include "document/vrml1_reader.h"

namespace plugc {
namespace {

ValueKind kind_of(Vrml1Type type) {
  switch (type) {
    case Vrml1Type::SFBool: return ValueKind::booleans;
    case Vrml1Type::SFEnum:
    case Vrml1Type::SFBitMask:
    case Vrml1Type::SFString:
    case Vrml1Type::MFString: return ValueKind::strings;
    default: return ValueKind::numbers;
  }
}

/// Whether `words`, with blanks between them, has this one.
bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

}  // namespace

ValueSyntax Vrml1Reader::read_value(const Vrml1Node& node, const Vrml1FieldInfo& field) {
  ValueSyntax value;
  value.kind = kind_of(field.type);
  const std::uint32_t begin = scan_.offset();
  const Span bracket = scan_.next_span();
  const std::size_t mistakes = build_.mistake_count();
  const std::size_t number = build_.document.numbers.size(), string = build_.document.strings.size();
  value.first = static_cast<std::uint32_t>(string);  // the words that it has so far begin there
  value.bracketed = scan_.take('[');
  read_items(value, field, value.bracketed);
  if (value.bracketed && !scan_.take(']')) not_closed(bracket, "`[`");
  value.span = scan_.span_from(begin);
  value.damaged = build_.mistake_count() != mistakes;
  if (value.holds_numbers()) {
    value.hold(build_.numbers_since(number));
  } else {
    value.hold(build_.strings_since(string));
  }
  check_count(value, node, field);
  return value;
}

/// A list up to what cannot belong to it, or one element.
bool Vrml1Reader::read_items(ValueSyntax& value, const Vrml1FieldInfo& field, bool in_list) {
  if (!in_list) return read_item(value, field);
  while (!stopped() && !scan_.at_end() && scan_.next() != ']' && scan_.next() != '}') {
    if (read_item(value, field)) continue;
    if (scan_.brace_follows_word()) return false;  // `]` was forgotten
    scan_.skip_item();
  }
  return true;
}

/// False, and reported, where no value stands; then nothing is taken.
bool Vrml1Reader::read_item(ValueSyntax& value, const Vrml1FieldInfo& field) {
  if (field.type == Vrml1Type::SFBool) return read_boolean();
  if (field.type == Vrml1Type::SFEnum || field.type == Vrml1Type::SFBitMask) return read_words(value, field);
  return value.kind == ValueKind::strings ? read_string() : read_numbers();
}

/// As many as follow.
bool Vrml1Reader::read_numbers() {
  if (!scan_.next_is(kNumberStart)) {
    expected("a number");
    return false;
  }
  while (scan_.next_is(kNumberStart)) {
    const std::uint32_t begin = scan_.offset();
    if (!build_.may_add_number(scan_.next_span())) return false;
    scan_.take_numbers(build_.document.numbers);
    if (scan_.offset() != begin) continue;
    double number = 0;
    if (!scan_.take_number(number)) {
      const Span place = scan_.span_from(begin);
      build_.mistake(place, fmt::format("`{}` is no number that plugc can read", shown(build_.sources.text(place))));
    }
    build_.document.numbers.push_back(number);
  }
  return true;
}

/// `TRUE`, `FALSE`, or as numbers.
bool Vrml1Reader::read_boolean() {
  const std::string_view word = build_.sources.text(scan_.next_span());
  const bool truth = word == "TRUE" || word == "1";
  if (!truth && word != "FALSE" && word != "0") {
    expected("`TRUE` or `FALSE`");
    return false;
  }
  scan_.take_token();
  build_.document.numbers.push_back(truth ? 1 : 0);
  return true;
}

/// In quotes, or without where no blank is in it.
bool Vrml1Reader::read_string() {
  const Span place = scan_.next_span();
  MappedText text;
  if (scan_.next() == '"') {
    if (!scan_.take_string(text)) {
      build_.mistake({place.source, place.begin, place.begin + 1}, "this `\"` begins a string that is not closed");
      end_was_reported_ = true;
    }
  } else if (const Name bare = scan_.take_bare(); !bare.empty()) {
    text = MappedText(build_.sources, bare.span);
  } else {
    expected("a string");
    return false;
  }
  build_.add_string(std::move(text), place);
  return true;
}

/// `BOLD` or `(BOLD | ITALIC)`, with or without blanks. A word that is there twice counts once.
bool Vrml1Reader::read_words(const ValueSyntax& value, const Vrml1FieldInfo& field) {
  bool open = false, closed = false;
  do {
    const Name bare = scan_.take_bare();
    if (bare.empty()) {
      expected("a word");
      return false;
    }
    open = open || bare.text.starts_with('(');
    closed = bare.text.ends_with(')');
    add_words(value, bare, field);
  } while (open && !closed && !stopped());
  return true;
}

void Vrml1Reader::add_words(const ValueSyntax& value, const Name& bare, const Vrml1FieldInfo& field) {
  constexpr std::string_view kBetween = "(|)";
  std::size_t begin = 0;
  while ((begin = bare.text.find_first_not_of(kBetween, begin)) != std::string_view::npos) {
    const std::size_t end = std::min(bare.text.find_first_of(kBetween, begin), bare.text.size());
    const auto place = [&](std::size_t at) { return bare.span.begin + static_cast<std::uint32_t>(at); };
    const Span span{bare.span.source, place(begin), place(end)};
    const std::string_view word = bare.text.substr(begin, end - begin);
    if (has_word(field.words, word)) {
      const auto known = build_.document.of(build_.strings_since(value.first));
      const bool is_new = std::ranges::none_of(known, [&](const MappedText& one) { return one.text() == word; });
      if (is_new) build_.add_string(MappedText(build_.sources, span), span);
    } else {
      build_.diagnostics.report(DiagnosticId::field_value, span,
                                fmt::format("`{}` takes no `{}`, but one of {}", field.name, shown(word), field.words));
    }
    begin = end;
  }
}

/// A single value needs all its numbers; of a list, what is no whole element is dropped.
void Vrml1Reader::check_count(ValueSyntax& value, const Vrml1Node& node, const Vrml1FieldInfo& field) {
  const auto components = static_cast<std::uint32_t>(component_count(field.type));
  const bool is_list = is_multiple(field.type);
  if (is_list && value.count == 0) {
    value.kind = value.damaged ? ValueKind::none : ValueKind::empty;
    return;
  }
  std::uint32_t whole = value.count;
  if (components > 0) whole = is_list ? whole - whole % components : whole == components ? whole : 0;
  if (components > 0 && whole != std::max(value.count, 1U) && !value.damaged) {
    build_.diagnostics.report(DiagnosticId::field_type, value.span,
                              fmt::format("`{}` of `{}` is of type {}: {} numbers{}, not {}", field.name, node.type.text,
                                          to_text(field.type), components, is_list ? " each" : "", value.count));
  }
  value.count = whole;
  if (whole == 0) value.kind = ValueKind::none;
}

}  // namespace plugc
