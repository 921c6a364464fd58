// One pass. Each `<` says what begins there; a list of the open elements says what an end tag ends:
//
//     </a>  the innermost element           ends it
//           an open one further out         ends all up to it; told for the innermost, whose end tag may still follow
//           none, but spelled nearly so     ends the innermost, and is told
//           none                            is told and passed over
//
// Elements that are nested deeper than any reader goes are only counted, so that neither memory nor the search for an open
// one grows with the depth.

#include "document/xml_scanner.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace plugc {
namespace {

/// A node may stand in a few other elements each: `<ProtoDeclare><ProtoBody>`, `<fieldValue>`.
constexpr std::size_t kMaxOpenElements = 4 * std::size_t{kMaxNesting};

bool is_nearly(std::string_view name, std::string_view other) {
  return !nearest_name(name, std::array{other}).empty();
}

}  // namespace

XmlScanner::XmlScanner(DocumentBuilder& builder) : build_(builder), source_(builder.document.source) {
  const std::string_view text = builder.sources.text(source_);
  begin_ = text.data();
  end_ = begin_ + text.size();
  at_ = last_end_ = text.starts_with("\xEF\xBB\xBF") ? begin_ + 3 : begin_;
}

const char* XmlScanner::find(char c, const char* from, const char* to) const {
  const void* const found = from == to ? nullptr : std::memchr(from, c, static_cast<std::size_t>(to - from));
  return found == nullptr ? to : static_cast<const char*>(found);
}

XmlItem XmlScanner::next() {
  for (XmlAttribute passed_over; inside_tag_;) next_attribute(passed_over);
  for (;;) {
    if (ends_ > 0) return close_innermost();
    if (build_.stopped()) at_ = end_;
    const char* const begin = at_;
    at_ = skip_blanks(skip_indentation(at_, end_));
    if (at_ == end_) return take_end_of_file();
    if (!begins_markup(at_)) return take_text(begin);
    XmlItem item{};
    if (take_markup(item)) return item;
  }
}

void XmlScanner::skip_element() {
  const std::size_t outside = depth() - 1;
  while (depth() > outside) next();
}

bool XmlScanner::begins_markup(const char* less) const {
  if (*less != '<' || less + 1 == end_) return false;
  if (is_a(less[1], kXmlNameStart) || less[1] == '/' || less[1] == '?') return true;
  const std::string_view behind(less + 1, static_cast<std::size_t>(end_ - less - 1));
  return behind.starts_with("!--") || behind.starts_with("![CDATA[") || behind.starts_with("!DOCTYPE");
}

/// Takes what begins at the next `<`. False: it is nothing to hand out.
bool XmlScanner::take_markup(XmlItem& item) {
  const char kind = peek(1);
  if (kind == '/') {
    take_end_tag();
    return false;
  }
  if (kind == '?') {
    skip_instruction();
    return false;
  }
  if (kind != '!') {
    item = take_start_tag();
    return true;
  }
  if (peek(2) == '[') {
    item = take_cdata();
    return true;
  }
  if (peek(2) == '-') {
    skip_comment();
  } else {
    skip_document_type();
  }
  return false;
}

XmlItem XmlScanner::take_start_tag() {
  const char* const first = at_ + 1;
  at_ = last_end_ = name_end(first);
  tag_ = name(first, at_);
  if (open_.size() < kMaxOpenElements) {
    open_.push_back({tag_});
  } else {
    ++deeper_;
  }
  inside_tag_ = true;
  tag_was_reported_ = false;
  return XmlItem::element;
}

void XmlScanner::take_end_tag() {
  end_tag_ = at_;
  const char* const first = at_ + 2;
  const char* const behind = name_end(first);
  at_ = skip_blanks(behind);
  const std::string_view closed(first, static_cast<std::size_t>(behind - first));
  const bool closed_itself = at_ != end_ && *at_ == '>';
  if (closed_itself) {
    ++at_;
  } else {
    build_.mistake(span(end_tag_, behind), "an end tag is not closed by `>`");
    at_ = std::find_if(at_, end_, [](char c) { return c == '<' || c == '>'; });
    if (at_ == end_) end_was_reported_ = true;
    if (at_ != end_ && *at_ == '>') ++at_;
  }
  ends_ = deeper_ > 0 ? 1 : elements_closed_by(closed, span(end_tag_, closed_itself ? at_ : behind));
}

std::size_t XmlScanner::elements_closed_by(std::string_view closed, const Span& tag) {
  if (!open_.empty() && open_.back().name.text == closed) return 1;
  if (closed.empty()) {
    build_.mistake(tag, "this end tag names no element");
    return open_.empty() ? 0 : 1;
  }
  const auto same = [&](const OpenElement& element) { return element.name.text == closed; };
  const auto found = std::find_if(open_.rbegin(), open_.rend(), same);
  if (found == open_.rend()) return close_nothing(closed, tag);
  return close_up_to(static_cast<std::size_t>(open_.rend() - found) - 1, tag);
}

std::size_t XmlScanner::close_up_to(std::size_t index, const Span& tag) {
  unclosed_.clear();
  const OpenElement* told = nullptr;
  for (std::size_t i = index + 1; i < open_.size(); ++i) {
    unclosed_.push_back(open_[i].name.text);
    if (!open_[i].excused) told = &open_[i];
  }
  if (told != nullptr) {
    build_.mistake(tag, fmt::format("this end tag does not close `<{}>`, which is open here", shown(told->name.text)));
  }
  return open_.size() - index;
}

std::size_t XmlScanner::close_nothing(std::string_view closed, const Span& tag) {
  if (!unclosed_.empty() && unclosed_.back() == closed) {  // the other half of `<a><b></a></b>`
    unclosed_.pop_back();
    return 0;
  }
  if (open_.empty()) {
    build_.mistake(tag, "this end tag closes nothing");
    return 0;
  }
  const OpenElement& innermost = open_.back();
  build_.mistake(tag, fmt::format("this end tag does not close `<{}>`, which is open here", shown(innermost.name.text)));
  excuse_innermost();
  return is_nearly(closed.substr(0, kMaxNameBytes), innermost.name.text.substr(0, kMaxNameBytes)) ? 1 : 0;
}

/// Up to the next `<` that begins something; others are told and taken for characters.
XmlItem XmlScanner::take_text(const char* begin) {
  text_was_reported_ = false;
  for (at_ = find('<', at_, end_); at_ != end_ && !begins_markup(at_); at_ = find('<', at_ + 1, end_)) {
    build_.mistake(span(at_, at_ + 1), "this `<` begins no tag; write `&lt;` for the character");
    text_was_reported_ = true;
  }
  text_ = span(begin, at_);
  return XmlItem::text;
}

/// Every element that is open then lacks its end; that is one mistake, told for the innermost.
XmlItem XmlScanner::take_end_of_file() {
  if (depth() == 0) return XmlItem::end;
  const auto told = std::find_if(open_.rbegin(), open_.rend(), [](const OpenElement& element) { return !element.excused; });
  if (told != open_.rend() && !std::exchange(end_was_reported_, true)) {
    build_.mistake(told->name.span, fmt::format("`<{}>` is not closed before the end of the file", shown(told->name.text)));
  }
  ends_ = depth();
  end_tag_ = end_;
  return close_innermost();
}

/// All but the last of the elements that one tag ends lie in front of it.
XmlItem XmlScanner::close_innermost() {
  --ends_;
  last_end_ = ends_ == 0 ? at_ : end_tag_;
  if (deeper_ > 0) {
    --deeper_;
  } else {
    open_.pop_back();
  }
  return XmlItem::end;
}

}  // namespace plugc
