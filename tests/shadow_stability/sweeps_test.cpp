// One scene while one thing about it changes: the error against the truth must not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxes_scene.h"
#include "stage.h"

namespace plugc {
namespace {

/// The largest difference of the error to that of the first setting, in points (of percent).
template <typename Change>
double largest_change(Stage& stage, const std::vector<double>& settings, Change change) {
  double first = 0;
  double largest = 0;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    change(settings[i]);
    const Verdict verdict = stage.judge();
    if (i == 0) first = verdict.error();
    largest = std::max(largest, std::abs(verdict.error() - first));
  }
  return largest;
}

const std::vector<double> kPowers = {1, 1e-3, 1e-2, 1e-1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

class EachLight : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ShadowStability, EachLight, testing::Values(kSun, kSpot),
                         [](const auto& one) { return one.index == 0 ? "Sun" : "Spot"; });

TEST_P(EachLight, IsNearTheTruth) {
  Stage stage(boxes_scene(GetParam()));
  for (const char* const viewpoint : {"Near", "High"}) {
    stage.look_through(viewpoint);
    const Verdict verdict = stage.judge();
    EXPECT_LE(verdict.error(), 1) << viewpoint << ": " << verdict.false_shadow << " % false shadow, " << verdict.false_lit
                                  << " % false lit";
  }
}

TEST_P(EachLight, ErrorDoesNotDependOnTheScale) {
  Stage stage(boxes_scene(GetParam()), {"Whole.scale"});
  EXPECT_LE(largest_change(stage, kPowers, [&](double s) { stage.set("Whole.scale", {s, s, s}); }), 0.01);
}

TEST_P(EachLight, ErrorDoesNotDependOnWhereTheSceneLies) {
  Stage stage(boxes_scene(GetParam()), {"Whole.translation"});
  EXPECT_LE(largest_change(stage, {0, 1e2, 1e3, 1e4, 1e5, 1e6},
                           [&](double d) {
                             stage.set("Whole.translation", {d, -d, 0.7 * d});
                           }),
            0.1);
}

TEST_P(EachLight, ErrorDoesNotDependOnHowTheSceneIsTurned) {
  Stage stage(boxes_scene(GetParam()), {"Whole.rotation"});
  EXPECT_LE(largest_change(stage, {0, 0.5, 1, 2, 3, 4, 5}, [&](double a) { stage.set("Whole.rotation", {1, 2, 3, a}); }), 0.02);
}

TEST_P(EachLight, ErrorDoesNotDependOnFarOverNear) {
  Stage stage(boxes_scene(GetParam()), {"Lamp.projectionNear", "Lamp.projectionFar"});
  const double change = largest_change(stage, {10, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}, [&](double ratio) {
    stage.set("Lamp.projectionFar", {40});
    stage.set("Lamp.projectionNear", {40 / ratio});
  });
  EXPECT_LE(change, 0.05);
}

TEST_P(EachLight, ErrorDoesNotDependOnANearCaster) {
  // A small plate close in front of the lamp, and a ground below all: what the depths have to span grows with the ratio.
  Stage stage(boxes_scene(GetParam(), box("Plate", "translation 0 -100 0", "0.001 0.001 0.001")), {"Plate.translation"});
  const glm::dvec3 direction = glm::normalize(glm::dvec3(-4, -9, -6));
  const double change = largest_change(stage, {10, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}, [&](double ratio) {
    const glm::dvec3 place = glm::dvec3(4, 9, 6) + direction * (40 / ratio) + glm::dvec3(0.3, 0, 0) * (40 / ratio);
    stage.set("Plate.translation", {place.x, place.y, place.z});
  });
  // the plate's own shadow on the ground changes with its place: it is 0.001 wide, and at most a few pixels when nearest
  EXPECT_LE(change, 0.15);
}

TEST_P(EachLight, CastersBeforeTheNearPlaneCast) {
  Stage stage(boxes_scene(GetParam()), {"Lamp.projectionNear", "Lamp.projectionFar"});
  stage.set("Lamp.projectionFar", {40});
  EXPECT_EQ(largest_change(stage, {0, 1, 6, 9, 10, 11, 12}, [&](double near) { stage.set("Lamp.projectionNear", {near}); }), 0);
}

TEST_P(EachLight, FalseShadowFallsAndFalseLightRisesAlongTheBias) {
  Stage stage(boxes_scene(GetParam()), {"Map.scale", "Map.bias"});
  const Truth truth = stage.trace();
  const double automatic = stage.judge(truth).error();
  double best = 100;
  constexpr double kRounding = 0.02;  // two pixels
  for (const double bias : {0.0, 1.0, 16.0, 256.0}) {
    Verdict last{100, 0};
    for (const double scale : {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      stage.set("Map.scale", {scale});
      stage.set("Map.bias", {bias});
      const Verdict verdict = stage.judge(truth);
      EXPECT_LE(verdict.false_shadow, last.false_shadow + kRounding) << scale << ' ' << bias;
      EXPECT_GE(verdict.false_lit, last.false_lit - kRounding) << scale << ' ' << bias;
      best = std::min(best, verdict.error());
      last = verdict;
    }
  }
  EXPECT_LE(automatic, best * 1.05 + kRounding);
}

TEST(ShadowStability, HoldsAtEveryElevationOfTheSun) {
  Stage stage(boxes_scene(kSun), {"Lamp.direction", "Map.scale"});
  for (const double degrees : {2.0, 5.0, 10.0, 20.0, 35.0, 50.0, 70.0, 85.0, 89.0, 90.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    stage.set("Lamp.direction", {-std::cos(angle) * 0.8, -std::sin(angle), -std::cos(angle) * 0.6});
    stage.set("Map.scale", {4});
    const Truth truth = stage.trace();
    const Verdict automatic = stage.judge(truth);
    double best = automatic.weighted;
    for (const double scale : {1.0, 2.0, 3.0, 6.0, 8.0, 16.0}) {
      stage.set("Map.scale", {scale});
      best = std::min(best, stage.judge(truth).weighted);
    }
    EXPECT_LE(automatic.weighted, best * 1.25 + 0.05) << degrees;
  }
}

TEST_P(EachLight, ItsEdgesMoveNoMoreThanTheTruthWhileTheLightMoves) {
  const bool sun = GetParam() == kSun;
  Stage stage(boxes_scene(GetParam()), {"Lamp.direction"});
  Truth last_truth;
  std::vector<double> last_visible;
  double drawn = 0;
  double true_change = 0;
  for (int i = 0; i < 16; ++i) {
    const glm::dvec3 direction = sun ? glm::dvec3(-0.55 + 0.01 * i, -1, -0.4) : glm::dvec3(-4 + 0.05 * i, -9, -6);
    stage.set("Lamp.direction", {direction.x, direction.y, direction.z});
    const Truth truth = stage.trace();
    const std::vector<double> visible = stage.visibility();
    if (i > 0) {
      true_change += difference(truth, last_truth);
      std::size_t changed = 0;
      std::size_t counted = 0;
      for (std::size_t p = 0; p < truth.size(); ++p) {
        if (!truth[p].counts || !last_truth[p].counts) continue;
        ++counted;
        changed += (visible[p] > 0.5) != (last_visible[p] > 0.5) ? 1 : 0;
      }
      drawn += 100.0 * static_cast<double>(changed) / static_cast<double>(counted);
    }
    last_truth = truth;
    last_visible = visible;
  }
  EXPECT_LE(drawn, sun ? 2 * true_change : 2 * true_change + 15 * 0.1) << "a turned lamp turns the grid of its texels";
}

TEST_P(EachLight, IsTheSameInWhicheverOrderTrianglesAreListed) {
  const auto pyramid = [](const char* indices) {
    return "Shape { appearance USE Grey geometry IndexedFaceSet { solid FALSE coordIndex [" + std::string(indices) +
           "] coord Coordinate { point [-1 0 -4, 1 0 -4, 1 0 -6, -1 0 -6, 0 3 -5] } } }\n";
  };
  Stage one(boxes_scene(GetParam(), pyramid("0 1 4 -1 1 2 4 -1 2 3 4 -1 3 0 4 -1")));
  Stage other(boxes_scene(GetParam(), pyramid("3 0 4 -1 2 3 4 -1 0 1 4 -1 1 2 4 -1")));
  EXPECT_EQ(one.draw().values, other.draw().values);
}

}  // namespace
}  // namespace plugc
