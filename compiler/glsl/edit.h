#pragma once
// Replacing ranges of a mapped text without losing its map.

#include <string>
#include <vector>

#include "base/source.h"

namespace plugc {

/// Bytes [begin, end) become `replacement`; begin == end inserts. Replacement bytes keep the place of what they replace,
/// or have none when they are inserted, unless `origin` says where they count as coming from.
struct Edit {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string replacement;
  Span origin = {};
};

/// Edits must not overlap; they are sorted here (stable, so insertions at one place keep their order).
MappedText apply_edits(const MappedText& text, std::vector<Edit> edits);
/// The same, put behind what `result` has already.
void append_edited(const MappedText& text, std::vector<Edit> edits, MappedText& result);

}  // namespace plugc
