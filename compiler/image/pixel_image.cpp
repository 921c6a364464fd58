// A pixel is one integer whose bytes are its channels, the highest first; PixelTexture3D writes some of them as negative
// numbers, as its integers have 32 bits and a sign.

#include "image/pixel_image.h"

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {
namespace {

/// 0 for what is no size.
std::size_t size_at(std::span<const double> numbers, std::size_t index) {
  if (index >= numbers.size() || !(numbers[index] >= 0) || numbers[index] > kMaxImageSide) return 0;
  return static_cast<std::size_t>(numbers[index]);
}

DecodedImage read_pixels(std::span<const double> pixels, std::size_t channels, std::size_t width, std::size_t height,
                         std::size_t depth) {
  const std::size_t count = width * height * depth;
  if (count == 0 && pixels.empty()) return {};
  if (count == 0 || channels < 1 || channels > 4)
    return {{},
            fmt::format("its size or its number of components is none; components are 1 to 4, a side 1 to {}", kMaxImageSide)};
  if (pixels.size() < count) return {{}, fmt::format("it has {} pixels, but its size asks for {}", pixels.size(), count)};
  Image image;
  allocate(image, width, height, channels, depth);
  std::uint8_t* out = image.pixels.data();
  for (const double pixel : pixels.first(count)) {
    const bool fits = pixel >= -2147483648.0 && pixel <= 4294967295.0;
    const auto value = static_cast<std::uint32_t>(fits ? static_cast<std::int64_t>(pixel) : 0);
    for (std::size_t channel = channels; channel-- > 0;) *out++ = static_cast<std::uint8_t>(value >> (8 * channel));
  }
  image.alpha = alpha_use(image);
  return {std::move(image), {}};
}

}  // namespace

DecodedImage image_of_pixels(std::span<const double> numbers) {
  const auto pixels = numbers.size() > 3 ? numbers.subspan(3) : std::span<const double>();
  return read_pixels(pixels, size_at(numbers, 2), size_at(numbers, 0), size_at(numbers, 1), 1);
}

DecodedImage volume_of_pixels(std::span<const double> numbers) {
  const auto pixels = numbers.size() > 4 ? numbers.subspan(4) : std::span<const double>();
  return read_pixels(pixels, size_at(numbers, 0), size_at(numbers, 1), size_at(numbers, 2), size_at(numbers, 3));
}

}  // namespace plugc
