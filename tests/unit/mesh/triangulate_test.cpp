#include "mesh/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace plugc {
namespace {

double area_of(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const double area = signed_area(std::vector{points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]}) / 2;
    EXPECT_GE(area, 0) << "triangle " << i / 3;
    sum += area;
  }
  return sum;
}

std::vector<glm::dvec2> star(std::size_t spikes, double inner) {
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < spikes * 2; ++i) {
    const double angle = 3.14159265358979 * double(i) / double(spikes), radius = i % 2 == 0 ? 1 : inner;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

TEST(Triangulate, CoversAStarEitherWayRound) {
  std::vector<glm::dvec2> points = star(9, 0.3);
  const double area = signed_area(points) / 2;
  const std::uint32_t end = 18;
  const std::vector<std::uint32_t> triangles = triangulate(points, {&end, 1});
  EXPECT_EQ(triangles.size(), 16u * 3);
  EXPECT_NEAR(area_of(points, triangles), area, 1e-9);
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(area_of(points, triangulate(points, {&end, 1})), area, 1e-9);
}

TEST(Triangulate, LeavesHolesOpen) {
  std::vector<glm::dvec2> points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  for (const glm::dvec2& center : {glm::dvec2(2, 2), glm::dvec2(7, 2), glm::dvec2(2, 7), glm::dvec2(7, 7.5)})
    for (const glm::dvec2& corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)})
      points.push_back(center + corner);
  const std::vector<std::uint32_t> ends = {4, 8, 12, 16, 20};
  EXPECT_NEAR(area_of(points, triangulate(points, ends)), 96, 1e-9);
}

TEST(Triangulate, BridgesPastReflexCorners) {
  // A spike of the outline stands between the hole and the corner that the ray points at.
  const std::vector<glm::dvec2> points = {{0, 0},  {10, 0}, {10, 1}, {4, 2.9}, {10, 3.2},
                                          {10, 6}, {0, 6},  {1, 2},  {2, 3},   {1, 4}};
  const std::vector<std::uint32_t> ends = {7, 10};
  const double outline = signed_area(std::span(points).first(7)) / 2,
               hole = std::abs(signed_area(std::span(points).last(3)) / 2);
  EXPECT_NEAR(area_of(points, triangulate(points, ends)), outline - hole, 1e-9);
}

TEST(Triangulate, CrossedPolygonsEndWithTheRightNumberOfTriangles) {
  const std::vector<glm::dvec2> bow_tie = {{0, 0}, {1, 1}, {1, 0}, {0, 1}, {0.5, 3}};
  const std::uint32_t end = 5;
  EXPECT_EQ(triangulate(bow_tie, {&end, 1}).size(), 9u);
  const std::vector<glm::dvec2> one_point(50, {1, 1});
  const std::uint32_t all = 50;
  EXPECT_EQ(triangulate(one_point, {&all, 1}).size(), 48u * 3);
}

TEST(Triangulate, SpendsWhatItIsGivenAndNoMore) {
  const std::vector<glm::dvec2> points = star(9, 0.3);
  const std::uint32_t end = 18;
  std::uint64_t work_left = 18 * 9 + 161;  // nine corners are reflex
  EXPECT_EQ(triangulate(points, {&end, 1}, &work_left).size(), 16u * 3);
  EXPECT_EQ(work_left, 161u);
  EXPECT_TRUE(triangulate(points, {&end, 1}, &work_left).empty());
  EXPECT_EQ(work_left, 161u);
}

TEST(Triangulate, TakesTheLargestPolygonsAndNoLarger) {
  const std::vector<glm::dvec2> largest = star(kMaxPolygonCorners / 2, 0.9), larger = star(kMaxPolygonCorners / 2 + 1, 0.9);
  const auto end = static_cast<std::uint32_t>(largest.size()), larger_end = static_cast<std::uint32_t>(larger.size());
  EXPECT_NEAR(area_of(largest, triangulate(largest, {&end, 1})), signed_area(largest) / 2, 1e-6);
  EXPECT_TRUE(triangulate(larger, {&larger_end, 1}).empty());
}

}  // namespace
}  // namespace plugc
