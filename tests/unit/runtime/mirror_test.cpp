// What is seen in a flat mirror.

#include "runtime/mirror.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "runtime/projection.h"

namespace plugc {
namespace {

const Mirror kWall = {{-2, -1, 0}, {4, 0, 0}, {0, 2, 0}};
const Box kRoom = {{-20, -20, -20}, {20, 20, 20}};

View viewer_at(const glm::dvec3& place, const glm::dvec3& direction) {
  View view = look_along(place, direction, {0, 1, 0});
  view.projection = glm::perspective(1.0, 1.5, 0.1, 100.0);
  return view;
}

glm::dvec3 in_clip(const View& view, const glm::dvec3& point) {
  const glm::dvec4 clip = view.projection * view.world_to_eye * glm::dvec4(point, 1);
  return glm::dvec3(clip) / clip.w;
}

TEST(Mirror, ShowsWhatTheImageOfTheEyeSees) {
  const auto seen = view_in_mirror(kWall, viewer_at({1, 2, 3}, {-0.2, -0.3, -1}), 0, kRoom);
  ASSERT_TRUE(seen);
  const glm::dvec3 eye(seen->eye_to_world[3]);
  EXPECT_NEAR(eye.x, 1, 1e-9);
  EXPECT_NEAR(eye.y, 2, 1e-9);
  EXPECT_NEAR(eye.z, -3, 1e-9);
  EXPECT_NEAR(glm::determinant(glm::dmat3(seen->eye_to_world)), 1, 1e-9) << "no axis is mirrored";
}

/// The ray from the eye by way of the mirror: where it leaves the mirror and all places on it look alike.
TEST(Mirror, ShowsAPlaceWhereItsRayMeetsTheMirror) {
  const glm::dvec3 eye(1, 2, 3), on_mirror(-1, 0.5, 0);
  const auto seen = view_in_mirror(kWall, viewer_at(eye, {0, 0, -1}), 0, kRoom);
  ASSERT_TRUE(seen);
  const glm::dvec3 back = glm::reflect(on_mirror - eye, glm::dvec3(0, 0, 1));
  const glm::dvec3 near = in_clip(*seen, on_mirror), far = in_clip(*seen, on_mirror + 2.5 * back);
  EXPECT_NEAR(near.x, far.x, 1e-9);
  EXPECT_NEAR(near.y, far.y, 1e-9);
}

TEST(Mirror, JustFillsThePicture) {
  const auto seen = view_in_mirror(kWall, viewer_at({1, 2, 3}, {0, 0, -1}), 0, kRoom);
  ASSERT_TRUE(seen);
  for (const glm::dvec3& corner : {kWall.corner, kWall.corner + kWall.right, kWall.corner + kWall.up}) {
    const glm::dvec3 clip = in_clip(*seen, corner);
    EXPECT_NEAR(std::abs(clip.x), 1, 1e-9);
    EXPECT_NEAR(std::abs(clip.y), 1, 1e-9);
    EXPECT_NEAR(clip.z, -1, 1e-9) << "the near plane lies in the mirror";
  }
  EXPECT_LT(in_clip(*seen, {0, 0, -0.5}).z, -1) << "behind the mirror";
  EXPECT_GT(in_clip(*seen, {0, 0, 0.5}).z, -1) << "before it";
}

TEST(Mirror, SeesNothingNearerThanItsDistance) {
  const auto seen = view_in_mirror(kWall, viewer_at({1, 2, 3}, {0, 0, -1}), 0.5, kRoom);
  ASSERT_TRUE(seen);
  EXPECT_LT(in_clip(*seen, {0, 0, 0.4}).z, -1);
  EXPECT_GT(in_clip(*seen, {0, 0, 0.6}).z, -1);
}

TEST(Mirror, IsOneFromBothSides) {
  const auto seen = view_in_mirror(kWall, viewer_at({1, 2, -3}, {0, 0, 1}), 0, kRoom);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->eye_to_world[3].z, 3, 1e-9);
  EXPECT_GT(in_clip(*seen, {0, 0, -0.5}).z, -1);
  EXPECT_LT(in_clip(*seen, {0, 0, 0.5}).z, -1);
}

TEST(Mirror, SendsParallelRaysBackParallel) {
  View viewer = look_along({0, 0, 10}, {1, 0, -1}, {0, 1, 0});
  viewer.projection = glm::ortho(-5.0, 5.0, -5.0, 5.0, 0.0, 20.0);
  const auto seen = view_in_mirror(kWall, viewer, 0, kRoom);
  ASSERT_TRUE(seen);
  const glm::dvec3 on_mirror(-1, 0.5, 0), back(1, 0, 1);
  const glm::dvec3 near = in_clip(*seen, on_mirror), far = in_clip(*seen, on_mirror + 4.0 * back);
  EXPECT_NEAR(near.x, far.x, 1e-9);
  EXPECT_NEAR(near.y, far.y, 1e-9);
  EXPECT_NEAR(near.z, -1, 1e-9);
  EXPECT_LT(std::abs(far.z), 1);
}

TEST(Mirror, IsNoneFromItsEdgeOrWithoutAnArea) {
  EXPECT_FALSE(view_in_mirror(kWall, viewer_at({1, 2, 0}, {-1, 0, 0}), 0, kRoom));
  EXPECT_FALSE(view_in_mirror({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, viewer_at({1, 2, 3}, {0, 0, -1}), 0, kRoom));
}

TEST(Mirror, StandsWhereItsShapeStands) {
  const PackedWindow window(PackedVec3(-1, -1, 0), PackedVec3(2, 0, 0), PackedVec3(0, 2, 0));
  const Mirror placed = place_mirror(window, glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, 7)));
  EXPECT_EQ(placed.corner, glm::dvec3(-1, -1, 7));
  EXPECT_EQ(placed.right, glm::dvec3(2, 0, 0));
}

}  // namespace
}  // namespace plugc
