// An image without its pixels: the same facts, and the same word on what is wrong, as when it is decoded.

#include <gmock/gmock.h>
#include <png.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "image/decode_image.h"

namespace plugc {
namespace {

constexpr std::uint32_t kSide = 40;

/// What is known of an image, as text; or the message.
std::string outcome(std::string_view bytes, ImageDetail detail) {
  const SourceSet sources;
  Diagnostics diagnostics(sources);
  const std::optional<Image> image = decode_image(bytes, "p", {}, diagnostics, detail);
  if (!image) return diagnostics.all()[0].message;
  EXPECT_EQ(image->pixels.empty(), detail == ImageDetail::facts);
  std::string text;
  for (const std::uint32_t fact :
       {image->width, image->height, image->depth, image->channels, static_cast<std::uint32_t>(image->alpha)})
    text += std::to_string(fact) + " ";
  return text;
}

void expect_same(std::string_view bytes) {
  EXPECT_EQ(outcome(bytes, ImageDetail::facts), outcome(bytes, ImageDetail::pixels));
}

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// A PNG of noise, whose alpha is picked from `alphas`, all of its rows with one filter.
std::string noise_png(int color_type, int filter, const std::vector<std::uint8_t>& alphas) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, kSide, kSide, 8, color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, filter);
  png_set_compression_window_bits(png, 15);
  png_write_info(png, info);
  const std::size_t channels = png_get_channels(png, info);
  const bool has_alpha = channels % 2 == 0;
  std::uint32_t random = 1;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    std::vector<std::uint8_t> row(kSide * channels);
    for (std::size_t i = 0; i < row.size(); ++i) {
      random = random * 1664525U + 1013904223U;
      const bool is_alpha = has_alpha && i % channels == channels - 1;
      row[i] = is_alpha ? alphas[(random >> 16) % alphas.size()] : static_cast<std::uint8_t>((random >> 24) & 7);
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

TEST(ImageFacts, EveryFilterGivesBackAlpha) {
  const std::vector<std::pair<std::vector<std::uint8_t>, AlphaUse>> cases = {
      {{255}, AlphaUse::opaque}, {{0, 255}, AlphaUse::tested}, {{0, 255, 9, 77, 201}, AlphaUse::blended}};
  for (const int filter : {PNG_FILTER_NONE, PNG_FILTER_SUB, PNG_FILTER_UP, PNG_FILTER_AVG, PNG_FILTER_PAETH}) {
    for (const int type : {PNG_COLOR_TYPE_RGBA, PNG_COLOR_TYPE_GRAY_ALPHA}) {
      for (const auto& [alphas, use] : cases) {
        const std::string png = noise_png(type, filter, alphas);
        const std::optional<Image> scanned = scan_png(png);
        ASSERT_TRUE(scanned) << filter << " " << type;
        EXPECT_EQ(scanned->alpha, use) << filter << " " << type;
        expect_same(png);
      }
    }
  }
}

TEST(ImageFacts, AlmostOpaqueIsSeenInTheLastPixelToo) {
  std::vector<std::uint8_t> alphas(5000, 255);
  alphas.back() = 254;
  expect_same(noise_png(PNG_COLOR_TYPE_RGBA, PNG_FILTER_PAETH, alphas));
}

TEST(ImageFacts, PicturesWithoutAlphaAreScannedToo) {
  for (const int type : {PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_GRAY}) {
    const std::string png = noise_png(type, PNG_ALL_FILTERS, {});
    EXPECT_TRUE(scan_png(png)) << type;
    expect_same(png);
  }
}

/// The fuzzer's seeds: every format, among them broken ones.
TEST(ImageFacts, AreThoseOfTheDecodedImage) {
  for (const auto& entry : std::filesystem::directory_iterator(PLUGC_SOURCE_DIR "/tests/fuzz/image/corpus")) {
    SCOPED_TRACE(entry.path());
    std::ifstream stream(entry.path(), std::ios::binary);
    expect_same(std::string(std::istreambuf_iterator<char>(stream), {}));
  }
}

TEST(ImageFacts, WhereverAFileIsCutOrChangedTheSameIsSaid) {
  const std::string png = noise_png(PNG_COLOR_TYPE_RGBA, PNG_ALL_FILTERS, {0, 255});
  for (std::size_t i = 0; i < png.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same(std::string_view(png).substr(0, i));
    std::string changed = png;
    changed[i] = static_cast<char>(changed[i] ^ 0x20);
    expect_same(changed);
  }
}

/// The last four bytes of each chunk made right, so that what was changed is not noticed by them.
void renew_checksums(std::string& png) {
  const auto number_at = [&](std::size_t at) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(png[at + i]);
    return number;
  };
  for (std::size_t chunk = 8; chunk + 12 <= png.size() && number_at(chunk) + 12 <= png.size() - chunk;) {
    const std::size_t checked = number_at(chunk) + 4;
    auto sum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(png.data() + chunk + 4), static_cast<uInt>(checked)));
    for (std::size_t i = 4; i-- > 0; sum >>= 8) png[chunk + 4 + checked + i] = static_cast<char>(sum);
    chunk += checked + 8;
  }
}

TEST(ImageFacts, ChangesThatChecksumsHideAreFoundAsWell) {
  const std::string png = noise_png(PNG_COLOR_TYPE_GRAY_ALPHA, PNG_ALL_FILTERS, {0, 255});
  for (std::size_t i = 8; i < png.size(); ++i) {
    for (const char bit : {1, 16, 64}) {
      SCOPED_TRACE(i);
      std::string changed = png;
      changed[i] = static_cast<char>(changed[i] ^ bit);
      renew_checksums(changed);
      expect_same(changed);
    }
  }
}

}  // namespace
}  // namespace plugc
