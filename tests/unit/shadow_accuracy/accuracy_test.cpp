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

INSTANTIATE_TEST_SUITE_P(ShadowAccuracy, AutomaticBias, testing::Values("hard", "bilinear", "pcf3", "vsm", "evsm", "msm"),
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

// There a plane's own depths spread as far as its casters stand out: what blur and bias hide.
TEST(ShadowAccuracy, MomentsKeepTheShadowOfWhatHardlyStandsOut) {
  constexpr double kMost = 1.75;
  const std::string scene = ledges_on_a_wall();
  const JudgedText text = judge_text(scene);
  const double hard = errors_of(text, package_of(scene, "hard"), of_size(1024), 4).errors.wrong();
  for (const char* method : {"vsm", "evsm", "msm"})
    EXPECT_LE(errors_of(text, package_of(scene, method), of_size(1024), 4).errors.wrong(), kMost * hard) << method;
}

double leak_of(const JudgedText& text, const std::string& scene, const char* method) {
  const auto measured = load_measured_scene(process_studio(), package_of(scene, method), of_size(1024));
  return measure_leak(process_studio(), *measured, text.judged, text.view());
}

TEST(ShadowAccuracy, MomentsLetHardlyAnyLightIntoFullShadow) {
  constexpr double kMost = 0.0005;
  for (const NamedScene& scene : kPlanesAndBoxes) {
    const JudgedText text = judge_text(scene.text());
    for (const char* method : {"vsm", "evsm", "msm"})
      EXPECT_LE(leak_of(text, scene.text(), method), kMost) << scene.name << ", " << method;
  }
}

// Variance alone cannot: bars far above make it allow light in front of what lies just below the slabs.
TEST(ShadowAccuracy, WarpsAndFourMomentsTellCastersApartThatLieAboveEachOther) {
  constexpr double kMost = 0.0001;
  const std::string scene = low_slabs_below_a_tower();
  const JudgedText text = judge_text(scene);
  for (const char* method : {"evsm", "msm"}) EXPECT_LE(leak_of(text, scene, method), kMost) << method;
}

// A kernel of 3 x 3 look-ups reads texels up to two away and is no bound that could be loose: light where the edge is four
// texels away would be a mistake of the judge. Around cones that are a few texels wide hardly any plane goes on for four.
TEST(ShadowAccuracy, AKernelLetsNoLightInWhereItReachesNoEdge) {
  constexpr double kMost = 0.0005;  // pixels between the points that the judge looks at
  const std::string scene = cones_on_hills();
  const JudgedText text = judge_text(scene);
  EXPECT_GT(text.view().truth.shadowed, 10'000U);
  EXPECT_LE(leak_of(text, scene, "pcf3"), kMost);
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
