// One walk along the text: copy up to the next edit with its map, write the replacement, jump behind what it replaces.
// Edits are sorted by begin and then by end, so that an insertion comes before a replacement that starts at its place.

#include "glsl/edit.h"

#include <algorithm>
#include <tuple>

#include "base/check.h"

namespace plugc {

void append_edited(const MappedText& text, std::vector<Edit> edits, MappedText& result) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return std::tie(a.begin, a.end) < std::tie(b.begin, b.end); });
  std::uint32_t copied = 0;
  for (const Edit& edit : edits) {
    PLUGC_CHECK(copied <= edit.begin && edit.begin <= edit.end && edit.end <= text.size(),
                "edits lie inside the text and do not overlap");
    result.append(text, copied, edit.begin);
    const Span replaced = edit.begin < edit.end ? text.locate(edit.begin, edit.end) : Span{};
    result.append_generated(edit.replacement, edit.origin.valid() ? edit.origin : replaced);
    copied = edit.end;
  }
  result.append(text, copied, text.size());
}

MappedText apply_edits(const MappedText& text, std::vector<Edit> edits) {
  MappedText result;
  append_edited(text, std::move(edits), result);
  return result;
}

}  // namespace plugc
