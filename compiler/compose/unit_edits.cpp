// Removals come nearly in text order, so the sorted list of them grows at its end.

#include "compose/unit_edits.h"

#include <algorithm>

#include "glsl/scan.h"

namespace plugc {
namespace {

bool is_space(char c) {
  return is_blank(c) || c == '\r';
}

}  // namespace

/// The first removed range that begins behind the offset.
UnitEdits::Removed UnitEdits::behind(std::uint32_t offset) const {
  if (removed_.empty() || removed_.back().begin <= offset) return removed_.end();
  return std::ranges::upper_bound(removed_, offset, {}, &TextRange::begin);
}

const TextRange* UnitEdits::removed_at(std::uint32_t offset) const {
  const Removed next = behind(offset);
  if (next == removed_.begin() || offset >= (next - 1)->end) return nullptr;
  return &*(next - 1);
}

void UnitEdits::replace(std::uint32_t begin, std::uint32_t end, std::string replacement) {
  const Removed next = behind(begin);
  if (begin >= end || (next != removed_.end() && next->begin < end) || is_removed(begin)) return;
  removed_.insert(next, {begin, end});
  edits_.push_back({begin, end, std::move(replacement), {}});
}

void UnitEdits::remove_lines(std::uint32_t begin, std::uint32_t end) {
  std::uint32_t line_begin = begin;
  while (line_begin > 0 && is_blank(text_[line_begin - 1])) --line_begin;
  std::uint32_t line_end = end;
  while (line_end < text_.size() && is_space(text_[line_end])) ++line_end;
  const bool alone = (line_begin == 0 || text_[line_begin - 1] == '\n') && line_end < text_.size() && text_[line_end] == '\n' &&
                     !is_removed(line_begin);
  alone ? replace(line_begin, line_end + 1, "") : replace(begin, end, "");
}

void UnitEdits::insert(std::uint32_t place, std::string text, const Span& origin) {
  edits_.push_back({place, place, std::move(text), origin});
}

void UnitEdits::rename(const Token& token, std::string_view name) {
  edits_.push_back({token.begin, token.end, std::string(name), {}});
}

}  // namespace plugc
