// A table of lines, and for long lines one of how many characters stand before each block of bytes, are made when a place is
// first asked for; so a place costs a bisection and its line up to there, or of a long line two blocks. A MappedText is a view
// of its source until something else is appended. Then it is its bytes plus a sorted list of pieces; a piece either runs along
// its source byte for byte, or stands still at one place (`fixed`).

#include "base/source.h"

#include <algorithm>
#include <iterator>

#include "base/check.h"

namespace plugc {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // no column of its own in any editor
constexpr std::uint32_t kBlock = 4096;
constexpr std::uint32_t kFirstFixed = 0x80000000;  // ids of texts that have the same one in every set

/// Code points that begin in the text.
std::uint32_t count_characters(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

Span join(const Span& first, const Span& last) {
  PLUGC_CHECK(first.source == last.source, "join spans of one source");
  return {first.source, first.begin, std::max(first.end, last.end)};
}

SourceId SourceSet::add(std::string name, std::string text) {
  sources_.push_back({std::move(name), std::move(text), {}, {}});
  return {static_cast<std::uint32_t>(sources_.size() - 1)};
}

SourceId SourceSet::add_fixed(std::uint32_t number, std::string_view name, std::string_view text) {
  fixed_.try_emplace(number, Source{std::string(name), std::string(text), {}, {}});
  return {kFirstFixed + number};
}

const SourceSet::Source& SourceSet::source(SourceId id) const {
  if (const auto found = fixed_.find(id.value - kFirstFixed); id.value >= kFirstFixed && found != fixed_.end())
    return found->second;
  PLUGC_CHECK(id.value < sources_.size(), "a source of this set");
  return sources_[id.value];
}

std::uint32_t SourceSet::append(SourceSet&& other) {
  const auto first = static_cast<std::uint32_t>(sources_.size());
  std::move(other.sources_.begin(), other.sources_.end(), std::back_inserter(sources_));
  other.sources_.clear();
  return first;
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
  if (!source.line_starts.empty()) return source.line_starts;
  const std::string_view text = source.text;
  source.line_starts.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends = text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n");
    if (ends) source.line_starts.push_back(static_cast<std::uint32_t>(i + 1));
  }
  return source.line_starts;
}

std::uint32_t SourceSet::characters_before(const Source& source, std::uint32_t offset) {
  const std::string_view text = source.text;
  std::vector<std::uint32_t>& before = source.characters;
  if (before.empty()) before.push_back(0);
  while (before.size() <= offset / kBlock) {
    before.push_back(before.back() + count_characters(text.substr((before.size() - 1) * kBlock, kBlock)));
  }
  return before[offset / kBlock] + count_characters(text.substr(offset - offset % kBlock, offset % kBlock));
}

std::uint32_t SourceSet::characters_between(const Source& source, std::uint32_t begin, std::uint32_t end) {
  if (end - begin < kBlock) return count_characters(std::string_view(source.text).substr(begin, end - begin));
  return characters_before(source, end) - characters_before(source, begin);
}

Position SourceSet::position(SourceId id, std::uint32_t offset) const {
  const Source& in = source(id);
  offset = std::min(offset, static_cast<std::uint32_t>(in.text.size()));
  const auto& starts = line_starts(in);
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - starts.begin());
  const std::uint32_t counted = characters_between(in, *(next - 1), offset) + 1;
  const bool behind_mark = line == 1 && offset > 0 && in.text.starts_with(kByteOrderMark);
  return {line, behind_mark ? counted - 1 : counted};
}

std::uint32_t SourceSet::line(SourceId id, std::uint32_t offset) const {
  const Source& in = source(id);
  const auto& starts = line_starts(in);
  offset = std::min(offset, static_cast<std::uint32_t>(in.text.size()));
  return static_cast<std::uint32_t>(std::upper_bound(starts.begin(), starts.end(), offset) - starts.begin());
}

std::string_view SourceSet::line_at(SourceId id, std::uint32_t offset) const {
  const std::string_view whole = text(id);
  const auto& starts = line_starts(source(id));
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const std::size_t begin = *(next - 1);
  std::size_t end = next == starts.end() ? whole.size() : *next;
  while (end > begin && (whole[end - 1] == '\r' || whole[end - 1] == '\n')) --end;
  return whole.substr(begin, end - begin);
}

MappedText::MappedText(const MappedText& other)
    : verbatim_(other.verbatim_),
      source_(other.source_),
      source_begin_(other.source_begin_),
      built_(other.built_ ? std::make_unique<Built>(*other.built_) : nullptr) {}

MappedText::Built& MappedText::build() {
  if (built_) return *built_;
  built_ = std::make_unique<Built>();
  if (!verbatim_.empty()) built_->pieces.push_back({0, source_, source_begin_, 0, false});
  built_->text = verbatim_;
  return *built_;
}

void MappedText::Built::add_piece(const Piece& piece) {
  if (!pieces.empty()) {
    const Piece& last = pieces.back();
    const bool runs_on = !last.fixed && !piece.fixed && last.source == piece.source &&
                         last.source_begin + (piece.text_begin - last.text_begin) == piece.source_begin;
    const bool stays = last.fixed && piece.fixed && last.source == piece.source && last.source_begin == piece.source_begin &&
                       last.source_end == piece.source_end;
    if (runs_on || stays) return;
  }
  pieces.push_back(piece);
}

void MappedText::append(std::string_view text, SourceId source, std::uint32_t source_begin) {
  if (text.empty()) return;
  Built& built = build();
  built.add_piece({size(), source, source_begin, 0, false});
  built.text += text;
}

void MappedText::append_generated(std::string_view text, const Span& origin) {
  if (text.empty()) return;
  Built& built = build();
  built.add_piece({size(), origin.source, origin.begin, origin.end, true});
  built.text += text;
}

std::size_t MappedText::Built::piece_at(std::uint32_t offset) const {
  const auto next = std::upper_bound(pieces.begin(), pieces.end(), offset,
                                     [](std::uint32_t at, const Piece& piece) { return at < piece.text_begin; });
  return static_cast<std::size_t>(next - pieces.begin()) - 1;
}

void MappedText::append(const MappedText& other, std::uint32_t begin, std::uint32_t end) {
  end = std::min(end, other.size());
  if (begin >= end) return;
  if (!other.built_) {
    const MappedText part(other.verbatim_.substr(begin, end - begin), other.source_, other.source_begin_ + begin);
    if (empty()) {
      *this = part;
    } else {
      append(part.verbatim_, part.source_, part.source_begin_);
    }
    return;
  }
  Built& built = build();
  const Built& from = *other.built_;  // may be the same
  for (std::size_t i = from.piece_at(begin); i < from.pieces.size() && from.pieces[i].text_begin < end; ++i) {
    Piece piece = from.pieces[i];
    const std::uint32_t skipped = std::max(begin, piece.text_begin) - piece.text_begin;
    if (!piece.fixed) piece.source_begin += skipped;
    piece.text_begin = size() + (piece.text_begin + skipped - begin);
    built.add_piece(piece);
  }
  built.text.append(from.text, begin, end - begin);
}

std::vector<std::uint32_t> MappedText::seams() const {
  std::vector<std::uint32_t> offsets;
  if (!built_ && !empty()) offsets.push_back(0);
  if (!built_) return offsets;
  for (const Piece& piece : built_->pieces) offsets.push_back(piece.text_begin);
  return offsets;
}

Span MappedText::locate(std::uint32_t begin, std::uint32_t end) const {
  if (built_) return locate_built(begin, end);
  if (verbatim_.empty()) return {};
  const std::uint32_t from = std::min(begin, size());
  const std::uint32_t to = std::min(std::max(end, from), size());
  return {source_, source_begin_ + from, source_begin_ + to};
}

Span MappedText::locate_built(std::uint32_t begin, std::uint32_t end) const {
  const std::vector<Piece>& pieces = built_->pieces;
  begin = std::min(begin, size());
  for (std::size_t i = built_->piece_at(std::min(begin, size() - 1)); i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (piece.text_begin >= end && piece.text_begin > begin) break;
    if (!piece.source.valid()) continue;
    if (piece.fixed) return {piece.source, piece.source_begin, piece.source_end};
    const std::uint32_t piece_end = i + 1 < pieces.size() ? pieces[i + 1].text_begin : size();
    const std::uint32_t from = std::max(begin, piece.text_begin);
    const std::uint32_t length = std::min(std::max(end, from), piece_end) - from;
    const std::uint32_t source_at = piece.source_begin + (from - piece.text_begin);
    return {piece.source, source_at, source_at + length};
  }
  return {};
}

}  // namespace plugc
