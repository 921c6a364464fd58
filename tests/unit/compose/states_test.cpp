#include "compose/shape_states.h"

#include "compose_fixture.h"

namespace plugc {
namespace {

class StatesTest : public ComposeTest {
 protected:
  StatesTest() {
    SceneMaterial material;
    material.lighting = Lighting::phong;
    material.diffuse = material.ambient_color = slot({1, 1, 1}, SlotType::vec3);
    scene_.materials.push_back(material);
    shape_.material = 0;
  }
  std::uint32_t slot(std::vector<double> values, SlotType type = SlotType::bool_, bool routed = false) {
    Slot made;
    made.type = type;
    made.values = std::move(values);
    made.routed = routed;
    scene_.slots.push_back(made);
    return static_cast<std::uint32_t>(scene_.slots.size() - 1);
  }
  int transform_under(std::uint32_t switch_slot, int choice) {
    SceneTransform made;
    made.switch_slot = switch_slot;
    made.choice = choice;
    scene_.transforms.push_back(made);
    return static_cast<int>(scene_.transforms.size() - 1);
  }
  void light(bool routed, int transform = -1) {
    SceneLight made;
    made.on = slot({1}, SlotType::bool_, routed);
    made.transform = transform;
    shape_.lights.push_back(static_cast<int>(scene_.lights.size()));
    scene_.lights.push_back(made);
  }
  ShapeStates make() { return make_shape_states(scene_, shape_, {}, effects_); }

  SceneShape shape_;
};

TEST_F(StatesTest, NothingThatChangesIsOneProgram) {
  light(false);
  const ShapeStates states = make();
  EXPECT_TRUE(states.switches.empty());
  EXPECT_EQ(states.states, std::vector<std::uint8_t>{0});
  ASSERT_EQ(states.recipes.size(), 1U);
  EXPECT_EQ(states.recipes[0].fuller, -1);
}

TEST_F(StatesTest, ThreeLightsAreEightPrograms) {
  for (int i = 0; i < 3; ++i) light(true);
  const ShapeStates states = make();
  EXPECT_EQ(states.recipes.size(), 8U);
  EXPECT_EQ(states.states.size(), 8U);
  EXPECT_EQ(states.states[7], 0);  // all on
  for (std::size_t i = 1; i < states.recipes.size(); ++i) EXPECT_EQ(states.recipes[i].fuller, 0);
}

TEST_F(StatesTest, FourLightsShareOneProgramWithSwitches) {
  for (int i = 0; i < 4; ++i) light(true);
  const ShapeStates states = make();
  ASSERT_EQ(states.recipes.size(), 1U);
  EXPECT_TRUE(states.switches.empty());
  for (const LightRecipe& one : states.recipes[0].recipe.lights) EXPECT_TRUE(one.guarded && !one.off);
}

TEST_F(StatesTest, OffLightsKeepTheNumbersOfTheOthers) {
  light(true);
  light(false);
  const ShapeStates states = make();
  ASSERT_EQ(states.recipes.size(), 2U);
  const Recipe& off = states.recipes[states.states[0]].recipe;
  ASSERT_EQ(off.lights.size(), 2U);
  EXPECT_TRUE(off.lights[0].off);
  EXPECT_FALSE(off.lights[1].off);
}

TEST_F(StatesTest, BranchesOfOneSwitchExcludeEachOther) {
  const std::uint32_t choice = slot({0}, SlotType::int_, true);
  for (int i = 0; i < 6; ++i) light(false, transform_under(choice, i));
  EXPECT_EQ(make().recipes.size(), 7U);  // each alone, and none
}

TEST_F(StatesTest, MistakesAreToldWhereEachSwitchIsOn) {
  const std::uint32_t choice = slot({0}, SlotType::int_, true);
  for (int i = 0; i < 2; ++i) light(false, transform_under(choice, i));
  const ShapeStates states = make();
  EXPECT_EQ(states.recipes[states.states[1]].fuller, -1);
  EXPECT_EQ(states.recipes[states.states[2]].fuller, -1);
  EXPECT_GE(states.recipes[states.states[0]].fuller, 0);
}

TEST_F(StatesTest, WhatTheSameEventsReachMovesTogether) {
  light(true);
  light(true);
  scene_.slots.back().mirrors = scene_.lights[0].on;
  const ShapeStates states = make();
  EXPECT_EQ(states.recipes.size(), 2U);  // both on, both off
  EXPECT_EQ(states.states.size(), 4U);
}

TEST_F(StatesTest, AShapeIsSeenOnlyInItsOwnBranch) {
  const std::uint32_t choice = slot({0}, SlotType::int_, true);
  shape_.transform = transform_under(choice, 1);
  light(false, transform_under(choice, 0));
  light(false, transform_under(choice, 1));
  const ShapeStates states = make();
  ASSERT_EQ(states.recipes.size(), 1U);
  EXPECT_TRUE(states.recipes[0].recipe.lights[0].off);
  EXPECT_FALSE(states.recipes[0].recipe.lights[1].off);
}

}  // namespace
}  // namespace plugc
