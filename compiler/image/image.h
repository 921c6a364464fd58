#pragma once
// Image files as pixels ready for the GPU.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace plugc {

/// 8 bits a channel, rows from the bottom up, tightly packed. Channels: 1 grey, 2 grey+alpha, 3 RGB, 4 RGBA.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;
  std::vector<std::uint8_t> pixels;
};

/// Alpha as the renderer must treat it (X3D 4.1, 12.2.3 alphaMode AUTO): none, every value 0 or 255, or anything between.
enum class AlphaUse : std::uint8_t { opaque, tested, blended };
AlphaUse alpha_use(const Image& image);

/// Decodes PNG or JPEG, told apart by content. A broken file is reported at `span` and gives nullopt.
std::optional<Image> decode_image(std::string_view bytes, std::string_view name, const Span& span, Diagnostics& diagnostics);

}  // namespace plugc
