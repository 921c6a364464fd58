#pragma once
// Source text and places in it. The source set owns every text of a run; all else points into it.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plugc {

/// Names one text of a SourceSet. The default value names none.
struct SourceId {
  std::uint32_t value = UINT32_MAX;
  bool valid() const { return value != UINT32_MAX; }
  friend bool operator==(SourceId, SourceId) = default;
};

/// A range of bytes [begin, end) in one source. A span whose source is not valid() means "no place".
struct Span {
  SourceId source;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  bool valid() const { return source.valid(); }
  friend bool operator==(const Span&, const Span&) = default;
};

/// From the start of `first` to the end of `last`; both in the same source.
Span join(const Span& first, const Span& last);

/// A line and a column, both from 1. A line ends with LF, CR LF or CR. The column counts code points, as editors do.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// Owns all text of a run: files, and texts that plugc brings along (its templates). Texts never move.
class SourceSet {
 public:
  /// `name` is what messages show: a path as the user gave it, or `plugc:/...` for plugc's own texts.
  SourceId add(std::string name, std::string text);
  /// A text that has the same id in every set, so that what is made of it can be shared by all. `number` is the caller's, one
  /// for each such text; adding one again changes nothing. `text` must outlive the set.
  SourceId add_fixed(std::uint32_t number, std::string_view name, std::string_view text);

  /// Takes all sources of another set, which is empty then. The one of id i has the id that is returned + i from here on; what
  /// pointed into the texts of the other set points nowhere.
  std::uint32_t append(SourceSet&& other);

  std::string_view name(SourceId id) const;
  std::string_view text(SourceId id) const;
  std::string_view text(const Span& span) const;

  /// Line and column of a byte; an offset behind the end is taken as the end.
  Position position(SourceId id, std::uint32_t offset) const;
  /// The line alone, which costs less.
  std::uint32_t line(SourceId id, std::uint32_t offset) const;
  /// The whole line (without its end) that holds a byte.
  std::string_view line_at(SourceId id, std::uint32_t offset) const;

 private:
  struct Source {
    std::string name;
    std::string text;
    mutable std::vector<std::uint32_t> line_starts;  // made on first use
    mutable std::vector<std::uint32_t> characters;   // before each block of bytes; made on first use
  };
  const Source& source(SourceId id) const;
  static const std::vector<std::uint32_t>& line_starts(const Source& source);
  static std::uint32_t characters_before(const Source& source, std::uint32_t offset);
  static std::uint32_t characters_between(const Source& source, std::uint32_t begin, std::uint32_t end);
  std::deque<Source> sources_;
  std::map<std::uint32_t, Source> fixed_;  // by number
};

/// Text that remembers where each of its bytes came from. Decoding (escapes, entities, percent-encoding) and composing
/// (joining parts, inserting calls, renaming) both yield one, so that any byte leads back to its author's line.
///
///     url "data:text/plain,a\"b"     ->  text `a"b`; byte 1 lies at the backslash, byte 2 at the `b`
///
/// Text that stands in a source as it is (most strings, most attributes) is a view of it and costs no copy: the source set
/// must outlive it.
class MappedText {
 public:
  MappedText() = default;
  /// `span`'s text as it stands.
  MappedText(const SourceSet& sources, const Span& span) : MappedText(sources.text(span), span.source, span.begin) {}
  MappedText(const MappedText& other);
  MappedText(MappedText&&) = default;
  MappedText& operator=(const MappedText& other) { return *this = MappedText(other); }
  MappedText& operator=(MappedText&&) = default;
  ~MappedText() = default;

  std::string_view text() const { return built_ ? std::string_view(built_->text) : verbatim_; }
  bool empty() const { return text().empty(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(text().size()); }

  /// Appends a copy of bytes that stand, one for one, at `source_begin` onward in `source`.
  void append(std::string_view text, SourceId source, std::uint32_t source_begin);
  /// Appends bytes that all come from the one place `origin` (an escape, a renamed name), or from none when it is not valid.
  void append_generated(std::string_view text, const Span& origin = {});
  /// Appends a part of another mapped text, map included.
  void append(const MappedText& other, std::uint32_t begin, std::uint32_t end);
  void append(const MappedText& other) { append(other, 0, other.size()); }

  /// Where the map changes, in order: between two of these offsets bytes stand one by one in a source, or all come from one
  /// place.
  std::vector<std::uint32_t> seams() const;

  /// The place that bytes [begin, end) came from; not valid for generated bytes without an origin. When the bytes come
  /// from several places, the place of the first one that has any.
  Span locate(std::uint32_t begin, std::uint32_t end) const;

 private:
  struct Piece {
    std::uint32_t text_begin = 0;
    SourceId source;
    std::uint32_t source_begin = 0;
    std::uint32_t source_end = 0;  // meaningful when fixed
    bool fixed = false;            // all bytes lie at [source_begin, source_end)
  };
  /// Text that stands nowhere as a whole.
  struct Built {
    std::string text;
    std::vector<Piece> pieces;
    std::size_t piece_at(std::uint32_t offset) const;
    void add_piece(const Piece& piece);
  };
  MappedText(std::string_view verbatim, SourceId source, std::uint32_t begin)
      : verbatim_(verbatim), source_(source), source_begin_(begin) {}
  Built& build();
  Span locate_built(std::uint32_t begin, std::uint32_t end) const;

  std::string_view verbatim_;  // in the source set, at source_begin_ of source_
  SourceId source_;
  std::uint32_t source_begin_ = 0;
  std::unique_ptr<Built> built_;  // when there is one, it counts
};

}  // namespace plugc
