// A DirectDraw surface is a header of 128 bytes and then texels, here without compression: for each face of a cube map its
// picture and its mipmaps, else all slices of the volume and then those of its mipmaps. Channels are found by bit masks,
// which must be whole bytes. Every size is checked against the length of the file before anything is allocated.
// Source: Microsoft, "Programming Guide for DDS" (DDS_HEADER, DDS_PIXELFORMAT).

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

#include "base/limits.h"
#include "image/decode_image.h"

namespace plugc {
namespace {

constexpr std::size_t kHeaderBytes = 128;
constexpr std::uint32_t kHasAlpha = 0x1, kCompressed = 0x4;                        // pixel format flags
constexpr std::uint32_t kCubeMap = 0x200, kAllFaces = 0xFE00, kVolume = 0x200000;  // second capabilities
constexpr std::uint32_t kMaxMipmaps = 32;

struct DdsHeader {
  std::size_t width = 0, height = 0, depth = 1, mipmaps = 1;
  std::uint32_t format_flags = 0, bits = 0, capabilities = 0;
  std::array<std::uint32_t, 4> masks{};  // red (or grey), green, blue, alpha

  bool is_cube() const { return (capabilities & kCubeMap) != 0; }
  bool is_volume() const { return (capabilities & kVolume) != 0; }
  std::size_t texel_bytes() const { return bits / 8; }
};

/// The little-endian number at a multiple of four.
std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= std::uint32_t{static_cast<std::uint8_t>(bytes[offset + i])} << (8 * i);
  return number;
}

DdsHeader read_header(std::string_view bytes) {
  DdsHeader header;
  header.height = number_at(bytes, 12);
  header.width = number_at(bytes, 16);
  header.mipmaps = std::max(number_at(bytes, 28), 1U);
  header.format_flags = number_at(bytes, 80);
  header.bits = number_at(bytes, 88);
  for (std::size_t i = 0; i < header.masks.size(); ++i) header.masks[i] = number_at(bytes, 92 + 4 * i);
  if ((header.format_flags & kHasAlpha) == 0) header.masks[3] = 0;
  header.capabilities = number_at(bytes, 112);
  if (header.is_volume()) header.depth = number_at(bytes, 24);
  return header;
}

/// The byte of a texel that a mask picks. The mask must not be zero.
std::size_t byte_of(std::uint32_t mask) {
  return static_cast<std::size_t>(std::countr_zero(mask)) / 8;
}

/// Grey or RGB, with or without alpha, each in a byte of its own.
bool has_usable_channels(const DdsHeader& header) {
  const auto& [red, green, blue, alpha] = header.masks;
  const auto is_byte = [&](std::uint32_t mask) {
    return mask == 0 || (byte_of(mask) < header.texel_bytes() && (mask >> (8 * byte_of(mask))) == 0xFF);
  };
  return header.bits % 8 == 0 && header.bits <= 32 && red != 0 && (green == 0) == (blue == 0) &&
         std::ranges::all_of(header.masks, is_byte);
}

/// Bytes of the texels of one face, or of the whole volume, with `levels` levels of mipmaps.
std::size_t level_bytes(const DdsHeader& header, std::size_t levels) {
  std::size_t sum = 0;
  for (std::size_t level = 0; level < levels; ++level) {
    const auto side = [level](std::size_t full) { return std::max<std::size_t>(full >> level, 1); };
    sum += side(header.width) * side(header.height) * side(header.depth) * header.texel_bytes();
  }
  return sum;
}

std::string format_problem(const DdsHeader& header) {
  if ((header.format_flags & kCompressed) != 0) return "its texels are compressed; save it without compression";
  if (!has_usable_channels(header)) return "its texels have not 8 bits a channel; save it as RGBA with 8 bits a channel";
  if (header.is_cube() && (header.capabilities & kAllFaces) != kAllFaces) return "its cube map lacks faces; it needs all six";
  if (header.is_cube() && header.width != header.height) return "the faces of its cube map are not square";
  return {};
}

std::string sizes_problem(const DdsHeader& header, std::size_t file_bytes) {
  const std::size_t largest = std::max({header.width, header.height, header.depth});
  if (std::min({header.width, header.height, header.depth}) == 0) return "it has no pixels";
  if (largest > kMaxImageSide || header.mipmaps > kMaxMipmaps)
    return fmt::format("it has {} x {} x {} texels; a side may have at most {}", header.width, header.height, header.depth,
                       kMaxImageSide);
  const std::size_t faces = header.is_cube() ? 6 : 1;
  const std::size_t needed = (faces - 1) * level_bytes(header, header.mipmaps) + level_bytes(header, 1);
  if (needed > file_bytes - kHeaderBytes)
    return fmt::format("it is cut short: {} bytes of texels are missing", needed - (file_bytes - kHeaderBytes));
  return {};
}

/// Which bytes of a texel are the channels of the image: grey, grey and alpha, RGB or RGBA.
std::vector<std::size_t> channel_bytes(const DdsHeader& header) {
  std::vector<std::size_t> bytes;
  for (const std::uint32_t mask : header.masks) {
    if (mask != 0) bytes.push_back(byte_of(mask));
  }
  return bytes;
}

/// A cube is turned over top to bottom as a whole: the reference engine shows the face that the file calls +y below, and each
/// other face upside down.
std::size_t face_in_file(std::size_t face) {
  constexpr std::size_t kPositiveY = 2, kNegativeY = 3;
  return face == kPositiveY ? kNegativeY : face == kNegativeY ? kPositiveY : face;
}

/// Slice by slice; rows, which stand from the top down, are turned over.
void copy_texels(std::string_view texels, const DdsHeader& header, const std::vector<std::size_t>& channels, Image& image) {
  const std::size_t face_bytes = level_bytes(header, header.is_cube() ? header.mipmaps : 1);
  const std::size_t row_bytes = header.width * header.texel_bytes();
  std::uint8_t* out = image.pixels.data();
  for (std::size_t slice = 0; slice < image.depth; ++slice) {
    const std::size_t slice_begin = header.is_cube() ? face_in_file(slice) * face_bytes : slice * row_bytes * header.height;
    for (std::size_t row = 0; row < header.height; ++row) {
      const std::size_t row_begin = slice_begin + (header.height - 1 - row) * row_bytes;
      for (std::size_t x = 0; x < header.width; ++x) {
        for (const std::size_t byte : channels)
          *out++ = static_cast<std::uint8_t>(texels[row_begin + x * header.texel_bytes() + byte]);
      }
    }
  }
}

}  // namespace

DecodedImage decode_dds(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return {{}, "its header is cut short"};
  const DdsHeader header = read_header(bytes);
  if (std::string problem = format_problem(header); !problem.empty()) return {{}, std::move(problem)};
  if (std::string problem = sizes_problem(header, bytes.size()); !problem.empty()) return {{}, std::move(problem)};
  const std::vector<std::size_t> channels = channel_bytes(header);
  Image image;
  allocate(image, header.width, header.height, channels.size(), header.is_cube() ? 6 : header.depth);
  copy_texels(bytes.substr(kHeaderBytes), header, channels, image);
  image.alpha = alpha_use(image);
  return {std::move(image), {}};
}

}  // namespace plugc
