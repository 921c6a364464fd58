// What shadows must achieve, as means over positions of the map within a texel.

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "judged_text.h"

namespace plugc {
namespace {

struct NamedScene {
  const char* name;
  std::string (*text)();
};
constexpr std::array kPlanesAndBoxes = {NamedScene{"boxes in the sun", boxes_in_the_sun},
                                        NamedScene{"stairs and slabs", stairs_and_slabs},
                                        NamedScene{"boxes under a spotlight", boxes_under_a_spotlight}};

Settings of_size(std::uint32_t size) {
  Settings settings;
  settings.size = size;
  return settings;
}

class AutomaticBias : public testing::TestWithParam<const char*> {};

// All scenes together: where a texel is smaller than a pixel, chance decides on some dozen pixels in each.
TEST_P(AutomaticBias, StaysNearTheFloorOfItsMap) {
  constexpr double kMost = 1.25;
  std::map<std::uint32_t, std::pair<double, double>> wrong_and_floor;  // by size
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    const std::vector<std::uint8_t> package = package_of(scene.text(), GetParam());
    for (const std::uint32_t size : {256U, 512U, 1024U, 2048U, 4096U}) {
      const MeanErrors mean = errors_of(text, package, of_size(size), size > 1024 ? 4 : 16);
      wrong_and_floor[size].first += mean.errors.wrong();
      wrong_and_floor[size].second += mean.floor;
    }
  }
  for (const auto& [size, sums] : wrong_and_floor) EXPECT_LE(sums.first, kMost * sums.second) << size;
}

INSTANTIATE_TEST_SUITE_P(ShadowAccuracy, AutomaticBias, testing::Values("hard", "bilinear", "pcf3"),
                         [](const auto& method) { return std::string(method.param); });

// Their shadows are wider than three texels.
TEST(ShadowAccuracy, TheSharpenedKernelHalvesTheErrorOfTheNearestTexel) {
  constexpr double kMost = 0.65;
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    const Settings settings = of_size(1024);
    const double hard = errors_of(text, package_of(scene.text(), "hard"), settings, 16).errors.wrong();
    const double sharp = errors_of(text, package_of(scene.text(), "sharp3"), settings, 16).errors.wrong();
    EXPECT_LE(sharp, kMost * hard) << scene.name;
  }
}

double largest_difference(const JudgedText& text, const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  const auto picture = [&](const std::vector<std::uint8_t>& package) {
    const auto scene = load_measured_scene(process_studio(), package, of_size(512));
    return measure_visibility(process_studio(), *scene, text.view(), glm::dvec2(0));
  };
  const std::vector<float> first = picture(a);
  const std::vector<float> second = picture(b);
  double largest = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (text.view().truth.pixels[i].counted) largest = std::max(largest, std::abs(double(first[i]) - double(second[i])));
  }
  return largest;
}

TEST(ShadowAccuracy, GatheredKernelsHaveTheValuesOfTheirLookUps) {
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    for (const char* method : {"pcf2", "pcf3", "pcf4"}) {
      const std::string taps = std::string(method) + "_taps";
      EXPECT_LE(largest_difference(text, package_of(scene.text(), method), package_of(scene.text(), taps)), 1.0 / 255)
          << scene.name << ", " << method;
    }
  }
}

TEST(ShadowAccuracy, MomentsLetHardlyAnyLightIntoFullShadow) {
  constexpr double kMost = 0.0005;
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    for (const char* method : {"vsm", "evsm"}) {
      const auto lab = load_measured_scene(process_studio(), package_of(scene.text(), method), of_size(1024));
      EXPECT_LE(measure_leak(process_studio(), *lab, text.judged, text.view()), kMost) << scene.name << ", " << method;
    }
  }
}

TEST(ShadowAccuracy, ATracedShadowIsTheTrueOne) {
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    EXPECT_GT(text.view().truth.shadowed, 1'000U);
    const MeanErrors mean = errors_of(text, package_of(scene.text(), "traced"), {}, 1);
    EXPECT_EQ(mean.errors.wrong(), 0) << scene.name;
    EXPECT_LT(mean.errors.mean_absolute, 1e-5) << scene.name;
  }
}

}  // namespace
}  // namespace plugc
