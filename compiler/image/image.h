#pragma once
// Image files as pixels ready for the GPU.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace plugc {

/// Alpha as the renderer must treat it (X3D 4.1, 12.2.3 alphaMode AUTO): none, every value 0 or 255, or anything between.
enum class AlphaUse : std::uint8_t { opaque, tested, blended };

/// 8 bits a channel, tightly packed. Channels: 1 grey, 2 grey+alpha, 3 RGB, 4 RGBA. A picture or a slice of a volume has its
/// rows from the bottom up; a cube map is six slices, its faces +x -x +y -y +z -z with the texels as OpenGL stores them.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;
  std::vector<std::uint8_t> pixels;  ///< Empty where only facts were asked for.
  std::uint32_t depth = 1;           ///< Slices of a volume, or the six faces of a cube map.
  AlphaUse alpha = AlphaUse::opaque;
};

/// What of an image is wanted: all, or all but the pixels. The file is checked as closely for either.
enum class ImageDetail : std::uint8_t { pixels, facts };

/// Decodes PNG, JPEG, GIF (its first picture), BMP, DDS or TGA, told apart by content. A broken file is reported at `span` and
/// gives nullopt.
std::optional<Image> decode_image(std::string_view bytes, std::string_view name, const Span& span, Diagnostics& diagnostics,
                                  ImageDetail detail = ImageDetail::pixels);

}  // namespace plugc
