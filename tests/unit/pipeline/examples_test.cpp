// Every example that is a scene still draws the picture that its README shows.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/diagnostics.h"
#include "image/image.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

Image read_picture(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  SourceSet sources;
  Diagnostics diagnostics(sources);
  auto image = decode_image(bytes, path.string(), {}, diagnostics);
  return image ? std::move(*image) : Image();
}

/// Mean absolute difference of all channels, 0 to 255; 255 for pictures of different sizes.
double mean_difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels || a.pixels.empty()) return 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
  return sum / static_cast<double>(a.pixels.size());
}

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, DrawsThePictureOfItsReadme) {
  const fs::path folder = fs::path(PLUGC_SOURCE_DIR) / "examples" / GetParam();
  const Image expected = read_picture(folder / (GetParam() + ".png"));
  ASSERT_GT(expected.width, 0U);
  const fs::path drawn = fs::path(testing::TempDir()) / (GetParam() + ".png");
  const std::string command = std::string(PLUGC_BINARY_DIR) + "/bin/plugc preview " +
                              (folder / (GetParam() + ".x3dv")).string() + " -o " + drawn.string() +
                              " --samples 4 --no-cache --size " + std::to_string(expected.width) + "x" +
                              std::to_string(expected.height);
  ASSERT_EQ(std::system(command.c_str()), 0);
  // one rasteriser, one picture: what is left is rounding between code generators
  EXPECT_LT(mean_difference(read_picture(drawn), expected), 0.5);
}

std::vector<std::string> examples() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(PLUGC_SOURCE_DIR) / "examples")) {
    const std::string name = entry.path().filename().string();
    if (fs::exists(entry.path() / (name + ".x3dv"))) names.push_back(name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, Example, testing::ValuesIn(examples()), [](const auto& name) { return name.param; });

}  // namespace
}  // namespace plugc
