// One walk along the text: copy up to the next edit with its map, write the replacement, jump behind what it replaces.
// Edits are sorted by begin and then by end, so that an insertion comes before a replacement that starts at its place.

#include "glsl/edit.h"

#include <algorithm>
#include <tuple>

#include "base/check.h"

namespace plugc {

void append_edited(const MappedText& text, std::vector<Edit> edits, MappedText& result) {
  const auto in_front = [](const Edit& a, const Edit& b) { return std::tie(a.begin, a.end) < std::tie(b.begin, b.end); };
  if (!std::ranges::is_sorted(edits, in_front)) std::ranges::stable_sort(edits, in_front);
  std::uint32_t copied = 0;
  for (const Edit& edit : edits) {
    PLUGC_CHECK(copied <= edit.begin && edit.begin <= edit.end && edit.end <= text.size(),
                "edits lie inside the text and do not overlap");
    result.append(text, copied, edit.begin);
    copied = edit.end;
    if (edit.replacement.empty()) continue;
    const bool replaces = !edit.origin.valid() && edit.begin < edit.end;
    result.append_generated(edit.replacement, replaces ? text.locate(edit.begin, edit.end) : edit.origin);
  }
  result.append(text, copied, text.size());
}

MappedText apply_edits(const MappedText& text, std::vector<Edit> edits) {
  MappedText result;
  append_edited(text, std::move(edits), result);
  return result;
}

}  // namespace plugc
