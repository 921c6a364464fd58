// The format is told by the first bytes, never by the name. The decoder answers with pixels or with a clause that says what
// is wrong; only this file words the message. Sizes are checked against limits and against the length of the file before
// anything is allocated.

#include "image/decode_image.h"

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpegSignature = "\xff\xd8\xff";
constexpr std::string_view kDdsSignature = "DDS ";
constexpr std::string_view kGifSignature = "GIF8";
constexpr std::string_view kBmpSignature = "BM";

// Deflate packs at most 1032:1 and a one-bit image is expanded eightfold; JPEG stays below that.
constexpr std::size_t kMaxExpansion = 8 * 1032;
constexpr std::size_t kAlwaysAllowed = 1 << 16;

DecodedImage decode_by_content(std::string_view bytes, ImageDetail detail) {
  if (bytes.empty()) return {{}, "the file is empty"};
  if (bytes.starts_with(kPngSignature)) {
    if (detail == ImageDetail::facts) {
      if (std::optional<Image> scanned = scan_png(bytes)) return {std::move(scanned), {}};
    }
    return decode_png(bytes);
  }
  if (bytes.starts_with(kJpegSignature)) return decode_jpeg(bytes, detail);
  if (bytes.starts_with(kDdsSignature)) return decode_dds(bytes);
  if (bytes.starts_with(kGifSignature)) return decode_gif(bytes);
  if (bytes.starts_with(kBmpSignature)) return decode_bmp(bytes);
  if (is_tga(bytes)) return decode_tga(bytes);
  return {{}, "it is none of PNG, JPEG, GIF, BMP, DDS and TGA; convert it to one of them"};
}

}  // namespace

std::string size_problem(std::size_t width, std::size_t height, std::size_t channels, std::size_t file_bytes) {
  if (width == 0 || height == 0) return "it has no pixels";
  if (width > kMaxImageSide || height > kMaxImageSide)
    return fmt::format("it has {} x {} pixels; a side may have at most {}", width, height, kMaxImageSide);
  if (width * height * channels > file_bytes * kMaxExpansion + kAlwaysAllowed)
    return fmt::format("it claims {} x {} pixels in {} bytes", width, height, file_bytes);
  return {};
}

void set_size(Image& image, std::size_t width, std::size_t height, std::size_t channels, std::size_t depth) {
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.depth = static_cast<std::uint32_t>(depth);
  image.channels = static_cast<std::uint32_t>(channels);
}

void allocate(Image& image, std::size_t width, std::size_t height, std::size_t channels, std::size_t depth) {
  set_size(image, width, height, channels, depth);
  image.pixels.resize(width * height * channels * depth);
}

std::optional<Image> decode_image(std::string_view bytes, std::string_view name, const Span& span, Diagnostics& diagnostics,
                                  ImageDetail detail) {
  DecodedImage decoded = decode_by_content(bytes, detail);
  if (!decoded.image)
    diagnostics.report(DiagnosticId::image_invalid, span,
                       fmt::format("cannot decode the image `{}`: {}", name, decoded.problem));
  else if (detail == ImageDetail::facts)
    decoded.image->pixels = {};
  return std::move(decoded.image);
}

AlphaUse alpha_use(const Image& image) {
  if (image.channels != 2 && image.channels != 4) return AlphaUse::opaque;
  AlphaUse use = AlphaUse::opaque;
  for (std::size_t i = image.channels - 1; i < image.pixels.size(); i += image.channels) {
    const std::uint8_t alpha = image.pixels[i];
    if (alpha != 0 && alpha != 255) return AlphaUse::blended;
    if (alpha == 0) use = AlphaUse::tested;
  }
  return use;
}

}  // namespace plugc
