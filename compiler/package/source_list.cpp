#include "package/source_list.h"

#include <algorithm>

namespace plugc {

std::uint32_t SourceList::index(SourceId source) {
  const auto [found, added] = known_.try_emplace(source.value, static_cast<std::uint32_t>(names_->size()));
  if (added) names_->emplace_back(sources_->name(source));
  return found->second;
}

PackedLineOrigin SourceList::origin(const Span& span) {
  if (!span.valid()) return {0, 0};
  return {index(span.source), sources_->line(span.source, span.begin)};
}

std::vector<PackedLineOrigin> SourceList::origins(const MappedText& text) {
  std::vector<PackedLineOrigin> origins;
  const std::string_view all = text.text();
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::size_t word = std::min(all.find_first_not_of(" \t\r", begin), end);
    const Span span = word < end ? text.locate(static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(end)) : Span{};
    origins.push_back(origin(span));
    begin = end + 1;
  }
  return origins;
}

namespace {

/// Every byte at which the map changes, and the first word of every line.
std::vector<std::uint32_t> map_changes(const MappedText& text) {
  std::vector<std::uint32_t> offsets = text.seams();
  const std::string_view all = text.text();
  for (std::size_t begin = 0; begin < all.size(); begin = std::min(all.find('\n', begin), all.size()) + 1)
    offsets.push_back(static_cast<std::uint32_t>(std::min(all.find_first_not_of(" \t\r", begin), all.size() - 1)));
  std::ranges::sort(offsets);
  return offsets;
}

}  // namespace

std::vector<PackedColumnOrigin> SourceList::columns(const MappedText& text, const std::vector<PackedLineOrigin>& origins) {
  std::vector<PackedColumnOrigin> columns;
  const std::string_view all = text.text();
  std::uint32_t line = 1, line_begin = 0;
  std::uint32_t shift = 0;  // from a column of the text to the author's, so far on this line
  for (const std::uint32_t offset : map_changes(text)) {
    for (std::size_t end = all.find('\n', line_begin); end < offset; end = all.find('\n', line_begin)) {
      line_begin = static_cast<std::uint32_t>(end + 1);
      ++line;
      shift = 0;
    }
    const Span span = text.locate(offset, offset + 1);
    if (line > origins.size() || origins[line - 1].line() == 0 || !span.valid()) continue;
    const Position at = sources_->position(span.source, span.begin);
    if (at.line != origins[line - 1].line() || index(span.source) != origins[line - 1].source()) continue;
    const std::uint32_t column = offset - line_begin + 1;
    if (at.column - column == shift) continue;
    shift = at.column - column;
    columns.emplace_back(line, column, at.column);
  }
  return columns;
}

}  // namespace plugc
