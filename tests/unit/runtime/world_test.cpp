#include "runtime/world.h"

#include <limits>

#include "runtime/sight_limit.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::SceneBuilder;

constexpr double kHalfPi = std::numbers::pi / 2;

glm::dvec3 apply(const glm::dmat4& matrix, const glm::dvec3& point) {
  return glm::dvec3(matrix * glm::dvec4(point, 1));
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-12) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

World place(const LoadedPackage& loaded) {
  const PackedScene& scene = *loaded.package->scenes()->Get(0);
  return plugc::place(*loaded.package, scene, Slots(scene));
}

TEST(World, ComposesTransformFieldsInTheOrderOfTheSpecification) {
  // Point 2,0,0; center 1,0,0 -> 1,0,0; scale 3,1,1 along axes turned by 90 degrees about z: y grows, x stays -> 1,0,0;
  // rotation 90 degrees about z -> 0,1,0; center back -> 1,1,0; translation 10,20,30.
  const glm::dmat4 matrix = transform_matrix({10, 20, 30}, {0, 0, 1, kHalfPi}, {3, 1, 1}, {0, 0, 1, kHalfPi}, {1, 0, 0});
  expect_near(apply(matrix, {2, 0, 0}), {11, 21, 30});
  // 1,1,0: relative 0,1,0 -> 0,3,0 -> -3,0,0 -> -2,0,0.
  expect_near(apply(matrix, {1, 1, 0}), {8, 20, 30});
}

TEST(World, TreatsAZeroAxisAsNoRotation) {
  EXPECT_EQ(rotation_matrix({0, 0, 0, 2.5}), glm::dmat4(1.0));
  EXPECT_EQ(rotation_matrix({0, 1, 0, std::numeric_limits<double>::infinity()}), glm::dmat4(1.0));
}

TEST(World, NormalizesRotationAxes) {
  expect_near(apply(rotation_matrix({0, 0, 5, kHalfPi}), {1, 0, 0}), {0, 1, 0});
}

TEST(World, PlacesChildrenInTheirParents) {
  SceneBuilder builder;
  const std::int32_t outer = builder.transform(-1, builder.vec3(0, 5, 0), kNoSlot, builder.vec3(2, 2, 2));
  builder.transform(outer, builder.vec3(1, 0, 0));
  const World world = place(builder.pack());
  expect_near(apply(world.at(1).matrix, {1, 1, 1}), {4, 7, 2});
  expect_near(apply(world.at(-1).matrix, {1, 1, 1}), {1, 1, 1});
}

TEST(World, RotationOfAMatrixIsWhatItTurnsAlone) {
  const glm::dmat4 matrix = transform_matrix({7, 8, 9}, {0, 1, 0, kHalfPi}, {2, 30, 0.1}, {0, 0, 1, 0}, {1, 2, 3});
  expect_near(rotation_of(matrix) * glm::dvec3(0, 0, 1), {1, 0, 0});
  expect_near(rotation_of(matrix) * glm::dvec3(0, 1, 0), {0, 1, 0});
}

TEST(World, RotationOfAMirroredOrShearedMatrixIsStillARotation) {
  const glm::dmat4 mirrored = transform_matrix({0, 0, 0}, {0, 0, 1, 0}, {-1, 1, 1}, {0, 0, 1, 0}, {0, 0, 0});
  const glm::dmat4 sheared = transform_matrix({0, 0, 0}, {0, 0, 1, 0}, {1, 5, 1}, {1, 0, 1, 1}, {0, 0, 0});
  for (const glm::dmat4& matrix : {mirrored, sheared, glm::dmat4(0.0)}) {
    const glm::dmat3 rotation = rotation_of(matrix);
    EXPECT_NEAR(glm::determinant(rotation), 1, 1e-12);
    expect_near(glm::transpose(rotation) * (rotation * glm::dvec3(1, 2, 3)), {1, 2, 3});
  }
}

TEST(World, HidesWhatASwitchDoesNotChoose) {
  SceneBuilder builder;
  const std::uint32_t which = builder.slot(PackedValueType::int_, {1});
  builder.switch_child(-1, which, 0);
  const std::int32_t second = builder.switch_child(-1, which, 1);
  builder.transform(0, kNoSlot);
  builder.transform(second, kNoSlot);
  const World world = place(builder.pack());
  EXPECT_FALSE(world.at(0).visible);
  EXPECT_TRUE(world.at(1).visible);
  EXPECT_FALSE(world.at(2).visible) << "a child of a hidden node";
  EXPECT_TRUE(world.at(3).visible);
}

/// Three levels: nearer than 2, nearer than 5, beyond.
SceneBuilder three_levels(std::int32_t parent_scale) {
  SceneBuilder builder;
  const double scale = parent_scale;
  builder.transform(-1, builder.vec3(0, 0, 10), kNoSlot, builder.vec3(scale, scale, scale));
  const std::uint32_t center = builder.vec3(1, 0, 0);
  const double ranges[] = {0, 2, 5, std::numeric_limits<double>::infinity()};
  for (std::uint32_t level = 0; level < 3; ++level) {
    builder.transform(0, kNoSlot);
    builder.scene().lod_levels.emplace_back(level + 1, center, ranges[level], ranges[level + 1]);
  }
  return builder;
}

/// The only level that is shown; -1 for none, -2 for several.
int level_seen_from(const SceneBuilder& builder, const Viewer* viewer) {
  const LoadedPackage loaded = builder.pack();
  const PackedScene& scene = *loaded.package->scenes()->Get(0);
  const World world = plugc::place(*loaded.package, scene, Slots(scene), viewer);
  int shown = -1;
  for (int level = 0; level < 3; ++level) {
    if (world.at(level + 1).visible) shown = shown == -1 ? level : -2;
  }
  return shown;
}

TEST(World, ChoosesALevelByTheDistanceOfTheEyeFromTheCenter) {
  const auto level_at = [](double x) {
    const Viewer viewer{{x, 0, 10}, {0, 1, 0}};
    return level_seen_from(three_levels(1), &viewer);
  };
  EXPECT_EQ(level_at(1), 0);
  EXPECT_EQ(level_at(2.999), 0);
  EXPECT_EQ(level_at(3), 1);
  EXPECT_EQ(level_at(-3.999), 1);
  EXPECT_EQ(level_at(6), 2);
  EXPECT_EQ(level_at(1e9), 2);
}

TEST(World, MeasuresTheDistanceOfALevelInItsOwnSpace) {
  const Viewer viewer{{3 * (1 + 4.9), 0, 10}, {0, 1, 0}};
  EXPECT_EQ(level_seen_from(three_levels(3), &viewer), 1);
}

TEST(World, ShowsTheNearestLevelWhereThereIsNoDistance) {
  const Viewer viewer{{100, 0, 0}, {0, 1, 0}};
  const Viewer nowhere{{std::nan(""), 0, 0}, {0, 1, 0}};
  EXPECT_EQ(level_seen_from(three_levels(1), nullptr), 0);
  EXPECT_EQ(level_seen_from(three_levels(0), &viewer), 0) << "all of its space is one point";
  EXPECT_EQ(level_seen_from(three_levels(1), &nowhere), 0);
}

TEST(World, TheBackdropHasNoBounds) {
  SceneBuilder builder;
  const std::uint32_t flat = builder.flat_program();
  builder.flat_shape(builder.square(1), flat, {1, 1, 1, 1});
  const std::int32_t hidden = builder.switch_child(-1, builder.slot(PackedValueType::int_, {-1}), 0);
  builder.flat_shape(builder.square(9), flat, {1, 1, 1, 1}, hidden);
  builder.shape(1).layer = PackedLayer::backdrop;
  const World world = place(builder.pack());
  EXPECT_TRUE(world.shape_visible[1]) << "a background that is bound shows wherever it stands";
  EXPECT_TRUE(world.shape_bounds[1].empty());
  expect_near(world.bounds.max, {1, 1, 0});
}

TEST(World, BoundsFollowTransformsAndSkipTheHidden) {
  SceneBuilder builder;
  const std::uint32_t square = builder.square(1);
  const std::uint32_t flat = builder.flat_program();
  const std::int32_t moved = builder.transform(-1, builder.vec3(10, 0, 0), builder.rotation(0, 1, 0, kHalfPi));
  const std::int32_t hidden = builder.switch_child(-1, builder.slot(PackedValueType::int_, {-1}), 0);
  builder.flat_shape(square, flat, {1, 1, 1, 1}, moved);
  builder.flat_shape(square, flat, {1, 1, 1, 1}, hidden);
  const World world = place(builder.pack());
  expect_near(world.bounds.min, {10, -1, -1});
  expect_near(world.bounds.max, {10, 1, 1});
  EXPECT_TRUE(world.shape_bounds[1].empty());
}

TEST(World, BoundsLeaveOutWhatIsNoNumber) {
  SceneBuilder builder;
  const std::uint32_t square = builder.square(1);
  const std::uint32_t flat = builder.flat_program();
  const std::int32_t broken = builder.transform(-1, builder.vec3(std::nan(""), 0, 0));
  const std::int32_t huge = builder.transform(-1, builder.vec3(1e300, 0, 0));
  builder.flat_shape(square, flat, {1, 1, 1, 1}, broken);
  builder.flat_shape(square, flat, {1, 1, 1, 1}, huge);
  builder.flat_shape(square, flat, {1, 1, 1, 1});
  const World world = place(builder.pack());
  expect_near(world.bounds.min, {-1, -1, 0});
  expect_near(world.bounds.max, {1, 1, 0});
}

View camera_of(const LoadedPackage& loaded, const std::string& wanted, Messages& messages, double aspect = 1) {
  const PackedScene& scene = *loaded.package->scenes()->Get(0);
  const Slots slots(scene);
  return make_camera(scene, slots, plugc::place(*loaded.package, scene, slots), wanted, aspect, messages);
}

TEST(Camera, ShowsTheWholeSceneWithoutAViewpoint) {
  SceneBuilder builder;
  builder.flat_shape(builder.mesh({{0, 0, 0}, {4, 0, 0}, {4, 2, 6}}), builder.flat_program(), {1, 1, 1, 1});
  Messages messages;
  const View view = camera_of(builder.pack(), "", messages);
  expect_near(glm::dvec3(view.eye_to_world[3]), {2, 1, 6 + 2 * (4 + 2 + 6) / 3.0});
  expect_near(glm::dvec3(view.eye_to_world[2]), {0, 0, 1});
}

TEST(Camera, LooksThroughTheBoundViewpointUnlessAnotherIsNamed) {
  SceneBuilder builder;
  builder.orthographic_view(1, 5);
  builder.orthographic_view(1, 7);
  builder.scene().bound_viewpoint = 1;
  Messages messages;
  EXPECT_EQ(camera_of(builder.pack(), "", messages).eye_to_world[3].z, 7);
  EXPECT_EQ(camera_of(builder.pack(), "0", messages).eye_to_world[3].z, 5);
  EXPECT_EQ(camera_of(builder.pack(), "Nowhere", messages).eye_to_world[3].z, 7);
  builder.scene().bound_viewpoint = -1;
  EXPECT_EQ(camera_of(builder.pack(), "", messages).eye_to_world[3].z, 10) << "the view of the whole, which is nothing here";
  EXPECT_EQ(camera_of(builder.pack(), "1", messages).eye_to_world[3].z, 7);
}

TEST(Camera, StandsAtTenWhenThereIsNothing) {
  Messages messages;
  const View view = camera_of(SceneBuilder().pack(), "", messages);
  expect_near(glm::dvec3(view.eye_to_world[3]), {0, 0, 10});
}

TEST(Camera, StaysRigidUnderAScaledTransform) {
  SceneBuilder builder;
  const std::int32_t place_of_camera =
      builder.transform(-1, builder.vec3(0, 0, 3), builder.rotation(0, 1, 0, kHalfPi), builder.vec3(2, 3, 4));
  builder.orthographic_view(1, 5);
  builder.scene().viewpoints[0]->transform = place_of_camera;
  Messages messages;
  const View view = camera_of(builder.pack(), "", messages);
  expect_near(glm::dvec3(view.eye_to_world[3]), {20, 0, 3});
  expect_near(glm::dvec3(view.eye_to_world[2]), {1, 0, 0});  // unit, though the transform stretches by four
  expect_near(apply(view.world_to_eye * view.eye_to_world, {1, 2, 3}), {1, 2, 3});
}

TEST(Camera, AppliesTheFieldOfViewToTheShorterSide) {
  SceneBuilder builder;
  builder.flat_shape(builder.square(1), builder.flat_program(), {1, 1, 1, 1});
  builder.scene().viewpoints.push_back(std::make_unique<PackedViewpointT>());
  builder.scene().viewpoints[0]->field_of_view = builder.number(kHalfPi);
  Messages messages;
  const LoadedPackage loaded = builder.pack();
  const View wide = camera_of(loaded, "", messages, 2);
  EXPECT_NEAR(wide.projection[1][1], 1, 1e-12);
  EXPECT_NEAR(wide.projection[0][0], 0.5, 1e-12);
  const View tall = camera_of(loaded, "", messages, 0.5);
  EXPECT_NEAR(tall.projection[0][0], 1, 1e-12);
  EXPECT_NEAR(tall.projection[1][1], 0.5, 1e-12);
}

TEST(Camera, AppliesAVerticalFieldOfViewToTheHeight) {
  SceneBuilder builder;
  builder.scene().viewpoints.push_back(std::make_unique<PackedViewpointT>());
  builder.scene().viewpoints[0]->field_of_view = builder.number(kHalfPi);
  builder.scene().viewpoints[0]->field_is_vertical = true;
  Messages messages;
  const View tall = camera_of(builder.pack(), "", messages, 0.5);
  EXPECT_NEAR(tall.projection[0][0], 2, 1e-12);
  EXPECT_NEAR(tall.projection[1][1], 1, 1e-12);
}

TEST(SightLimit, IsTheFarPlaneOfWhatWouldBeSeenFarther) {
  SceneBuilder builder;
  const std::int32_t far_away = builder.transform(-1, builder.vec3(0, 0, -90));
  builder.flat_shape(builder.square(1), builder.flat_program(), {1, 1, 1, 1}, far_away);
  builder.scene().viewpoints.push_back(std::make_unique<PackedViewpointT>());
  Messages messages;
  const View fitted = camera_of(builder.pack(), "", messages);
  View view = fitted;
  const auto depth_at = [&](double distance) {
    const glm::dvec4 clip = view.projection * glm::dvec4(0, 0, -distance, 1);
    return clip.z / clip.w;
  };
  EXPECT_FALSE(limit_sight(view, 0)) << "0 is no limit";
  EXPECT_FALSE(limit_sight(view, 1000)) << "nothing lies as far as that";
  EXPECT_EQ(view.projection, fitted.projection);
  EXPECT_TRUE(limit_sight(view, 30));
  EXPECT_NEAR(depth_at(30), 1, 1e-9);
  EXPECT_NEAR(depth_at(0.003), -1, 1e-9) << "what is much nearer than the box is not cut";
}

TEST(Camera, FindsViewpointsByNameThenByIndex) {
  SceneBuilder builder;
  builder.orthographic_view(1, 3);
  builder.orthographic_view(1, 7);
  builder.scene().viewpoints[1]->name = "Above";
  const LoadedPackage loaded = builder.pack();
  Messages messages;
  EXPECT_NEAR(camera_of(loaded, "Above", messages).eye_to_world[3].z, 7, 1e-12);
  EXPECT_NEAR(camera_of(loaded, "1", messages).eye_to_world[3].z, 7, 1e-12);
  EXPECT_TRUE(messages.list().empty());
  EXPECT_NEAR(camera_of(loaded, "2", messages).eye_to_world[3].z, 3, 1e-12);
  ASSERT_EQ(messages.list().size(), 1U);
  EXPECT_EQ(messages.list()[0], "no viewpoint `2`: the bound one is shown; give a DEF name or an index below 2");
}

TEST(World, SeesWhetherABoxIsBesideTheView) {
  const glm::dmat4 clip(1.0);
  EXPECT_FALSE(outside_sideways({{-2, -2, -2}, {-1, 0, 0}}, clip)) << "touches";
  EXPECT_TRUE(outside_sideways({{-2, -2, -2}, {-1.1, 0, 0}}, clip));
  EXPECT_TRUE(outside_sideways({{-2, 1.1, -2}, {2, 2, 2}}, clip));
  EXPECT_FALSE(outside_sideways({{-9, -9, 5}, {9, 9, 6}}, clip)) << "behind the far plane is not sideways";
  EXPECT_FALSE(outside_sideways(Box{}, clip)) << "unknown is never outside";
}

TEST(Events, ChangesASlotAndItsRevisionOnlyWhenTheValueDiffers) {
  SceneBuilder builder;
  const std::uint32_t slot = builder.vec3(1, 2, 3);
  const LoadedPackage loaded = builder.pack();
  Slots slots(*loaded.package->scenes()->Get(0));
  const std::uint64_t before = slots.revision();
  EXPECT_TRUE(slots.set(slot, std::vector<double>{1, 2, 3}));
  EXPECT_EQ(slots.revision(), before);
  EXPECT_TRUE(slots.set(slot, std::vector<double>{4, 5, 6}));
  EXPECT_GT(slots.revision(), before);
  EXPECT_EQ(slots.vector3(slot, glm::dvec3(0)), glm::dvec3(4, 5, 6));
  EXPECT_FALSE(slots.set(slot, std::vector<double>{1, 2}));
  EXPECT_FALSE(slots.set(slot + 1, std::vector<double>{1, 2, 3}));
  EXPECT_EQ(slots.vector3(kNoSlot, glm::dvec3(7)), glm::dvec3(7));
}

}  // namespace
}  // namespace plugc
