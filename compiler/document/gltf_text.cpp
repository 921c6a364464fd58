// The items of a list wait until it closes and then lie side by side, so that item n is found at once. A value learns its
// parent's index when the parent has one, which is when the list around the parent closes.

#include "document/gltf_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {

GltfText::GltfText(DocumentBuilder& builder) : build_(builder), scan_(builder) {
  const std::size_t said = build_.diagnostics.all().size();
  if (scan_.next() != '{') {
    scan_.mistake(scan_.next_span(), fmt::format("a glTF file is an object in `{{ }}`; {} stands here", scan_.describe_next()));
    return;
  }
  const std::size_t mark = open_.open();
  open_.add(read_value(0));
  root_ = {close(mark).first};
  if (!scan_.at_end() && !build_.stopped()) {
    scan_.mistake(scan_.next_span(), fmt::format("the file goes on behind its object with {}", scan_.describe_next()));
  }
  sound_ = said == build_.diagnostics.all().size();
}

GltfValue GltfText::read_value(std::uint32_t depth) {
  GltfValue value;
  const char next = scan_.next();
  const std::uint32_t begin = scan_.offset();
  if (next == '{' || next == '[') {
    value.kind = next == '{' ? GltfKind::object : GltfKind::list;
    if (depth == kMaxNesting) {
      build_.too_deep(scan_.next_span());
      scan_.skip_value();
    } else {
      value.items = read_items(depth);
    }
  } else if (next == '"') {
    value.kind = GltfKind::string;
    value.text = read_string(scan_.next_span());
  } else if (scan_.next_is_number()) {
    value.kind = GltfKind::number;
    value.text = build_.sources.text(scan_.next_span());
    scan_.take_number();
  } else {
    const std::string_view word = value.text = scan_.peek_word();
    if (word == "true" || word == "false") {
      value.kind = GltfKind::boolean;
    } else if (word != "null") {
      scan_.mistake(scan_.next_span(), fmt::format("expected a value, found {}", scan_.describe_next()));
    }
    scan_.take_word();
  }
  value.span = scan_.span_from(begin);
  return value;
}

Range<GltfValue> GltfText::read_items(std::uint32_t depth) {
  const std::size_t mark = open_.open();
  const bool is_object = scan_.next() == '{';
  JsonBracket bracket = scan_.open();
  Name key;
  while (is_object ? scan_.next_member(bracket, key) : scan_.next_item(bracket)) {
    if (!admit(scan_.next_span())) {
      scan_.skip_value();
      continue;
    }
    GltfValue value = read_value(depth + 1);
    value.key = is_object ? key : Name();
    open_.add(value);
  }
  return close(mark);
}

std::string_view GltfText::read_string(const Span& place) {
  const std::string_view written = build_.sources.text(place);
  MappedText text;
  scan_.take_string(text);
  if (text.size() + 2 == written.size() && written.find('\\') == std::string_view::npos) {
    return written.substr(1, text.size());
  }
  return build_.document.decoded_names.emplace_back(text.text());
}

bool GltfText::admit(const Span& place) {
  if (++count_ <= kMaxGltfValues) return true;
  if (!full_) {
    build_.diagnostics.report(DiagnosticId::scene_limit, place,
                              fmt::format("this file holds more than {} values; the rest of it is not read", kMaxGltfValues));
  }
  full_ = true;
  return false;
}

Range<GltfValue> GltfText::close(std::size_t mark) {
  const Range<GltfValue> range = open_.close(mark, values_);
  for (std::uint32_t i = 0; i < range.count; ++i) {
    const std::uint32_t parent = range.first + i;
    const Range<GltfValue> items = values_[parent].items;
    for (std::uint32_t j = 0; j < items.count; ++j) values_[items.first + j].parent = parent;
  }
  return range;
}

GltfAt GltfText::member(GltfAt object, std::string_view key) const {
  if (!object.valid() || (*this)[object].kind != GltfKind::object) return {};
  const Range<GltfValue> items = (*this)[object].items;
  for (std::uint32_t i = items.count; i-- > 0;) {
    if (values_[items.first + i].key.text == key) return {items.first + i};
  }
  return {};
}

GltfAt GltfText::item(GltfAt list, std::size_t index) const {
  if (!list.valid() || (*this)[list].kind != GltfKind::list || index >= size(list)) return {};
  return child(list, index);
}

Span GltfText::place(GltfAt at) const {
  if (!at.valid()) return {build_.document.source, 0, 0};
  const GltfValue& value = (*this)[at];
  Span span = value.span;
  if (value.kind == GltfKind::list || value.kind == GltfKind::object) span.end = std::min(span.end, span.begin + 1);
  return span;
}

std::string GltfText::path(GltfAt at) const {
  std::vector<std::uint32_t> steps;
  for (; at.valid() && at != root_; at = {(*this)[at].parent}) steps.push_back(at.index);
  std::string path;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    const GltfValue& value = values_[*step];
    const GltfValue& holder = values_[value.parent];
    if (holder.kind == GltfKind::list) {
      path += fmt::format("[{}]", *step - holder.items.first);
    } else {
      path += fmt::format("{}{}", path.empty() ? "" : ".", shown(value.key.text));
    }
  }
  return path;
}

void GltfText::mistake(GltfAt at, std::string_view message) {
  if (++mistakes_ > kMaxSyntaxMistakes) return;
  const std::string where = path(at);
  build_.diagnostics.report(DiagnosticId::gltf_invalid, place(at),
                            where.empty() ? std::string(message) : fmt::format("`{}`: {}", where, message));
  if (mistakes_ < kMaxSyntaxMistakes) return;
  build_.diagnostics.report(DiagnosticId::gltf_invalid, place(at),
                            fmt::format("this file has {} mistakes; no more of them are listed", kMaxSyntaxMistakes));
}

}  // namespace plugc
