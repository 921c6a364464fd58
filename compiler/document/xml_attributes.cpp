// The inside of a start tag. What is no attribute is told once, however many words it has, and passed over. A value without
// quotes reaches to the next `name=` or to the end of the tag. A value whose closing quote is missing would swallow what
// follows; it shows when its quote is the last one, or when the next one stands where another value begins:
//
//     <Box size='1 2 3 solid='true'/>            the value is `1 2 3`
//     <Box size='1 2 3/> <Cone height='2'/>      likewise

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "document/xml_scanner.h"

namespace plugc {

bool XmlScanner::next_attribute(XmlAttribute& attribute) {
  while (inside_tag_) {
    const char* const behind_last = at_;
    at_ = skip_blanks(at_);
    if (at_ != end_ && is_a(*at_, kXmlNameStart)) {
      if (take_attribute(attribute, behind_last)) return true;
    } else if (peek(0) == '>') {
      end_start_tag(at_ + 1, false);
    } else if (peek(0) == '/' && peek(1) == '>') {
      end_start_tag(at_ + 2, true);
    } else if (at_ == end_ || begins_markup(at_)) {
      end_broken_start_tag(behind_last);
    } else {
      pass_over_odd(behind_last);
    }
  }
  return false;
}

void XmlScanner::end_start_tag(const char* behind, bool empty) {
  at_ = last_end_ = behind;
  inside_tag_ = false;
  ends_ = empty ? 1 : 0;
}

void XmlScanner::end_broken_start_tag(const char* behind_last) {
  if (!tag_was_reported_ && odd_end_ != behind_last) build_.mistake(tag_.span, "a start tag is not closed by `>`");
  if (at_ == end_) end_was_reported_ = true;
  excuse_innermost();
  end_start_tag(at_, false);
}

/// False: what begins like an attribute has no value.
bool XmlScanner::take_attribute(XmlAttribute& attribute, const char* behind_last) {
  const char* const first = at_;
  const char* const behind = name_end(first);
  at_ = skip_blanks(behind);
  if (peek(0) != '=') {
    at_ = behind;
    report_odd(first, behind_last);
    return false;
  }
  const char* const behind_equals = at_ + 1;
  at_ = skip_blanks(behind_equals);
  attribute.name = name(first, behind);
  attribute.damaged = false;
  if (first == behind_last) build_.mistake(attribute.name.span, "a blank is missing in front of this attribute");
  if (peek(0) != '"' && peek(0) != '\'') {
    if (take_unquoted(attribute)) return true;
    at_ = behind_equals;
    report_odd(first, behind_last);
    return false;
  }
  take_quoted(attribute);
  return true;
}

void XmlScanner::take_quoted(XmlAttribute& attribute) {
  const char* const first = at_ + 1;
  const char* const close = find(*at_, first, end_);
  const char* const less = find('<', first, close);
  const bool behind_equals = close != end_ && close - first > 1 && close[-1] == '=' && is_a(close[-2], kXmlNameRest);
  const char behind = end_ - close > 1 ? close[1] : '>';
  const bool goes_on = behind != '>' && behind != '/' && !is_a(behind, kXmlBlank);
  if (close == end_ || (behind_equals && (less != close || goes_on))) return take_open_value(attribute, close);
  if (less != close) {
    build_.mistake(span(less, less + 1), "this `<` stands in the value of an attribute; write `&lt;` for the character");
  }
  attribute.value = span(first, close);
  at_ = close + 1;
}

/// A value without its closing quote: it ends before the tag does, or before the attribute whose quote stands at `limit`.
void XmlScanner::take_open_value(XmlAttribute& attribute, const char* limit) {
  const char* const quote = at_;
  const char* const first = quote + 1;
  const char* behind = find('>', first, find('<', first, limit));
  if (behind != limit && *behind == '>' && behind[-1] == '/' && behind - first > 0) --behind;
  if (behind == limit && limit != end_) {
    for (--behind; behind != first && is_a(behind[-1], kXmlNameRest);) --behind;
  }
  build_.mistake(span(quote, first), fmt::format("this `{}` begins a value that is not closed", *quote));
  while (behind != first && is_a(behind[-1], kXmlBlank)) --behind;
  at_ = behind;
  attribute.value = span(first, behind);
  attribute.damaged = tag_was_reported_ = true;
}

/// False: there is no value at all.
bool XmlScanner::take_unquoted(XmlAttribute& attribute) {
  const char* const first = at_;
  const char* behind = first;
  while (!ends_tag(at_) && !attribute_begins(at_)) {
    behind = at_ = odd_token_end(at_);
    at_ = skip_blanks(at_);
  }
  at_ = behind;
  if (first == behind) return false;
  attribute.value = span(first, behind);
  const std::string_view value(first, static_cast<std::size_t>(behind - first));
  const std::string_view key = shown(attribute.name.text);
  build_.mistake(attribute.value, shown(value) == value
                                      ? fmt::format("the value of `{0}` stands without quotes; write `{0}=\"{1}\"`", key, value)
                                      : fmt::format("the value of `{}` stands without quotes", key));
  return true;
}

bool XmlScanner::ends_tag(const char* at) const {
  if (at == end_ || *at == '>') return true;
  return (*at == '/' && end_ - at > 1 && at[1] == '>') || begins_markup(at);
}

bool XmlScanner::attribute_begins(const char* at) const {
  if (at == end_ || !is_a(*at, kXmlNameStart)) return false;
  const char* const equals = skip_blanks(name_end(at));
  return equals != end_ && *equals == '=';
}

const char* XmlScanner::odd_token_end(const char* at) const {
  do ++at;
  while (!ends_tag(at) && !is_a(*at, kXmlBlank));
  return at;
}

void XmlScanner::pass_over_odd(const char* behind_last) {
  const char* const first = at_;
  at_ = odd_token_end(at_);
  report_odd(first, behind_last);
  const char* const next = skip_blanks(at_);
  const bool slash = at_ - first == 1 && *first == '/';
  if (slash && next != end_ && *next == '>') end_start_tag(next + 1, true);
}

/// From `first` to where the scanner stands is no attribute; behind another such thing that is the same mistake.
void XmlScanner::report_odd(const char* first, const char* behind_last) {
  if (odd_end_ != behind_last) build_.mistake(span(first, at_), "an attribute needs the form `name=\"value\"`");
  odd_end_ = at_;
}

}  // namespace plugc
