#include <functional>

#include "test_scene.h"

namespace plugc {
namespace {

using test::kGreen;
using test::kRed;
using test::make_renderer;
using test::pixel;
using test::SceneBuilder;

FrameOptions small() {
  FrameOptions frame;
  frame.width = frame.height = 16;
  return frame;
}

/// A red square, green while the switch is off.
struct SwitchedSquare {
  explicit SwitchedSquare(const std::function<PackedSwitch(SceneBuilder&)>& make_switch) {
    const std::uint32_t shape = builder.flat_shape(builder.square(1), builder.flat_program(), {1, 0, 0, 1});
    const std::uint32_t green = builder.slot(PackedValueType::vec4, {0, 1, 0, 1});
    builder.add_off_program(shape, make_switch(builder), builder.flat_program(),
                            {{0, 0, 0, 1, PackedSource::model_view_projection_matrix}, {1, green, 0, 1, PackedSource::slot}});
    builder.orthographic_view(1);
  }
  SceneBuilder builder;
};

TEST(States, ASlotChoosesTheProgramOfEachFrame) {
  std::uint32_t enabled = 0;
  SwitchedSquare square([&](SceneBuilder& builder) {
    enabled = builder.slot(PackedValueType::bool_, {1});
    return PackedSwitch(enabled, PackedSwitchKind::slot);
  });
  const LoadedPackage loaded = square.builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kRed);
  renderer->set_slot(enabled, {0});
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kGreen);
  renderer->set_slot(enabled, {1});
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kRed);
  EXPECT_TRUE(renderer->messages().empty());
}

TEST(States, ALightIsOffInABranchThatIsNotChosen) {
  std::uint32_t choice = 0;
  SwitchedSquare square([&](SceneBuilder& builder) {
    choice = builder.slot(PackedValueType::int_, {0});
    const std::uint32_t light = builder.add_light(PackedLightKind::directional, "Lamp");
    builder.light(light).transform = builder.switch_child(-1, choice, 0);
    return PackedSwitch(light, PackedSwitchKind::light);
  });
  const LoadedPackage loaded = square.builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kRed);
  renderer->set_slot(choice, {1});
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kGreen);
}

TEST(States, AHostSetsOnlyWhatIsDynamic) {
  std::uint32_t enabled = 0;
  SwitchedSquare square([&](SceneBuilder& builder) {
    enabled = builder.slot(PackedValueType::bool_, {1});
    builder.name_slot(enabled, "Glow.enabled", true);
    builder.name_slot(builder.number(1), "Glow.amount", false);
    return PackedSwitch(enabled, PackedSwitchKind::slot);
  });
  const LoadedPackage loaded = square.builder.pack();
  const auto renderer = make_renderer(loaded);
  std::string error;
  EXPECT_TRUE(renderer->set_field("Glow.enabled", {0}, error)) << error;
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kGreen);
  EXPECT_FALSE(renderer->set_field("Glow.enabled", {0, 1}, error));
  EXPECT_EQ(error, "`Glow.enabled` holds 1 numbers, not 2");
  EXPECT_FALSE(renderer->set_field("Glow.amount", {0}, error));
  EXPECT_EQ(error, "the package does not let a host change `Glow.amount`: build it with `--dynamic Glow.amount`");
  EXPECT_FALSE(renderer->set_field("Glow.enable", {0}, error));
}

/// One field in two nodes of a name that do not hold as many numbers.
TEST(States, AHostSetsAFieldInAllNodesOfTheNameOrInNone) {
  SceneBuilder builder;
  builder.name_slot(builder.number(1), "Glow.amount", true);
  builder.name_slot(builder.vec3(1, 2, 3), "Glow.amount", true);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  std::string error;
  EXPECT_FALSE(renderer->set_field("Glow.amount", {0}, error));
  EXPECT_EQ(error, "`Glow.amount` holds 3 numbers, not 1");
  EXPECT_EQ(renderer->field("Glow.amount"), std::vector<double>{1});
}

}  // namespace
}  // namespace plugc
