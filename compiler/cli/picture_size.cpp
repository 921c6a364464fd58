#include "cli/picture_size.h"

#include <charconv>

#include <fmt/format.h>

namespace plugc {

std::optional<PictureSize> read_picture_size(std::string_view text) {
  constexpr std::uint32_t kMaxSide = 8192;
  PictureSize size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  const bool whole = height.ec == std::errc() && height.ptr == end;
  const auto in_range = [](std::uint32_t side) { return side >= 1 && side <= kMaxSide; };
  return whole && in_range(size.width) && in_range(size.height) ? std::optional(size) : std::nullopt;
}

void refuse_picture_size(std::string_view text) {
  fmt::print(stderr, "plugc: `--size {}` is no size; write WIDTHxHEIGHT, e.g. 800x450\n", text);
}

}  // namespace plugc
