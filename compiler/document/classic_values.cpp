// Without a node table a value is taken by what it looks like: `[`, a number (and all that follow it), one string, TRUE,
// FALSE, NULL, IS, or else a node. The first item of a list decides what the list holds; an item of another kind is
// reported and left out.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "document/classic_reader.h"

namespace plugc {
namespace {

bool is_word_for_no_number(std::string_view word) {
  static constexpr std::array<std::string_view, 7> kWords = {"nan", "NaN", "NAN", "inf", "Inf", "INF", "Infinity"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

}  // namespace

ValueSyntax ClassicReader::read_value(const Name& field) {
  const std::uint32_t begin = scan_.offset();
  const std::size_t first_number = build_.document.numbers.size();
  const std::size_t first_string = build_.document.strings.size();
  const std::size_t mistakes = build_.mistake_count();
  if (scan_.next() == '[') return read_list();
  ValueSyntax value;
  if (scan_.next_is(kNumberStart)) {
    value.kind = ValueKind::numbers;
    while (scan_.next_is(kNumberStart)) read_numbers();
  } else if (scan_.next() == '"') {
    value.kind = ValueKind::strings;
    read_string();
  } else if (scan_.next_is(kWordStart)) {
    read_word_value(value, field);
  } else {
    expected(fmt::format("a value for `{}`", shown(field.text)));
    if (scan_.next() == '{' || scan_.next() == ']') scan_.skip_item();
    return value;
  }
  read_more(value);
  value.span = scan_.span_from(begin);
  value.damaged = build_.mistake_count() != mistakes;
  if (value.holds_numbers()) value.hold(build_.numbers_since(first_number));
  if (value.holds_strings()) value.hold(build_.strings_since(first_string));
  return value;
}

/// `nan` and `inf`, which programs write for numbers that they do not have; with all that belongs to the value.
void ClassicReader::skip_no_number() {
  build_.mistake(scan_.next_span(), fmt::format("`{}` is no number", scan_.peek_word()));
  while (scan_.next_is(kNumberStart) || is_word_for_no_number(scan_.peek_word())) scan_.skip_item();
}

/// Behind a value without brackets: more strings or booleans, for which brackets were forgotten, or a string among numbers.
void ClassicReader::read_more(ValueSyntax& value) {
  if (value.kind == ValueKind::numbers && scan_.next() == '"') {
    expected("a number, the name of a field or `}`");
    while (scan_.next() == '"' || scan_.next_is(kNumberStart)) scan_.skip_item();
  }
  if (value.kind == ValueKind::numbers && is_word_for_no_number(scan_.peek_word())) skip_no_number();
  const bool strings = value.kind == ValueKind::strings && scan_.next() == '"';
  const bool booleans = value.kind == ValueKind::booleans && boolean_is_next();
  if (!strings && !booleans) return;
  build_.mistake(scan_.next_span(), fmt::format("several {} need `[` and `]` around them", in_words(value.kind)));
  while (strings && scan_.next() == '"') read_string();
  while (booleans && boolean_is_next()) read_boolean();
}

void ClassicReader::read_word_value(ValueSyntax& value, const Name& field) {
  const std::string_view word = scan_.peek_word();
  if (boolean_is_next()) {
    value.kind = ValueKind::booleans;
    read_boolean();
  } else if (word == "NULL") {
    value.kind = ValueKind::nodes;
    scan_.take_word();
  } else if (word == "IS") {
    read_is(value);
  } else if (word == "DEF" || word == "USE" || looks_like_node_type(word) || scan_.brace_follows_word()) {
    value.kind = ValueKind::nodes;
    const auto node = read_node();
    if (node_is_next()) return read_more_nodes(value, node);
    if (node) value.hold(build_.add_node(*node));
  } else if (is_word_for_no_number(word)) {
    skip_no_number();
  } else {
    expected(fmt::format("a value for `{}`", shown(field.text)));
    if (word_is_bad_value()) scan_.take_word();
  }
}

/// Whether a node follows, which cannot be the next field.
bool ClassicReader::node_is_next() const {
  const std::string_view word = scan_.peek_word();
  if (!looks_like_node_type(word)) return false;
  ClassicScanner ahead = scan_;
  ahead.take_word();
  return word == "DEF" || word == "USE" ? ahead.next_is(kWordStart) : ahead.next() == '{';
}

/// `children Shape { } Shape { }`
void ClassicReader::read_more_nodes(ValueSyntax& value, const std::optional<NodeSyntax>& first) {
  build_.mistake(scan_.next_span(), "several nodes need `[` and `]` around them");
  const std::size_t mark = build_.nodes.open();
  if (first) build_.add_list_node(*first);
  while (!stopped() && node_is_next()) {
    if (auto node = read_node()) build_.add_list_node(*node);
  }
  value.hold(build_.nodes.close(mark, build_.document.nodes));
}

/// Of `whichChoice one children [ ]` the word is a wrong value; of `whichChoice children [ ]` it is the next field.
bool ClassicReader::word_is_bad_value() const {
  ClassicScanner ahead = scan_;
  ahead.take_word();
  return ahead.next() == '}' || (ahead.next_is(kWordStart) && !looks_like_node_type(ahead.peek_word()));
}

bool ClassicReader::boolean_is_next() const {
  const std::string_view word = scan_.peek_word();
  return word == "TRUE" || word == "FALSE" || word == "true" || word == "false";
}

void ClassicReader::read_boolean() {
  const Name word = scan_.take_word();
  const bool truth = word.text == "TRUE" || word.text == "true";
  if (word.text[0] == 't' || word.text[0] == 'f') {
    build_.mistake(word.span, fmt::format("the classic encoding spells `{}` as `{}`", word.text, truth ? "TRUE" : "FALSE"));
  }
  build_.document.numbers.push_back(truth ? 1 : 0);
}

/// As many numbers as are next, or one that is odd.
void ClassicReader::read_numbers() {
  const std::uint32_t begin = scan_.offset();
  if (!build_.may_add_number({build_.document.source, begin, begin + 1})) return scan_.skip_to_end();
  scan_.take_numbers(build_.document.numbers);
  if (scan_.offset() != begin) return;
  double number = 0;
  if (!scan_.take_number(number)) {
    const Span place = scan_.span_from(begin);
    build_.mistake(place, fmt::format("`{}` is no number that plugc can read", shown(build_.sources.text(place))));
  }
  build_.document.numbers.push_back(number);
}

void ClassicReader::read_string() {
  const Span place = scan_.next_span();
  MappedText text;
  if (!scan_.take_string(text)) {
    build_.mistake({place.source, place.begin, place.begin + 1}, "this `\"` begins a string that is not closed");
    end_was_reported_ = true;
  }
  build_.add_string(std::move(text), place);
}

void ClassicReader::read_is(ValueSyntax& value) {
  const std::uint32_t begin = scan_.offset();
  scan_.take_word();
  const Name name = expect_name("the name of a field of the prototype");
  if (name.empty()) return;
  value.kind = ValueKind::is;
  value.hold(build_.add_string(MappedText(build_.sources, name.span), name.span));
  value.span = scan_.span_from(begin);
}

ValueSyntax ClassicReader::read_list() {
  ValueSyntax value;
  value.bracketed = true;
  const std::size_t mistakes = build_.mistake_count();
  const std::uint32_t begin = scan_.offset();
  const Span bracket = scan_.next_span();
  const std::size_t nodes = build_.nodes.open();
  const std::size_t first_number = build_.document.numbers.size();
  const std::size_t first_string = build_.document.strings.size();
  scan_.take('[');
  ++open_lists_;
  while (!stopped() && scan_.next() != ']' && read_list_item(value)) {
  }
  --open_lists_;
  if (!scan_.take(']')) not_closed(bracket, "`[`");
  value.span = scan_.span_from(begin);
  value.damaged = build_.mistake_count() != mistakes;
  value.hold(build_.nodes.close(nodes, build_.document.nodes));
  if (value.kind == ValueKind::none) value.kind = ValueKind::empty;
  if (value.holds_numbers()) value.hold(build_.numbers_since(first_number));
  if (value.holds_strings()) value.hold(build_.strings_since(first_string));
  return value;
}

/// One item, or false before what cannot belong to a list.
bool ClassicReader::read_list_item(ValueSyntax& value) {
  if (scan_.next_is(kNumberStart)) {
    if (accept_in_list(value, ValueKind::numbers)) read_numbers();
  } else if (scan_.next() == '"') {
    if (accept_in_list(value, ValueKind::strings)) read_string();
  } else if (scan_.next_is(kWordStart)) {
    return read_list_word(value);
  } else if (scan_.at_end() || scan_.next() == '}') {
    return false;
  } else {
    expected("an item of the list or `]`");
    scan_.skip_item();
  }
  return true;
}

bool ClassicReader::read_list_word(ValueSyntax& value) {
  const std::string_view word = scan_.peek_word();
  if (boolean_is_next()) {
    if (accept_in_list(value, ValueKind::booleans)) read_boolean();
  } else if (word == "NULL") {
    if (accept_in_list(value, ValueKind::nodes)) scan_.take_word();
  } else if (word == "DEF" || word == "USE" || scan_.brace_follows_word()) {
    read_list_node(value);
  } else if (list_goes_on()) {
    expected("an item of the list or `]`");
    scan_.take_word();
  } else {
    return false;
  }
  return true;
}

/// Of `[ 0 1 two 3 ]` the word is a wrong item; in `[ 0 1 solid FALSE }` the `]` was forgotten.
bool ClassicReader::list_goes_on() const {
  constexpr int kFarthest = 1000;
  ClassicScanner ahead = scan_;
  for (int i = 0; i < kFarthest && !ahead.at_end(); ++i) {
    const char next = ahead.next();
    if (next == '[' || next == ']' || next == '{' || next == '}') return next == ']';
    ahead.skip_item();
  }
  return false;
}

/// A node among numbers or strings is read, for its own mistakes, and dropped.
void ClassicReader::read_list_node(ValueSyntax& value) {
  const bool fits = value.kind == ValueKind::none || value.kind == ValueKind::nodes;
  if (!fits) report_mixed_list(value.kind);
  const PoolSizes before = fits ? PoolSizes{} : build_.pool_sizes();
  auto node = read_node();
  if (!fits) return build_.drop_since(before);
  value.kind = ValueKind::nodes;
  if (node) build_.add_list_node(std::move(*node));
}

/// Whether an item of this kind may stand in the list; one that may not is reported and skipped.
bool ClassicReader::accept_in_list(ValueSyntax& value, ValueKind kind) {
  const auto numeric = [](ValueKind k) { return k == ValueKind::numbers || k == ValueKind::booleans; };
  if (value.kind == ValueKind::none || value.kind == kind) {
    value.kind = kind;
  } else if (numeric(value.kind) && numeric(kind)) {
    value.kind = ValueKind::numbers;
  } else {
    report_mixed_list(value.kind);
    scan_.skip_item();
    return false;
  }
  return true;
}

void ClassicReader::report_mixed_list(ValueKind kind) {
  build_.mistake(scan_.next_span(),
                 fmt::format("this list holds {}; {} cannot stand in it", in_words(kind), scan_.describe_next()));
}

}  // namespace plugc
