// Line tables are made lazily, by one scan for '\n', and searched by bisection. A MappedText is its bytes plus a sorted
// list of pieces; a piece either runs along its source byte for byte, or stands still at one place (`fixed`).

#include "base/source.h"

#include <algorithm>

#include "base/check.h"

namespace plugc {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // no column of its own in any editor

}  // namespace

Span join(const Span& first, const Span& last) {
  PLUGC_CHECK(first.source == last.source, "join spans of one source");
  return {first.source, first.begin, std::max(first.end, last.end)};
}

SourceId SourceSet::add(std::string name, std::string text) {
  sources_.push_back({std::move(name), std::move(text), {}});
  return {static_cast<std::uint32_t>(sources_.size() - 1)};
}

const SourceSet::Source& SourceSet::source(SourceId id) const {
  PLUGC_CHECK(id.value < sources_.size(), "a source of this set");
  return sources_[id.value];
}

std::string_view SourceSet::name(SourceId id) const {
  return source(id).name;
}

std::string_view SourceSet::text(SourceId id) const {
  return source(id).text;
}

std::string_view SourceSet::text(const Span& span) const {
  const std::string_view whole = text(span.source);
  const std::size_t begin = std::min<std::size_t>(span.begin, whole.size());
  return whole.substr(begin, std::max(span.begin, span.end) - span.begin);
}

const std::vector<std::uint32_t>& SourceSet::line_starts(const Source& source) {
  if (source.line_starts.empty()) {
    source.line_starts.push_back(0);
    for (std::size_t at = source.text.find('\n'); at != std::string::npos; at = source.text.find('\n', at + 1)) {
      source.line_starts.push_back(static_cast<std::uint32_t>(at + 1));
    }
  }
  return source.line_starts;
}

/// Counts on from the last place that was asked for where that lies before this one in the same line.
std::uint32_t SourceSet::column(const Source& source, std::uint32_t line_start, std::uint32_t offset) {
  const bool goes_on = source.counted_to >= line_start && source.counted_to <= offset;
  std::uint32_t column = goes_on ? source.counted_column : 1;
  for (std::uint32_t i = goes_on ? source.counted_to : line_start; i < offset; ++i) {
    if ((static_cast<unsigned char>(source.text[i]) & 0xC0U) != 0x80U) ++column;
  }
  source.counted_to = offset;
  source.counted_column = column;
  return column;
}

Position SourceSet::position(SourceId id, std::uint32_t offset) const {
  const Source& in = source(id);
  offset = std::min(offset, static_cast<std::uint32_t>(in.text.size()));
  const auto& starts = line_starts(in);
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - starts.begin());
  const std::uint32_t counted = column(in, *(next - 1), offset);
  const bool behind_mark = line == 1 && offset > 0 && in.text.starts_with(kByteOrderMark);
  return {line, behind_mark ? counted - 1 : counted};
}

std::string_view SourceSet::line_at(SourceId id, std::uint32_t offset) const {
  const std::string_view whole = text(id);
  const auto& starts = line_starts(source(id));
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const std::size_t begin = *(next - 1);
  std::size_t end = next == starts.end() ? whole.size() : *next - 1;
  if (end > begin && whole[end - 1] == '\r') --end;
  return whole.substr(begin, end - begin);
}

MappedText::MappedText(const SourceSet& sources, const Span& span) {
  append(sources.text(span), span.source, span.begin);
}

void MappedText::add_piece(const Piece& piece) {
  if (!pieces_.empty()) {
    const Piece& last = pieces_.back();
    const bool runs_on = !last.fixed && !piece.fixed && last.source == piece.source &&
                         last.source_begin + (piece.text_begin - last.text_begin) == piece.source_begin;
    const bool stays = last.fixed && piece.fixed && last.source == piece.source && last.source_begin == piece.source_begin &&
                       last.source_end == piece.source_end;
    if (runs_on || stays) return;
  }
  pieces_.push_back(piece);
}

void MappedText::append(std::string_view text, SourceId source, std::uint32_t source_begin) {
  if (text.empty()) return;
  add_piece({size(), source, source_begin, 0, false});
  text_ += text;
}

void MappedText::append_generated(std::string_view text, const Span& origin) {
  if (text.empty()) return;
  add_piece({size(), origin.source, origin.begin, origin.end, true});
  text_ += text;
}

std::size_t MappedText::piece_at(std::uint32_t offset) const {
  const auto next = std::upper_bound(pieces_.begin(), pieces_.end(), offset,
                                     [](std::uint32_t at, const Piece& piece) { return at < piece.text_begin; });
  return static_cast<std::size_t>(next - pieces_.begin()) - 1;
}

void MappedText::append(const MappedText& other, std::uint32_t begin, std::uint32_t end) {
  end = std::min(end, other.size());
  if (begin >= end) return;
  for (std::size_t i = other.piece_at(begin); i < other.pieces_.size() && other.pieces_[i].text_begin < end; ++i) {
    Piece piece = other.pieces_[i];
    const std::uint32_t from = std::max(begin, piece.text_begin);
    if (!piece.fixed) piece.source_begin += from - piece.text_begin;
    piece.text_begin = size() + (from - begin);
    add_piece(piece);
  }
  text_.append(other.text_, begin, end - begin);
}

Span MappedText::locate(std::uint32_t begin, std::uint32_t end) const {
  if (pieces_.empty()) return {};
  begin = std::min(begin, size());
  for (std::size_t i = piece_at(std::min(begin, size() - 1)); i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    if (piece.text_begin >= end && piece.text_begin > begin) break;
    if (!piece.source.valid()) continue;
    if (piece.fixed) return {piece.source, piece.source_begin, piece.source_end};
    const std::uint32_t piece_end = i + 1 < pieces_.size() ? pieces_[i + 1].text_begin : size();
    const std::uint32_t from = std::max(begin, piece.text_begin);
    const std::uint32_t length = std::min(std::max(end, from), piece_end) - from;
    const std::uint32_t source_at = piece.source_begin + (from - piece.text_begin);
    return {piece.source, source_at, source_at + length};
  }
  return {};
}

}  // namespace plugc
