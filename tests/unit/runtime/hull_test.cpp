#include "runtime/hull.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace plugc {
namespace {

Hull cube(double low, double high) {
  return hull_of({glm::dvec3(low), glm::dvec3(high)}, glm::dmat4(1.0));
}

Box bounds(std::initializer_list<const Hull*> hulls) {
  Box box;
  for (const glm::dvec3& point : common_points(std::vector<const Hull*>(hulls))) box = join(box, {point, point});
  return box;
}

void expect_box(const Box& box, const glm::dvec3& low, const glm::dvec3& high) {
  ASSERT_FALSE(box.empty());
  EXPECT_NEAR(glm::distance(box.min, low), 0, 1e-9);
  EXPECT_NEAR(glm::distance(box.max, high), 0, 1e-9);
}

TEST(Hull, OfOneBoxHasItsCorners) {
  const Hull one = cube(-1, 2);
  expect_box(bounds({&one}), glm::dvec3(-1), glm::dvec3(2));
}

TEST(Hull, CommonPartOfTwoBoxesIsSeenFromEither) {
  const Hull large = cube(-5, 5);
  const Hull small = cube(1, 2);
  const Hull beside = cube(4, 7);
  expect_box(bounds({&large, &small}), glm::dvec3(1), glm::dvec3(2));
  expect_box(bounds({&small, &large}), glm::dvec3(1), glm::dvec3(2));
  expect_box(bounds({&large, &beside}), glm::dvec3(4), glm::dvec3(5));
  EXPECT_TRUE(bounds({&small, &beside}).empty());
}

TEST(Hull, IsTighterThanTheBoxAroundIt) {
  // A bar turned by 45 degrees, cut by a slab: its box would reach 5 / sqrt(2) along y.
  const Hull bar =
      hull_of({{-5, -0.1, -0.1}, {5, 0.1, 0.1}}, glm::rotate(glm::dmat4(1.0), std::atan(1.0), glm::dvec3(0, 0, 1)));
  const Hull slab = hull_of({{-1, -9, -9}, {1, 9, 9}}, glm::dmat4(1.0));
  EXPECT_NEAR(bounds({&bar, &slab}).max.y, 1 + 0.1 * std::sqrt(2.0), 1e-9);
}

TEST(Hull, OfAFlatBoxIsCutLikeAnyOther) {
  const Hull ground = hull_of({{-100, 0, -100}, {100, 0, 100}}, glm::dmat4(1.0));
  const Hull room = cube(-1, 1);
  expect_box(bounds({&ground, &room}), {-1, 0, -1}, {1, 0, 1});
  const Hull above = cube(1, 2);
  EXPECT_TRUE(bounds({&ground, &above}).empty());
}

TEST(Hull, OfAViewInsideABoxEndsAtTheBox) {
  const glm::dmat4 projection = glm::frustum(-0.1, 0.1, -0.1, 0.1, 0.1, 1000.0);  // 45 degrees each way
  const Hull view = view_hull(glm::dmat4(1.0), projection);
  const Hull room = cube(-2, 2);
  expect_box(bounds({&view, &room}), glm::dvec3(-2), {2, 2, 0});
  const Hull behind = hull_of({{-1, -1, 1}, {1, 1, 2}}, glm::dmat4(1.0));
  EXPECT_TRUE(bounds({&view, &behind}).empty());
}

TEST(Hull, OfAnOrthographicViewIsABar) {
  const Hull view = view_hull(glm::dmat4(1.0), glm::ortho(-1.0, 1.0, -2.0, 2.0, -50.0, 50.0));
  const Hull room = cube(-5, 5);
  expect_box(bounds({&view, &room}), {-1, -2, -5}, {1, 2, 5});
}

TEST(Hull, OfNoUsableBoxHasNothing) {
  const Hull empty = hull_of(Box(), glm::dmat4(1.0));
  const Hull endless = hull_of({glm::dvec3(-1), glm::dvec3(1)}, glm::dmat4(std::numeric_limits<double>::quiet_NaN()));
  const Hull room = cube(-5, 5);
  EXPECT_TRUE(bounds({&empty, &room}).empty());
  EXPECT_TRUE(bounds({&endless, &room}).empty());
  const Hull point = hull_of({glm::dvec3(-1), glm::dvec3(1)}, glm::dmat4(glm::dmat3(0.0)));
  expect_box(bounds({&point, &room}), glm::dvec3(0), glm::dvec3(0));
}

}  // namespace
}  // namespace plugc
