// What cannot matter costs nothing: passes and draw calls of frames.

#include <gtest/gtest.h>

#include "boxes_scene.h"
#include "stage.h"

namespace plugc {
namespace {

class Economy : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ShadowStability, Economy, testing::Values(kSun, kSpot),
                         [](const auto& one) { return one.index == 0 ? "Sun" : "Spot"; });

TEST_P(Economy, AStillSceneIsDrawnOnce) {
  Stage stage(boxes_scene(GetParam()), {}, 32);
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 1U);
  EXPECT_EQ(stage.statistics().shadow_draw_calls, 6U) << "five boxes and the ground";
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 0U);
}

TEST_P(Economy, OnlyCastersAndTheLightMakeAMapAnew) {
  Stage stage(boxes_scene(GetParam()), {"Tower.rotation", "Lamp.color", "Lamp.direction", "Whole.translation"}, 32);
  const auto passes_after = [&](const char* field, const std::vector<double>& values) {
    stage.set(field, values);
    stage.draw();
    return stage.statistics().shadow_passes;
  };
  stage.draw();
  EXPECT_EQ(passes_after("Lamp.color", {1, 0, 0}), 0U);
  EXPECT_EQ(passes_after("Tower.rotation", {0, 1, 0, 0.5}), 1U);
  EXPECT_EQ(passes_after("Lamp.direction", {-0.5, -1, -0.5}), 1U);
  EXPECT_LE(passes_after("Whole.translation", {100, 0, 0}), 1U);
}

TEST_P(Economy, ALightThatNobodySeesCostsNoPass) {
  Stage stage(boxes_scene(GetParam()), {"Near.orientation", "Lamp.intensity"}, 32);
  stage.set("Near.orientation", {1, 0, 0, 2});  // the sky
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 0U);
  stage.set("Near.orientation", {-0.73, 0.65, 0.2, 0.68});
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 1U);
}

TEST(ShadowStability, ASpotOutOfReachCostsNoPass) {
  Stage stage(boxes_scene(kSpot), {"Lamp.radius", "Lamp.direction", "Lamp.location"}, 32);
  stage.set("Lamp.radius", {2});
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 0U) << "nothing lies within its radius";
  stage.set("Lamp.radius", {100});
  stage.set("Lamp.direction", {0, 1, 0});
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 0U) << "it shines into the sky";
  stage.set("Lamp.direction", {0, -1, 0});
  stage.set("Lamp.location", {20, 3, 20});
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_passes, 0U) << "no caster is in its cone but the ground, behind which is nothing";
}

TEST_P(Economy, CastersThatAMapCannotShowAreNotDrawn) {
  const std::string far_box = box("Far", "translation 25 0.5 -25", "1 1 1");
  Stage stage(boxes_scene(GetParam(), far_box), {}, 32);
  stage.draw();
  EXPECT_EQ(stage.statistics().shadow_draw_calls, 6U) << "the box far aside is not in it";
}

}  // namespace
}  // namespace plugc
