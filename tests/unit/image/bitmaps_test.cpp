// GIF and BMP, from the fuzzer's seeds: 5 x 4 pixels, channel c of pixel i (from the top left) is 3 * (4 * i + c).

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "image/decode_image.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string sample(const std::string& name) {
  const auto path = std::filesystem::path(PLUGC_SOURCE_DIR) / "tests/fuzz/image/corpus" / name;
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Image image_of(const DecodedImage& decoded) {
  EXPECT_EQ(decoded.problem, "");
  return decoded.image.value_or(Image{});
}

Image gif(const std::string& name) {
  return image_of(decode_gif(sample(name)));
}

Image bmp(const std::string& name) {
  return image_of(decode_bmp(sample(name)));
}

/// From the top left.
std::vector<int> pixel(const Image& image, std::size_t x, std::size_t y) {
  EXPECT_LT(y, image.height);
  const std::size_t row = image.height - 1 - y;
  const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>((row * image.width + x) * image.channels);
  return {first, first + image.channels};
}

TEST(Gif, ColoursOfThePaletteFromTheBottomUp) {
  const Image image = gif("rgb.gif");
  EXPECT_EQ(image.width, 5U);
  EXPECT_EQ(image.height, 4U);
  EXPECT_EQ(image.channels, 3U);
  EXPECT_THAT(pixel(image, 1, 0), ElementsAre(12, 15, 18));
  EXPECT_THAT(pixel(image, 0, 3), ElementsAre(180, 183, 186));
}

TEST(Gif, InterlacedRowsFindTheirPlaces) {
  EXPECT_EQ(gif("interlaced.gif").pixels, gif("rgb.gif").pixels);
}

TEST(Gif, TheTransparentColourIsAHole) {
  const Image image = gif("transparent.gif");
  EXPECT_EQ(image.channels, 4U);
  EXPECT_EQ(image.alpha, AlphaUse::tested);
  EXPECT_THAT(pixel(image, 1, 1), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(pixel(image, 2, 1), ElementsAre(84, 87, 90, 255));
}

TEST(Gif, SaysWhatIsBroken) {
  EXPECT_THAT(decode_gif(sample("truncated.gif")).problem, HasSubstr("giflib says"));
  EXPECT_EQ(decode_gif(sample("no_picture.gif")).problem, "it holds no picture");
  EXPECT_THAT(decode_gif(sample("claims_much.gif")).problem, HasSubstr("it claims 16000 x 16000 pixels"));
}

TEST(Bmp, AllHeadersAndDirectionsGiveThePicture) {
  const Image image = bmp("rgb.bmp");
  EXPECT_EQ(image.channels, 3U);
  EXPECT_THAT(pixel(image, 1, 0), ElementsAre(12, 15, 18));
  EXPECT_THAT(pixel(image, 0, 3), ElementsAre(180, 183, 186));
  for (const char* name : {"from_top.bmp", "core.bmp", "palette.bmp"}) EXPECT_EQ(bmp(name).pixels, image.pixels) << name;
}

TEST(Bmp, MasksSayWhereChannelsAre) {
  const Image image = bmp("rgba.bmp");
  EXPECT_EQ(image.channels, 4U);
  EXPECT_THAT(pixel(image, 1, 0), ElementsAre(12, 15, 18, 21));
  EXPECT_THAT(pixel(bmp("five_bits.bmp"), 1, 0), ElementsAre(255, 8, 0));
}

TEST(Bmp, TheLeftmostPixelOfAByteIsItsHighestBits) {
  const Image image = bmp("one_bit.bmp");
  EXPECT_THAT(pixel(image, 0, 3), ElementsAre(255, 255, 255));
  EXPECT_THAT(pixel(image, 1, 3), ElementsAre(0, 0, 0));
  EXPECT_THAT(pixel(image, 0, 2), ElementsAre(0, 0, 0));
}

TEST(Bmp, SaysWhatIsBroken) {
  EXPECT_THAT(decode_bmp(sample("packed.bmp")).problem, HasSubstr("packed in way 1"));
  EXPECT_THAT(decode_bmp(sample("claims_much.bmp")).problem, HasSubstr("it claims 16000 x 16000 pixels"));
  EXPECT_EQ(decode_bmp(sample("rgb.bmp").substr(0, 80)).problem, "it is cut short: not all of its pixels are there");
  EXPECT_EQ(decode_bmp("BM").problem, "its header is of no known length");
}

}  // namespace
}  // namespace plugc
