// What a PNG holds besides its colours: its size, and how it uses alpha. Everything is checked that libpng checks: each chunk
// by its checksum, the compressed data by decompressing them, the filter of each row. What is not of the usual kind is left to
// libpng, which also words what is wrong with it. Alpha needs no colours: PNG's filters work on each channel by itself, so
// only the bytes of alpha are unfiltered, and none any more once alpha is known to be between.
//
// Source: ISO/IEC 15948 (PNG), clauses 5 (chunks), 9 (filtering), 10 (compression), 11.2 (critical chunks).

#include <libdeflate.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "image/decode_image.h"

namespace plugc {
namespace {

constexpr std::size_t kSignatureBytes = 8, kHeaderBytes = 13;
constexpr std::size_t kChunkFrame = 12;          // length, type, checksum
constexpr std::size_t kMaxOtherChunk = 1 << 20;  // libpng refuses some that are longer
constexpr std::size_t kFullWindow = 1 << 15;
constexpr std::uint8_t kFilters = 5;  // none, sub, up, average, Paeth

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(bytes[offset + i]);
  return number;
}

struct Chunk {
  std::string_view type, content;
};

/// Takes the next chunk off the front; nullopt where it is cut short or its checksum is wrong.
std::optional<Chunk> take_chunk(std::string_view& bytes) {
  if (bytes.size() < kChunkFrame) return std::nullopt;
  const std::size_t length = number_at(bytes, 0);
  if (length > bytes.size() - kChunkFrame) return std::nullopt;
  const std::string_view checked = bytes.substr(4, 4 + length);
  if (libdeflate_crc32(0, checked.data(), checked.size()) != number_at(bytes, 8 + length)) return std::nullopt;
  bytes.remove_prefix(kChunkFrame + length);
  return Chunk{checked.substr(0, 4), checked.substr(4)};
}

/// Chunks that change nothing of what is asked for here.
bool is_harmless(const Chunk& chunk) {
  const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_letter = [&](char c) { return is_lower(static_cast<char>(c | 0x20)); };
  const bool is_ancillary = is_lower(chunk.type[0]) && std::ranges::all_of(chunk.type, is_letter);
  return is_ancillary && chunk.type != "tRNS" && chunk.content.size() <= kMaxOtherChunk;
}

/// Width, height, bits, colour type, compression, filter method, interlacing.
std::optional<Image> read_header(const Chunk& chunk, std::size_t file_bytes) {
  if (chunk.type != "IHDR" || chunk.content.size() != kHeaderBytes) return std::nullopt;
  if (chunk.content.substr(8, 1) != "\x08" || chunk.content.substr(10) != std::string_view("\0\0\0", 3)) return std::nullopt;
  std::size_t channels = 0;
  switch (chunk.content[9]) {
    case 0: channels = 1; break;
    case 2: channels = 3; break;
    case 4: channels = 2; break;
    case 6: channels = 4; break;
    default: return std::nullopt;
  }
  Image image;
  set_size(image, number_at(chunk.content, 0), number_at(chunk.content, 4), channels);
  if (!size_problem(image.width, image.height, channels, file_bytes).empty()) return std::nullopt;
  return image;
}

/// The compressed data: the content of all IDAT chunks, which follow each other.
std::optional<std::string> take_data(std::string_view bytes) {
  std::string data;
  data.reserve(bytes.size());
  bool was_data = false;
  bool is_over = false;
  while (const std::optional<Chunk> chunk = take_chunk(bytes)) {
    if (chunk->type == "IEND") return data;
    const bool is_data = chunk->type == "IDAT";
    if (is_data ? is_over : !is_harmless(*chunk)) return std::nullopt;
    is_over = was_data && !is_data;
    was_data = was_data || is_data;
    if (is_data) data += chunk->content;
  }
  return std::nullopt;
}

/// How far the data may look back (clause 10.1 with RFC 1950, 2.2): libdeflate lets them go farther, libpng does not.
std::size_t window_bytes(const std::string& data) {
  return std::size_t{256} << (static_cast<std::uint8_t>(data[0]) >> 4);
}

/// The filtered rows.
struct Rows {
  std::unique_ptr<std::uint8_t[]> bytes;  // not zeroed first, which takes as long as some of the decoding
  std::size_t size = 0;
};

/// Exactly so many bytes, from all of the data; else nothing.
std::optional<Rows> decompress(const std::string& data, std::size_t size) {
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (decompressor == nullptr) return std::nullopt;
  Rows rows{std::make_unique_for_overwrite<std::uint8_t[]>(size), size};
  std::size_t used = 0;
  const libdeflate_result result =
      libdeflate_zlib_decompress_ex(decompressor.get(), data.data(), data.size(), rows.bytes.get(), size, &used, nullptr);
  if (result != LIBDEFLATE_SUCCESS || used != data.size()) return std::nullopt;
  return rows;
}

/// What a filter takes off a byte, from the unfiltered bytes to its left, above, and above that one (clause 9.4).
std::uint8_t prediction(std::uint8_t filter, int left, int above, int corner) {
  switch (filter) {
    case 1: return static_cast<std::uint8_t>(left);
    case 2: return static_cast<std::uint8_t>(above);
    case 3: return static_cast<std::uint8_t>((left + above) / 2);
    case 4: {
      const int to_left = std::abs(above - corner);
      const int to_above = std::abs(left - corner);
      const int to_corner = std::abs(left + above - 2 * corner);
      return static_cast<std::uint8_t>(to_left <= to_above && to_left <= to_corner ? left
                                       : to_above <= to_corner                     ? above
                                                                                   : corner);
    }
    default: return 0;
  }
}

/// Turns the alpha of the row above into that of this one. `filtered` is the row's first alpha; `line` begins with a zero, for
/// what is left of the row.
void unfilter_alpha(std::uint8_t filter, const std::uint8_t* filtered, std::size_t channels, std::vector<std::uint8_t>& line) {
  std::uint8_t corner = 0;
  for (std::size_t x = 1; x < line.size(); ++x, filtered += channels) {
    const std::uint8_t above = line[x];
    line[x] = static_cast<std::uint8_t>(*filtered + prediction(filter, line[x - 1], above, corner));
    corner = above;
  }
}

AlphaUse alpha_of_line(const std::vector<std::uint8_t>& line) {
  bool tested = false;
  for (std::size_t x = 1; x < line.size(); ++x) {
    if (line[x] != 0 && line[x] != 255) return AlphaUse::blended;
    tested = tested || line[x] == 0;
  }
  return tested ? AlphaUse::tested : AlphaUse::opaque;
}

/// nullopt where a row has a filter that there is not.
std::optional<AlphaUse> alpha_of_rows(const Rows& rows, const Image& image) {
  const std::size_t row_bytes = 1 + std::size_t{image.width} * image.channels;
  std::vector<std::uint8_t> line(image.width + 1);
  AlphaUse use = AlphaUse::opaque;
  for (const std::uint8_t *row = rows.bytes.get(), *end = row + rows.size; row != end; row += row_bytes) {
    if (row[0] >= kFilters) return std::nullopt;
    if (image.channels % 2 != 0 || use == AlphaUse::blended) continue;
    unfilter_alpha(row[0], row + image.channels, image.channels, line);
    use = std::max(use, alpha_of_line(line));
  }
  return use;
}

}  // namespace

std::optional<Image> scan_png(std::string_view bytes) {
  const std::size_t file_bytes = bytes.size();
  bytes.remove_prefix(kSignatureBytes);
  const std::optional<Chunk> header = take_chunk(bytes);
  std::optional<Image> image = header ? read_header(*header, file_bytes) : std::nullopt;
  const std::optional<std::string> data = image ? take_data(bytes) : std::nullopt;
  if (!data) return std::nullopt;
  const std::size_t size = image->height * (1 + std::size_t{image->width} * image->channels);
  if (data->empty() || data->size() > size || window_bytes(*data) < std::min(size, kFullWindow)) return std::nullopt;
  const std::optional<Rows> rows = decompress(*data, size);
  const std::optional<AlphaUse> alpha = rows ? alpha_of_rows(*rows, *image) : std::nullopt;
  if (!alpha) return std::nullopt;
  image->alpha = *alpha;
  return image;
}

}  // namespace plugc
