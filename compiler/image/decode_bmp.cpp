// A Windows bitmap is a file header, a header of the picture in one of several lengths, colours of a palette or masks of the
// channels, and rows of pixels, each filled up to a multiple of four bytes. Pixels of 1, 4, 8, 16, 24 and 32 bits are read;
// packed ones (run lengths, JPEG, PNG) are not. Alpha counts where a mask names it.
// Source: Microsoft, "Bitmap Storage" (BITMAPFILEHEADER, BITMAPCOREHEADER, BITMAPINFOHEADER, BITMAPV4HEADER).

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

#include "image/decode_image.h"

namespace plugc {
namespace {

constexpr std::size_t kFileHeader = 14, kCoreHeader = 12, kInfoHeader = 40, kHeaderWithAlpha = 56;
constexpr std::uint32_t kPlain = 0, kMasks = 3;  // biCompression

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

struct BmpHeader {
  std::size_t size = 0, pixels_at = 0, width = 0, height = 0, bits = 0, colors = 0;
  std::uint32_t packing = kPlain;
  bool from_top = false;
  std::array<std::uint32_t, 4> masks{};  // red, green, blue, alpha

  bool has_palette() const { return bits <= 8; }
  std::size_t channels() const { return masks[3] != 0 ? 4 : 3; }
  std::size_t row_bytes() const { return (width * bits + 31) / 32 * 4; }
  std::size_t palette_at() const { return kFileHeader + size; }
  std::size_t color_bytes() const { return size == kCoreHeader ? 3 : 4; }
};

/// Where the channels lie when nothing is said.
std::array<std::uint32_t, 4> plain_masks(std::size_t bits) {
  if (bits == 16) return {0x7C00, 0x03E0, 0x001F, 0};
  return {0xFF0000, 0x00FF00, 0x0000FF, 0};
}

void read_masks(std::string_view bytes, BmpHeader& header) {
  constexpr std::size_t kMasksAt = kFileHeader + kInfoHeader;
  header.masks = plain_masks(header.bits);
  if (header.packing != kMasks) return;
  for (std::size_t i = 0; i < 3; ++i) header.masks[i] = number(bytes, kMasksAt + 4 * i, 4);
  if (header.size >= kHeaderWithAlpha) header.masks[3] = number(bytes, kMasksAt + 12, 4);
}

BmpHeader read_header(std::string_view bytes) {
  BmpHeader header;
  header.pixels_at = number(bytes, 10, 4);
  header.size = number(bytes, kFileHeader, 4);
  const bool core = header.size == kCoreHeader;
  const auto height = static_cast<std::int32_t>(core ? number(bytes, 20, 2) : number(bytes, 22, 4));
  header.width = core ? number(bytes, 18, 2) : number(bytes, 18, 4);
  header.from_top = height < 0;
  header.height = header.from_top ? 0U - static_cast<std::uint32_t>(height) : static_cast<std::uint32_t>(height);
  header.bits = number(bytes, core ? 24 : 28, 2);
  header.packing = core ? kPlain : number(bytes, 30, 4);
  header.colors = core ? 0 : number(bytes, 46, 4);
  if (header.colors == 0 && header.has_palette()) header.colors = std::size_t{1} << header.bits;
  if (!header.has_palette()) read_masks(bytes, header);
  return header;
}

std::string header_problem(const BmpHeader& header, std::string_view bytes) {
  constexpr std::array<std::size_t, 6> kBits = {1, 4, 8, 16, 24, 32};
  if (header.size != kCoreHeader && header.size < kInfoHeader) return "its header is of no known length";
  const bool known_bits = std::find(kBits.begin(), kBits.end(), header.bits) != kBits.end();
  const bool known = header.packing == kPlain || (header.packing == kMasks && (header.bits == 16 || header.bits == 32));
  if (!known || !known_bits)
    return fmt::format("its pixels of {} bits are packed in way {}, which is not read; save it without compression",
                       header.bits, header.packing);
  if (std::string problem = size_problem(header.width, header.height, 4, bytes.size()); !problem.empty()) return problem;
  if (header.has_palette() && header.colors > (std::size_t{1} << header.bits)) return "its palette has too many colours";
  const std::size_t needed = header.row_bytes() * header.height;
  const bool complete = header.pixels_at <= bytes.size() && bytes.size() - header.pixels_at >= needed;
  return complete ? "" : "it is cut short: not all of its pixels are there";
}

/// The bits of a mask, scaled to 0 to 255; 255 where there is no mask.
std::uint8_t channel(std::uint32_t pixel, std::uint32_t mask) {
  if (mask == 0) return 255;
  const int shift = std::countr_zero(mask);
  const std::uint64_t largest = mask >> shift;
  return static_cast<std::uint8_t>(((pixel & mask) >> shift) * std::uint64_t{255} / largest);
}

/// Blue, green, red, as the file has it; black for a colour that the palette lacks.
std::uint32_t palette_color(std::string_view bytes, const BmpHeader& header, std::uint32_t index) {
  return index < header.colors ? number(bytes, header.palette_at() + index * header.color_bytes(), 3) : 0;
}

std::uint32_t pixel_at(std::string_view bytes, const BmpHeader& header, std::size_t row, std::size_t x) {
  const std::size_t bit = x * header.bits;
  const std::size_t at = header.pixels_at + row * header.row_bytes() + bit / 8;
  if (!header.has_palette()) return number(bytes, at, header.bits / 8);
  const std::size_t shift = 8 - header.bits - bit % 8;  // the leftmost pixel of a byte is its highest bits
  const std::uint32_t index = (number(bytes, at, 1) >> shift) & ((1U << header.bits) - 1);
  return palette_color(bytes, header, index);
}

}  // namespace

DecodedImage decode_bmp(std::string_view bytes) {
  BmpHeader header = read_header(bytes);
  if (std::string problem = header_problem(header, bytes); !problem.empty()) return {{}, std::move(problem)};
  if (header.has_palette()) header.masks = plain_masks(32);
  Image image;
  allocate(image, header.width, header.height, header.channels());
  std::uint8_t* out = image.pixels.data();
  for (std::size_t y = 0; y < header.height; ++y) {
    const std::size_t row = header.from_top ? header.height - 1 - y : y;
    for (std::size_t x = 0; x < header.width; ++x) {
      const std::uint32_t pixel = pixel_at(bytes, header, row, x);
      for (std::size_t c = 0; c < header.channels(); ++c) *out++ = channel(pixel, header.masks[c]);
    }
  }
  image.alpha = alpha_use(image);
  return {std::move(image), {}};
}

}  // namespace plugc
