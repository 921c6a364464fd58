// Every scene of this folder draws the picture beside it, and nothing is said of it. Where the two differ, what was drawn and
// the difference, four times as strong, are written into the build folder. PLUGC_REWRITE=1 writes pictures that are missing or
// differ, and the page of all of them; look at each before it is committed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "image/image.h"
#include "image/write_png.h"
#include "pictures/picture_scenes.h"
#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWidth = 160, kHeight = 120;

// One rasteriser, one picture: what is left is rounding between code generators, which at an edge may be a sample of a pixel.
constexpr int kMostOff = 64;  // of 255, of any channel
constexpr double kMeanOff = 0.25;

bool is_rewriting() {
  return std::getenv("PLUGC_REWRITE") != nullptr;
}

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Picture draw(const PictureScene& scene) {
  CompileOptions options;
  options.root = PLUGC_SOURCE_DIR "/tests/pictures";
  const Compiled compiled = compile_file(scene.scene, options);
  EXPECT_THAT(compiled.messages(), testing::IsEmpty());
  FrameOptions frame;
  frame.width = kWidth;
  frame.height = kHeight;
  frame.samples = 4;
  return draw_package(*compiled.package, frame);
}

/// RGBA, as the renderer gives it; empty where there is no picture yet.
Picture read_picture(const fs::path& path) {
  const std::string bytes = read_file(path);
  if (bytes.empty()) return {};
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const auto image = decode_image(bytes, path.string(), {}, diagnostics);
  if (!image || image->channels != 3) return {};
  Picture picture{image->width, image->height, {}};
  for (std::size_t i = 0; i < image->pixels.size(); i += 3) {
    picture.pixels.insert(picture.pixels.end(), image->pixels.begin() + static_cast<std::ptrdiff_t>(i),
                          image->pixels.begin() + static_cast<std::ptrdiff_t>(i + 3));
    picture.pixels.push_back(255);
  }
  return picture;
}

struct Difference {
  int most = 255;
  double mean = 255;
  Picture picture;  ///< Four times as strong.
  bool is_small() const { return most <= kMostOff && mean <= kMeanOff; }
};

Difference compare(const Picture& drawn, const Picture& expected) {
  Difference difference;
  if (drawn.pixels.size() != expected.pixels.size() || drawn.width != expected.width || drawn.pixels.empty()) return difference;
  difference.picture = drawn;
  difference.most = 0;
  double sum = 0;
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const int off = std::abs(drawn.pixels[i] - expected.pixels[i]);
    difference.most = std::max(difference.most, off);
    difference.picture.pixels[i] = static_cast<std::uint8_t>(std::min(4 * off, 255));
    sum += off;
  }
  difference.mean = sum / (static_cast<double>(drawn.pixels.size()) * 3 / 4);
  return difference;
}

void write(const fs::path& path, const Picture& picture, PngEffort effort) {
  EXPECT_TRUE(write_png(path.string(), picture.width, picture.height, picture.pixels, false, effort)) << path;
}

/// Where to look.
std::string write_evidence(const PictureScene& scene, const Picture& drawn, const Difference& difference) {
  const fs::path folder = PLUGC_BINARY_DIR "/pictures";
  fs::create_directories(folder);
  const fs::path as_drawn = folder / fmt::format("{}_{}.png", scene.group, scene.name);
  write(as_drawn, drawn, PngEffort::quick);
  if (difference.picture.pixels.empty())
    return fmt::format("no picture of that size to compare with; drawn: {}", as_drawn.string());
  const fs::path as_difference = folder / fmt::format("{}_{}_difference.png", scene.group, scene.name);
  write(as_difference, difference.picture, PngEffort::quick);
  return fmt::format("drawn: {}\ndifference: {}", as_drawn.string(), as_difference.string());
}

class PictureTest : public testing::Test {
 public:
  explicit PictureTest(PictureScene scene) : scene_(std::move(scene)) {}

  void TestBody() override {
    EXPECT_NE(scene_.about, "") << "the second line of the scene says what it shows: `# ...`";
    const Picture drawn = draw(scene_);
    const Difference difference = compare(drawn, read_picture(scene_.picture));
    if (difference.is_small()) return;
    if (is_rewriting()) return write(scene_.picture, drawn, PngEffort::small);
    ADD_FAILURE() << fmt::format("off by {} at most ({} are allowed), {:.3f} in the mean ({})\n", difference.most, kMostOff,
                                 difference.mean, kMeanOff)
                  << write_evidence(scene_, drawn, difference);
  }

 private:
  PictureScene scene_;
};

/// docs/nodes.md shows all of them.
class PageTest : public testing::Test {
 public:
  explicit PageTest(std::string page) : page_(std::move(page)) {}

  void TestBody() override {
    const fs::path path = PLUGC_SOURCE_DIR "/docs/nodes.md";
    if (is_rewriting()) std::ofstream(path) << page_;
    EXPECT_EQ(read_file(path), page_) << "PLUGC_REWRITE=1 writes it";
  }

 private:
  std::string page_;
};

/// Whoever draws a new node shows it.
class CoverageTest : public testing::Test {
 public:
  explicit CoverageTest(std::vector<std::string> missing) : missing_(std::move(missing)) {}
  void TestBody() override { EXPECT_THAT(missing_, testing::IsEmpty()) << "stand in no scene of tests/pictures"; }

 private:
  std::vector<std::string> missing_;
};

void register_tests(const std::vector<PictureScene>& scenes) {
  for (const PictureScene& scene : scenes) {
    testing::RegisterTest(scene.group.c_str(), scene.name.c_str(), nullptr, nullptr, scene.scene.c_str(), 1,
                          [scene]() -> testing::Test* { return new PictureTest(scene); });
  }
  testing::RegisterTest("Nodes", "EachStandsInSomePicture", nullptr, nullptr, __FILE__, __LINE__,
                        [missing = nodes_without_picture(scenes)]() -> testing::Test* { return new CoverageTest(missing); });
  testing::RegisterTest("Page", "ShowsEveryPicture", nullptr, nullptr, __FILE__, __LINE__,
                        [page = nodes_page(scenes)]() -> testing::Test* { return new PageTest(page); });
}

}  // namespace
}  // namespace plugc

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  plugc::process_validator();  // forks, so before anything draws
  plugc::register_tests(plugc::read_picture_scenes());
  return RUN_ALL_TESTS();
}
