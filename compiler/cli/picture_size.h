#pragma once
// The size of a picture as `--size` writes it.

#include <cstdint>
#include <optional>
#include <string_view>

namespace plugc {

struct PictureSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

/// `800x450`; no value for what is none, or out of range.
std::optional<PictureSize> read_picture_size(std::string_view text);

/// Says on stderr what is wrong with it.
void refuse_picture_size(std::string_view text);

}  // namespace plugc
