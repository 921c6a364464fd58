// A quick file has one filter (SUB) and, of zlib, only runs (Z_RLE): what is drawn is smooth along a row, so that its
// differences run. Searching for longer matches takes up to half as long again, for files between an eighth larger and a
// twelfth smaller. libpng strips the fourth byte of a pixel itself where no alpha is wanted.

#include "image/write_png.h"

#include <csetjmp>
#include <cstdio>
#include <memory>

#include <png.h>
#include <zlib.h>

namespace plugc {

namespace {

constexpr int kQuickLevel = 1;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void write_rows(png_structp png, std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba) {
  for (std::size_t y = height; y-- > 0;) png_write_row(png, rgba + y * width * 4);
}

bool write_image(png_structp png, png_infop info, std::FILE* file, std::uint32_t width, std::uint32_t height,
                 const std::uint8_t* rgba, bool alpha, PngEffort effort) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_init_io(png, file);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, effort == PngEffort::quick ? PNG_FILTER_SUB : PNG_ALL_FILTERS);
  png_set_compression_level(png, effort == PngEffort::quick ? kQuickLevel : Z_BEST_COMPRESSION);
  if (effort == PngEffort::quick) png_set_compression_strategy(png, Z_RLE);
  png_set_IHDR(png, info, width, height, 8, alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (!alpha) png_set_filler(png, 0, PNG_FILLER_AFTER);
  write_rows(png, width, height, rgba);
  png_write_end(png, nullptr);
  return true;
}

void on_warning(png_structp, png_const_charp) {}

[[noreturn]] void on_error(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}

}  // namespace

bool write_png(const std::string& path, std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba,
               bool alpha, PngEffort effort) {
  if (rgba.size() / 4 < std::size_t{width} * height) return false;
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wb"));
  if (!file) return false;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  const bool ok = info != nullptr && write_image(png, info, file.get(), width, height, rgba.data(), alpha, effort);
  png_destroy_write_struct(&png, &info);
  return ok && std::fflush(file.get()) == 0;
}

}  // namespace plugc
