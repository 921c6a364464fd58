// A flat mirror's rectangle: around all of it, in its plane.

#include "mesh/mirror_window.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

Mesh quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_NEAR(found.x, expected.x, 1e-6);
  EXPECT_NEAR(found.y, expected.y, 1e-6);
  EXPECT_NEAR(found.z, expected.z, 1e-6);
}

TEST(MirrorWindow, IsTheRectangleItself) {
  const auto window = mirror_window(quad({-2, -1, 5}, {2, -1, 5}, {2, 1, 5}, {-2, 1, 5}));
  ASSERT_TRUE(window);
  expect_near(window->corner, {-2, -1, 5});
  expect_near(window->right, {4, 0, 0});
  expect_near(window->up, {0, 2, 0});
}

TEST(MirrorWindow, OfAFloorHasItsUpAwayFromTheViewer) {
  const auto window = mirror_window(quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}));
  ASSERT_TRUE(window);
  expect_near(window->corner, {-1, 0, 1});
  expect_near(window->right, {2, 0, 0});
  expect_near(window->up, {0, 0, -2});
}

TEST(MirrorWindow, OfAThinPlateIsItsLargeSide) {
  Mesh plate = quad({-1, -1, 0.1F}, {1, -1, 0.1F}, {1, 1, 0.1F}, {-1, 1, 0.1F});
  plate.positions.insert(plate.positions.end(), {{-1, -1, -0.1F}, {1, -1, -0.1F}, {1, 1, -0.1F}, {-1, 1, -0.1F}});
  plate.indices.insert(plate.indices.end(), {4, 6, 5, 4, 7, 6});
  const auto window = mirror_window(plate);
  ASSERT_TRUE(window);
  expect_near(window->corner, {-1, -1, 0});
  expect_near(glm::abs(window->right), {2, 0, 0});
}

TEST(MirrorWindow, NeedsAnArea) {
  EXPECT_FALSE(mirror_window(quad({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0})));
  EXPECT_FALSE(mirror_window(Mesh()));
  Mesh lines = quad({-2, -1, 5}, {2, -1, 5}, {2, 1, 5}, {-2, 1, 5});
  lines.topology = Topology::lines;
  EXPECT_FALSE(mirror_window(lines));
}

}  // namespace
}  // namespace plugc
