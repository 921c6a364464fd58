// A Truevision TGA picture is a header of 18 bytes, a name, and pixels in rows: as they are, or in packets that repeat one
// pixel or spell out several. Grey, and blue, green, red with or without alpha are read. The format has no signature at its
// beginning, so the header's fields must all make sense together.
// Source: Truevision, "TGA File Format Specification", version 2.0.

#include <algorithm>

#include <fmt/format.h>

#include "image/decode_image.h"

namespace plugc {
namespace {

constexpr std::size_t kHeaderBytes = 18;
constexpr unsigned kPacked = 8;  // of the image type
constexpr unsigned kTrueColor = 2, kGrey = 3;
constexpr unsigned kFromRight = 0x10, kFromTop = 0x20, kInterleaved = 0xC0;  // of the descriptor
constexpr unsigned kRepeats = 0x80;                                          // of a packet's first byte

struct TgaHeader {
  std::size_t name_bytes = 0, width = 0, height = 0, bits = 0;
  unsigned palette = 0, type = 0, descriptor = 0;

  unsigned colors() const { return type & ~kPacked; }
  bool is_packed() const { return (type & kPacked) != 0; }
  std::size_t pixel_bytes() const { return bits / 8; }
};

unsigned byte_at(std::string_view bytes, std::size_t offset) {
  return static_cast<unsigned char>(bytes[offset]);
}

TgaHeader read_header(std::string_view bytes) {
  const auto number = [&](std::size_t offset) { return byte_at(bytes, offset) + 256 * byte_at(bytes, offset + 1); };
  TgaHeader header;
  header.name_bytes = byte_at(bytes, 0);
  header.palette = byte_at(bytes, 1);
  header.type = byte_at(bytes, 2);
  header.width = number(12);
  header.height = number(14);
  header.bits = byte_at(bytes, 16);
  header.descriptor = byte_at(bytes, 17);
  return header;
}

bool makes_sense(const TgaHeader& header) {
  const bool colored = header.colors() == kTrueColor && (header.bits == 24 || header.bits == 32);
  const bool grey = header.colors() == kGrey && header.bits == 8;
  return header.palette == 0 && header.type <= (kGrey | kPacked) && (colored || grey) &&
         (header.descriptor & kInterleaved) == 0;
}

/// The packets spelled out, up to `wanted` bytes.
std::string unpacked(std::string_view packets, std::size_t pixel_bytes, std::size_t wanted) {
  std::string pixels;
  for (std::size_t at = 0; at < packets.size() && pixels.size() < wanted;) {
    const unsigned head = byte_at(packets, at++);
    const std::size_t count = (head & ~kRepeats) + 1;
    const bool repeats = (head & kRepeats) != 0;
    const std::string_view body = packets.substr(at, (repeats ? 1 : count) * pixel_bytes);
    for (std::size_t i = 0; i < (repeats ? count : 1); ++i) pixels += body;
    at += body.size();
  }
  return pixels;
}

/// Rows from the bottom up, from left to right, blue last.
void copy_pixels(std::string_view pixels, const TgaHeader& header, Image& image) {
  const std::size_t size = header.pixel_bytes();
  std::uint8_t* out = image.pixels.data();
  for (std::size_t y = 0; y < header.height; ++y) {
    const std::size_t row = (header.descriptor & kFromTop) != 0 ? header.height - 1 - y : y;
    for (std::size_t x = 0; x < header.width; ++x) {
      const std::size_t column = (header.descriptor & kFromRight) != 0 ? header.width - 1 - x : x;
      const std::string_view pixel = pixels.substr((row * header.width + column) * size, size);
      std::transform(pixel.begin(), pixel.end(), out, [](char c) { return static_cast<std::uint8_t>(c); });
      if (size >= 3) std::swap(out[0], out[2]);
      out += size;
    }
  }
}

}  // namespace

bool is_tga(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes && makes_sense(read_header(bytes));
}

DecodedImage decode_tga(std::string_view bytes) {
  const TgaHeader header = read_header(bytes);
  if (std::string problem = size_problem(header.width, header.height, header.pixel_bytes(), bytes.size()); !problem.empty())
    return {{}, std::move(problem)};
  std::string_view pixels = bytes.substr(std::min(bytes.size(), kHeaderBytes + header.name_bytes));
  const std::size_t wanted = header.width * header.height * header.pixel_bytes();
  std::string spelled_out;
  if (header.is_packed()) pixels = spelled_out = unpacked(pixels, header.pixel_bytes(), wanted);
  if (pixels.size() < wanted)
    return {{}, fmt::format("it is cut short: {} bytes of pixels are missing", wanted - pixels.size())};
  Image image;
  allocate(image, header.width, header.height, header.pixel_bytes());
  copy_pixels(pixels, header, image);
  image.alpha = alpha_use(image);
  return {std::move(image), {}};
}

}  // namespace plugc
