// PNG through libpng. Every colour type is expanded to 8 bits of 1 to 4 channels by libpng's own transformations: palettes to
// RGB, fewer bits to 8, transparency chunks to alpha, 16 bits scaled to 8. Gamma chunks are ignored, as texture data is taken
// as it is stored. libpng reports errors by a jump, so the function that calls setjmp owns nothing that must be destroyed.

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <png.h>

#include "image/decode_image.h"

namespace plugc {

namespace {

struct PngReading {
  std::string_view bytes;
  std::size_t offset = 0;
  char problem[160] = {};
};

void note_problem(PngReading& reading, const char* message) {
  std::snprintf(reading.problem, sizeof reading.problem, "%s", message);
}

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto& reading = *static_cast<PngReading*>(png_get_io_ptr(png));
  if (count > reading.bytes.size() - reading.offset) png_error(png, "the file ends too early");
  std::memcpy(out, reading.bytes.data() + reading.offset, count);
  reading.offset += count;
}

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  note_problem(*static_cast<PngReading*>(png_get_error_ptr(png)), message);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void expand_to_eight_bits(png_structp png) {
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_interlace_handling(png);
}

// Reads into `image` and `rows`, which the caller owns; false after a jump or with a problem noted.
bool read_png(png_structp png, png_infop info, PngReading& reading, Image& image, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, &reading, read_bytes);
  png_read_info(png, info);
  expand_to_eight_bits(png);
  png_read_update_info(png, info);
  {
    const std::string problem = size_problem(png_get_image_width(png, info), png_get_image_height(png, info),
                                             png_get_channels(png, info), reading.bytes.size());
    if (!problem.empty()) note_problem(reading, problem.c_str());
  }
  if (reading.problem[0] != 0) return false;
  allocate(image, png_get_image_width(png, info), png_get_image_height(png, info), png_get_channels(png, info));
  rows.resize(image.height);
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = image.pixels.data() + (rows.size() - 1 - y) * image.width * image.channels;
  png_read_image(png, rows.data());
  return true;
}

}  // namespace

DecodedImage decode_png(std::string_view bytes) {
  PngReading reading{.bytes = bytes};
  Image image;
  std::vector<png_bytep> rows;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, on_error, on_warning);
  if (png == nullptr) return {{}, "libpng cannot start"};
  png_infop info = png_create_info_struct(png);
  const bool ok = info != nullptr && read_png(png, info, reading, image, rows);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!ok) return {{}, reading.problem};
  image.alpha = alpha_use(image);
  return {std::move(image), {}};
}

}  // namespace plugc
