// Linear depth is computed twice: of a place that may be in shadow, from the place itself, and of what casts, from the depth
// that a map stores. Both must agree wherever the light looks.

#include "runtime/tight_fit.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

PlacedBox box(const glm::dvec3& low, const glm::dvec3& high) {
  return {{low, high}, glm::dmat4(1.0)};
}

LightFrame light_of(PackedLightKind kind) {
  LightFrame light;
  light.kind = kind;
  light.location = {1, 10, 2};
  light.direction = {0.2, -1, 0.1};
  light.angle = 1.2;
  light.map_size = 512;
  return light;
}

double from_stored(const View& view, const glm::dvec3& place) {
  const glm::dvec4 clip = view.projection * view.world_to_eye * glm::dvec4(place, 1);
  const double depth = view.reversed ? clip.z / clip.w : clip.z / clip.w * 0.5 + 0.5;
  const glm::dvec4 line = linear_depth_line(view);
  return (line.x * depth + line.y) / (line.z * depth + line.w);
}

double from_place(const View& view, const glm::dvec3& place) {
  return glm::dot(linear_depth_plane(view), glm::dvec4(place, 1));
}

std::vector<View> views() {
  const FitInput input{{box({-1, 0, -1}, {1, 3, 1})}, {box({-6, 0, -6}, {6, 0, 6})}};
  std::vector<View> all;
  for (const PackedLightKind kind : {PackedLightKind::directional, PackedLightKind::spot}) {
    all.push_back(fit_light(light_of(kind), input));
    FitMemory memory;
    all.push_back(fit_tightly(light_of(kind), input, memory).view);
  }
  return all;
}

TEST(LinearDepth, OfAPlaceIsThatOfItsTexel) {
  for (const View& view : views()) {
    for (const glm::dvec3& place : {glm::dvec3(0, 0, 0), glm::dvec3(0.5, 2.5, -0.5), glm::dvec3(-1, 1, 1), glm::dvec3(2, 0, 2)})
      EXPECT_NEAR(from_stored(view, place), from_place(view, place), 1e-9);
  }
}

TEST(LinearDepth, OfReceiversIsBetweenNearAndFarAndGrowsWithDistance) {
  for (const View& view : views()) {
    const double near = from_place(view, {0, 3, 0});
    const double far = from_place(view, {0, 0, 0});
    EXPECT_LT(near, far);
    EXPECT_GE(far, 0);
    EXPECT_LE(far, 1);
  }
}

TEST(LinearDepth, OfAViewWithoutARangeIsNothing) {
  EXPECT_EQ(linear_depth_plane(View()), glm::dvec4(0));
}

}  // namespace
}  // namespace plugc
