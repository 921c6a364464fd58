#include "image/image.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "image/decode_image.h"
#include "image/write_png.h"

namespace plugc {
namespace {

using testing::ElementsAre;

std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Decoded {
  std::optional<Image> image;
  std::vector<std::string> messages;
};

Decoded decode(std::string_view bytes) {
  SourceSet sources;
  const SourceId source = sources.add("scene.x3dv", "url \"p\"");
  Diagnostics diagnostics(sources);
  Decoded result{decode_image(bytes, "p", Span{source, 4, 7}, diagnostics), {}};
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    EXPECT_EQ(diagnostic.id, DiagnosticId::image_invalid);
    EXPECT_EQ(diagnostic.span, (Span{source, 4, 7}));
    result.messages.push_back(diagnostic.message);
  }
  return result;
}

// The fuzzer's seeds are the samples: 5 x 4 pixels, channel c of pixel i (from the top left) is 3 * (4 * i + c).
std::string sample(const std::string& name) {
  return read_file(std::filesystem::path(PLUGC_SOURCE_DIR) / "tests/fuzz/image/corpus" / name);
}

Image image_of(const std::string& name) {
  Decoded decoded = decode(sample(name));
  EXPECT_EQ(decoded.messages, std::vector<std::string>{}) << name;
  return decoded.image.value_or(Image{});
}

std::vector<int> pixel(const Image& image, std::size_t x, std::size_t y) {
  EXPECT_LT(y, image.height);
  const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>((y * image.width + x) * image.channels);
  return {first, first + image.channels};
}

TEST(Png, RowsRunFromTheBottomUp) {
  const Image image = image_of("rgba.png");
  EXPECT_EQ(image.width, 5u);
  EXPECT_EQ(image.height, 4u);
  EXPECT_THAT(pixel(image, 0, 3), ElementsAre(0, 3, 6, 9));
  EXPECT_THAT(pixel(image, 1, 3), ElementsAre(12, 15, 18, 21));
  EXPECT_THAT(pixel(image, 0, 0), ElementsAre(180, 183, 186, 189));
}

TEST(Png, KeepsOneToFourChannels) {
  EXPECT_THAT(pixel(image_of("grey.png"), 1, 3), ElementsAre(12));
  EXPECT_THAT(pixel(image_of("grey_alpha.png"), 1, 3), ElementsAre(12, 15));
  EXPECT_THAT(pixel(image_of("rgb.png"), 1, 3), ElementsAre(12, 15, 18));
}

TEST(Png, ExpandsPalettesAndOtherDepthsToEightBits) {
  EXPECT_EQ(image_of("palette.png").channels, 3u);
  EXPECT_EQ(image_of("palette_transparent.png").channels, 4u);
  EXPECT_EQ(image_of("palette_transparent.png").alpha, AlphaUse::tested);
  EXPECT_EQ(image_of("one_bit.png").pixels.size(), 20u);
  EXPECT_THAT(image_of("one_bit.png").pixels, testing::Each(testing::AnyOf(0, 255)));
  EXPECT_THAT(pixel(image_of("grey16.png"), 1, 3), ElementsAre(12));
  EXPECT_THAT(pixel(image_of("rgba16.png"), 0, 1), ElementsAre(0, 2, 4, 6));
}

TEST(Png, ReadsInterlacedFiles) {
  EXPECT_THAT(image_of("interlaced.png").pixels, ElementsAre(30, 40, 10, 20));
}

TEST(Jpeg, GreyAndColour) {
  const Image grey = image_of("grey.jpg");
  EXPECT_EQ(grey.channels, 1u);
  EXPECT_EQ(grey.width, 20u);
  const Image colour = image_of("rgb.jpg");
  EXPECT_EQ(colour.channels, 3u);
  const std::vector<int> corner = pixel(colour, 1, 1);  // of the lowest row: 180 183 186
  EXPECT_NEAR(corner[0], 180, 12);
  EXPECT_NEAR(corner[2], 186, 12);
}

TEST(Jpeg, ProgressiveAndCmykBecomeRgb) {
  for (const char* name : {"progressive.jpg", "cmyk.jpg"}) {
    const Image image = image_of(name);
    ASSERT_EQ(image.channels, 3u) << name;
    EXPECT_NEAR(pixel(image, 1, 1)[0], 180, 16) << name;
    EXPECT_NEAR(pixel(image, 1, 14)[0], 0, 16) << name;
  }
}

TEST(Dds, AVolumeKeepsItsSlicesAndTurnsTheirRows) {
  const Image image = image_of("volume.dds");  // 1 x 2 x 2 texels BGRA; red counts texels from the top left of slice 0
  EXPECT_EQ(image.depth, 2u);
  EXPECT_THAT(image.pixels, ElementsAre(1, 0, 0, 255, 0, 0, 0, 255, 3, 0, 0, 255, 2, 0, 0, 255));
}

TEST(Dds, ACubeMapIsTurnedOverAndPassesOverMipmaps) {
  const Image image = image_of("cube.dds");  // six faces of 2 x 2 grey texels, each with a mipmap of value 99
  EXPECT_EQ(image.depth, 6u);
  ASSERT_EQ(image.pixels.size(), 24u);
  EXPECT_THAT(std::span(image.pixels).first(8), ElementsAre(2, 3, 0, 1, 6, 7, 4, 5));             // +x, -x: rows from below
  EXPECT_THAT(std::span(image.pixels).subspan(8, 8), ElementsAre(14, 15, 12, 13, 10, 11, 8, 9));  // +y and -y change places
}

TEST(Dds, WhatItCannotHoldIsReported) {
  const std::string good = sample("volume.dds");
  const auto with_byte = [&](std::size_t at, char byte) {
    std::string changed = good;
    changed[at] = byte;
    return decode(changed).messages;
  };
  const std::string prefix = "cannot decode the image `p`: ";
  EXPECT_THAT(decode(good.substr(0, 100)).messages, ElementsAre(prefix + "its header is cut short"));
  EXPECT_THAT(decode(good.substr(0, good.size() - 1)).messages,
              ElementsAre(prefix + "it is cut short: 1 bytes of texels are missing"));
  EXPECT_THAT(with_byte(80, 4), ElementsAre(prefix + "its texels are compressed; save it without compression"));
  EXPECT_THAT(with_byte(95, 1),
              ElementsAre(prefix + "its texels have not 8 bits a channel; save it as RGBA with 8 bits a channel"));
  EXPECT_THAT(with_byte(16, 0), ElementsAre(prefix + "it has no pixels"));
  EXPECT_THAT(with_byte(19, 1), ElementsAre(prefix + "it has 16777217 x 2 x 2 texels; a side may have at most 16384"));
  EXPECT_THAT(with_byte(113, 2), ElementsAre(prefix + "its cube map lacks faces; it needs all six"));
}

/// The header of a TGA picture of 2 x 2 pixels: its type, bits a pixel, and descriptor (0x20: rows from the top down).
std::string tga(char type, char bits, char descriptor, std::string_view pixels) {
  std::string file(18, '\0');
  file[2] = type;
  file[12] = file[14] = 2;
  file[16] = bits;
  file[17] = descriptor;
  return file + std::string(pixels);
}

TEST(Tga, HasItsChannelsInOrderAndItsRowsFromTheBottomUp) {
  using namespace std::string_view_literals;
  const Decoded plain = decode(tga(2, 24, 0, "\1\2\3\4\5\6\7\10\11\12\13\14"sv));
  ASSERT_TRUE(plain.image) << plain.messages.front();
  EXPECT_THAT(plain.image->pixels, ElementsAre(3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10));
  const Decoded from_top = decode(tga(3, 8, 0x20, "\1\2\3\4"sv));
  ASSERT_TRUE(from_top.image);
  EXPECT_THAT(from_top.image->pixels, ElementsAre(3, 4, 1, 2));
  const Decoded from_right = decode(tga(3, 8, 0x10, "\1\2\3\4"sv));
  ASSERT_TRUE(from_right.image);
  EXPECT_THAT(from_right.image->pixels, ElementsAre(2, 1, 4, 3));
}

TEST(Tga, IsUnpacked) {
  using namespace std::string_view_literals;
  const Decoded decoded = decode(tga(10, 32, 8, "\x82\1\2\3\4\0\5\6\7\10"sv));  // a pixel three times, then one
  ASSERT_TRUE(decoded.image) << decoded.messages.front();
  EXPECT_EQ(decoded.image->channels, 4U);
  EXPECT_EQ(decoded.image->alpha, AlphaUse::blended);
  EXPECT_THAT(decoded.image->pixels, ElementsAre(3, 2, 1, 4, 3, 2, 1, 4, 3, 2, 1, 4, 7, 6, 5, 8));
}

TEST(Tga, ReportsWhatIsMissing) {
  using namespace std::string_view_literals;
  const std::string prefix = "cannot decode the image `p`: ";
  EXPECT_THAT(decode(tga(2, 24, 0, "\1\2\3"sv)).messages,
              ElementsAre(prefix + "it is cut short: 9 bytes of pixels are missing"));
  EXPECT_THAT(decode(tga(10, 24, 0, "\x83\1"sv)).messages,
              ElementsAre(prefix + "it is cut short: 8 bytes of pixels are missing"));
  EXPECT_THAT(decode(tga(10, 16, 0, "\1\2\3\4\5\6\7\10"sv)).messages,
              ElementsAre(prefix + "it is none of PNG, JPEG, GIF, BMP, DDS and TGA; convert it to one of them"));
}

TEST(Image, BrokenFilesAreReported) {
  EXPECT_THAT(decode("").messages, ElementsAre("cannot decode the image `p`: the file is empty"));
  EXPECT_THAT(
      decode("RIFF    WEBP").messages,
      ElementsAre("cannot decode the image `p`: it is none of PNG, JPEG, GIF, BMP, DDS and TGA; convert it to one of them"));
  EXPECT_THAT(decode(sample("truncated.png")).messages, ElementsAre("cannot decode the image `p`: the file ends too early"));
  EXPECT_THAT(decode(sample("truncated.jpg")).messages, ElementsAre("cannot decode the image `p`: Premature end of JPEG file"));
  EXPECT_THAT(
      decode(sample("claims_much.png")).messages,
      ElementsAre(testing::MatchesRegex("cannot decode the image `p`: it claims 16000 x 16000 pixels in [0-9]+ bytes")));
}

TEST(Image, SidesBeyondTheLimitAreReported) {
  std::string header = sample("rgb.jpg");
  const std::size_t frame = header.find("\xff\xc0");
  header.replace(frame + 5, 2, std::string("\x50\x00", 2));  // the height
  EXPECT_THAT(decode(header).messages,
              ElementsAre("cannot decode the image `p`: it has 20 x 20480 pixels; a side may have at most 16384"));
}

TEST(AlphaUse, LooksAtEveryAlpha) {
  EXPECT_EQ(alpha_use({1, 2, 4, {1, 2, 3, 255, 1, 2, 3, 255}}), AlphaUse::opaque);
  EXPECT_EQ(alpha_use({1, 2, 4, {1, 2, 3, 255, 1, 2, 3, 0}}), AlphaUse::tested);
  EXPECT_EQ(alpha_use({1, 2, 2, {1, 0, 3, 128}}), AlphaUse::blended);
  EXPECT_EQ(alpha_use({1, 1, 3, {0, 0, 0}}), AlphaUse::opaque);
}

class WritePng : public testing::Test {
 protected:
  std::string path_ = testing::TempDir() + "plugc_write_png_test.png";
  void TearDown() override { std::filesystem::remove(path_); }
};

TEST_F(WritePng, GivesBackWhatWasWritten) {
  const std::vector<std::uint8_t> pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  ASSERT_TRUE(write_png(path_, 2, 2, pixels, true));
  EXPECT_EQ(decode(read_file(path_)).image->pixels, pixels);
  ASSERT_TRUE(write_png(path_, 2, 2, pixels, false));
  EXPECT_THAT(decode(read_file(path_)).image->pixels, ElementsAre(1, 2, 3, 5, 6, 7, 9, 10, 11, 13, 14, 15));
}

TEST_F(WritePng, SaysWhenItCannot) {
  const std::vector<std::uint8_t> pixels(16);
  EXPECT_FALSE(write_png(path_ + "/no/such/folder.png", 2, 2, pixels, true));
  EXPECT_FALSE(write_png(path_, 2, 3, pixels, true)) << "too few pixels";
  EXPECT_FALSE(write_png("/dev/full", 2, 2, pixels, true));
}

}  // namespace
}  // namespace plugc
