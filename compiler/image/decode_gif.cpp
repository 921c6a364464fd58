// GIF through giflib. Only the first picture of the file counts, laid on the screen that the file describes; what it leaves
// open, and its transparent colour, are holes. Further pictures are not read.
// Source: CompuServe, "Graphics Interchange Format", version 89a.

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <gif_lib.h>

#include "image/decode_image.h"

namespace plugc {
namespace {

struct GifReading {
  std::string_view bytes;
  std::size_t offset = 0;
};

int read_bytes(GifFileType* gif, GifByteType* out, int count) {
  auto& reading = *static_cast<GifReading*>(gif->UserData);
  const std::size_t size = std::min(static_cast<std::size_t>(std::max(count, 0)), reading.bytes.size() - reading.offset);
  std::memcpy(out, reading.bytes.data() + reading.offset, size);
  reading.offset += size;
  return static_cast<int>(size);
}

void close(GifFileType* gif) {
  DGifCloseFile(gif, nullptr);
}

using GifFile = std::unique_ptr<GifFileType, decltype(&close)>;

std::string problem_of(int error) {
  const char* const text = GifErrorString(error);
  return text == nullptr ? "it is broken" : fmt::format("giflib says `{}`", text);
}

/// Reads one extension; the index of the transparent colour where it names one, else as it was.
bool read_extension(GifFileType& gif, int& transparent) {
  int code = 0;
  GifByteType* block = nullptr;
  if (DGifGetExtension(&gif, &code, &block) == GIF_ERROR) return false;
  GraphicsControlBlock control{};
  const bool controls = code == GRAPHICS_EXT_FUNC_CODE && block != nullptr;
  if (controls && DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK) transparent = control.TransparentColor;
  while (block != nullptr) {
    if (DGifGetExtensionNext(&gif, &block) == GIF_ERROR) return false;
  }
  return true;
}

/// Goes to the first picture; false at the end of the file, or where it is broken.
bool find_picture(GifFileType& gif, int& transparent) {
  for (;;) {
    GifRecordType type = UNDEFINED_RECORD_TYPE;
    if (DGifGetRecordType(&gif, &type) == GIF_ERROR || type == TERMINATE_RECORD_TYPE) return false;
    if (type == IMAGE_DESC_RECORD_TYPE) return DGifGetImageHeader(&gif) == GIF_OK;
    if (type == EXTENSION_RECORD_TYPE && !read_extension(gif, transparent)) return false;
  }
}

/// The rows of an interlaced picture come in four passes.
std::vector<std::size_t> row_order(std::size_t height, bool interlaced) {
  constexpr std::array<std::pair<std::size_t, std::size_t>, 4> kPasses = {{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  std::vector<std::size_t> rows;
  if (interlaced) {
    for (const auto& [first, step] : kPasses)
      for (std::size_t row = first; row < height; row += step) rows.push_back(row);
  } else {
    for (std::size_t row = 0; row < height; ++row) rows.push_back(row);
  }
  return rows;
}

/// RGBA, on the file's screen, rows from the bottom up.
bool read_pixels(GifFileType& gif, const ColorMapObject& colors, int transparent, Image& image) {
  const GifImageDesc& place = gif.Image;
  std::vector<GifPixelType> line(static_cast<std::size_t>(place.Width));
  for (const std::size_t row : row_order(static_cast<std::size_t>(place.Height), place.Interlace)) {
    if (DGifGetLine(&gif, line.data(), place.Width) == GIF_ERROR) return false;
    const std::size_t y = image.height - 1 - (static_cast<std::size_t>(place.Top) + row);
    std::uint8_t* out = image.pixels.data() + (y * image.width + static_cast<std::size_t>(place.Left)) * 4;
    for (const GifPixelType index : line) {
      if (index != transparent && index < colors.ColorCount) {
        const GifColorType& color = colors.Colors[index];
        const std::uint8_t rgba[] = {color.Red, color.Green, color.Blue, 255};
        std::copy_n(rgba, 4, out);
      }
      out += 4;
    }
  }
  return true;
}

/// Without holes there is no use for alpha.
void drop_full_alpha(Image& image) {
  image.alpha = alpha_use(image);
  if (image.alpha != AlphaUse::opaque) return;
  const std::size_t count = image.pixels.size() / 4;
  for (std::size_t i = 0; i < count; ++i) std::copy_n(image.pixels.data() + i * 4, 3, image.pixels.data() + i * 3);
  image.pixels.resize(count * 3);
  image.channels = 3;
}

}  // namespace

DecodedImage decode_gif(std::string_view bytes) {
  constexpr std::size_t kPackedPixels = 8;  // a code of LZW may stand for thousands of pixels; size_problem() knows how many
  GifReading reading{bytes};
  int error = 0;
  const GifFile gif(DGifOpen(&reading, read_bytes, &error), close);
  if (gif == nullptr) return {{}, problem_of(error)};
  const auto width = static_cast<std::size_t>(gif->SWidth), height = static_cast<std::size_t>(gif->SHeight);
  if (std::string problem = size_problem(width, height, 4, bytes.size() * kPackedPixels); !problem.empty())
    return {{}, std::move(problem)};
  int transparent = NO_TRANSPARENT_COLOR;
  if (!find_picture(*gif, transparent)) return {{}, gif->Error == 0 ? "it holds no picture" : problem_of(gif->Error)};
  const GifImageDesc& place = gif->Image;
  const bool fits = place.Width > 0 && place.Height > 0 && place.Left >= 0 && place.Top >= 0 &&
                    place.Left + place.Width <= gif->SWidth && place.Top + place.Height <= gif->SHeight;
  if (!fits) return {{}, "its picture does not lie on its screen"};
  const ColorMapObject* const colors = place.ColorMap != nullptr ? place.ColorMap : gif->SColorMap;
  if (colors == nullptr) return {{}, "it has no colours"};
  Image image;
  allocate(image, width, height, 4);
  if (!read_pixels(*gif, *colors, transparent, image)) return {{}, problem_of(gif->Error)};
  drop_full_alpha(image);
  return {std::move(image), {}};
}

}  // namespace plugc
