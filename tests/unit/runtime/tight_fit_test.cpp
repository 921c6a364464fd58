#include "runtime/tight_fit.h"

#include <glm/gtc/matrix_transform.hpp>

#include "degenerate_fits.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::box;

constexpr double kPi = std::numbers::pi;

LightFrame sun(const glm::dvec3& direction = {0, -1, 0}) {
  LightFrame light;
  light.direction = direction;
  light.up = {0, 0, -1};
  light.map_size = 1024;
  return light;
}

LightFrame lamp() {
  LightFrame light = sun();
  light.kind = PackedLightKind::spot;
  light.location = {0, 10, 0};
  light.angle = kPi / 2;
  return light;
}

/// A camera that sees 90 degrees each way.
View camera_at(const glm::dvec3& position, const glm::dvec3& direction) {
  View view = look_along(position, direction, {0, 1, 0});
  view.projection = glm::frustum(-0.1, 0.1, -0.1, 0.1, 0.1, 1000.0);
  return view;
}

TightFit fit(const LightFrame& light, const FitInput& input) {
  FitMemory memory;
  return fit_tightly(light, input, memory);
}

glm::dvec3 in_texture(const View& light, const glm::dvec3& point) {
  const glm::dvec4 projected = world_to_texture(light) * glm::dvec4(point, 1);
  return glm::dvec3(projected) / projected.w;
}

/// World units that the window measures along x at a receiver at height 0.
double width_at_ground(const View& light) {
  return 1 / std::abs(in_texture(light, {1, 0, 0}).x - in_texture(light, {0, 0, 0}).x);
}

const FitInput kTowerOnGround = {{box({-1, 0, -2}, {1, 5, 2})}, {box({-100, 0, -100}, {100, 0, 100})}};

TEST(TightFit, DepthOfASunFallsFromOneToAHalfOverWhatReceives) {
  LightFrame light = sun();
  light.near = 7;  // written distances are for maps that resolve less
  light.far = 8;
  const View view = fit(light, {{box({-1, 2, -2}, {1, 50, 2})}, {box({-9, 0, -9}, {9, 1, 9})}}).view;
  EXPECT_LE(in_texture(view, {0, 1, 0}).z, 1);
  EXPECT_GT(in_texture(view, {0, 1, 0}).z, 0.75);
  EXPECT_GE(in_texture(view, {0, 0, 0}).z, 0.5);
  EXPECT_LT(in_texture(view, {0, 0, 0}).z, 0.75);
  EXPECT_GT(in_texture(view, {0, 2, 0}).z, 1) << "a caster before all receivers is clamped to the near plane";
}

TEST(TightFit, DepthOfASpotFallsAsTheReciprocalOfDistance) {
  const View view = fit(lamp(), {{box({-1, 4, -1}, {1, 8, 1})}, {box({-5, 0, -5}, {5, 1, 5})}}).view;
  const double near = in_texture(view, {0, 8, 0}).z * 2;  // depth times distance is the same everywhere
  EXPECT_LE(near, 2);
  EXPECT_GT(near, 0.5);
  EXPECT_NEAR(in_texture(view, {0, 0, 0}).z * 10, near, 1e-9);
  EXPECT_NEAR(in_texture(view, {3, -1e9, 0}).z * 1e9, near, 1e-6);
}

TEST(TightFit, GivesTheSunsMapToWhereSomethingCasts) {
  const TightFit found = fit(sun(), kTowerOnGround);
  ASSERT_TRUE(found.needed);
  EXPECT_GE(width_at_ground(found.view), 2);
  EXPECT_LE(width_at_ground(found.view), 2 * 1.08);
}

TEST(TightFit, GivesALampsMapToWhereSomethingCasts) {
  // Seen from height 10 the tower's top, at 5, spans -1 / 5 .. 1 / 5; the ground there -2 .. 2.
  const TightFit found = fit(lamp(), kTowerOnGround);
  ASSERT_TRUE(found.needed);
  EXPECT_GE(width_at_ground(found.view), 4);
  EXPECT_LE(width_at_ground(found.view), 4 * 1.08);
}

TEST(TightFit, KeepsAWrittenRectangleAndAngle) {
  LightFrame light = sun();
  light.rectangle = {-2, -3, 4, 5};
  const View view = fit(light, kTowerOnGround).view;
  EXPECT_NEAR(in_texture(view, {-2, 0, 3}).x, 0, 1e-9);
  EXPECT_NEAR(in_texture(view, {4, 0, -5}).x, 1, 1e-9);
  EXPECT_NEAR(in_texture(view, {4, 0, -5}).y, 1, 1e-9);
  LightFrame spot = lamp();
  spot.angle_written = true;
  EXPECT_NEAR(in_texture(fit(spot, kTowerOnGround).view, {10, 0, 0}).x, 1, 1e-9) << "45 degrees aside";
}

/// How far a vertical edge lies aslant to a column of texels: columns by rows that it crosses.
double slant_of_verticals(const View& view) {
  const glm::dvec2 way = glm::dvec2(in_texture(view, {0, 1, 0}) - in_texture(view, {0, 0, 0}));
  return std::abs(way.x / way.y);
}

TEST(TightFit, LaysASunsMapAslantUnlessTheAuthorSaysHowItLies) {
  const FitInput cube = {{box({-1, 0, -1}, {1, 2, 1})}, {box({-100, 0, -100}, {100, 0, 100})}};
  for (const glm::dvec3& direction : {glm::dvec3(-0.9, -0.8, -0.5), glm::dvec3(0, -1, -1), glm::dvec3(1, -2, 0)}) {
    LightFrame light = sun(direction);
    light.up = {0, 1, 0};
    EXPECT_NEAR(slant_of_verticals(fit(light, cube).view), 0, 1e-9) << "`up` is written";
    light.up_written = false;
    EXPECT_GT(slant_of_verticals(fit(light, cube).view), 0.25);
    EXPECT_LT(slant_of_verticals(fit(light, cube).view), 0.5);
    light.rectangle = {-5, -5, 5, 5};
    EXPECT_NEAR(slant_of_verticals(fit(light, cube).view), 0, 1e-9) << "the rectangle is written";
  }
}

TEST(TightFit, FollowsTheCameraOverALargeTerrain) {
  // The terrain casts on itself, so without a camera the map has to hold all of it.
  FitInput terrain = {{box({-500, 0, -500}, {500, 2, 500})}, {box({-500, 0, -500}, {500, 2, 500})}};
  EXPECT_GE(width_at_ground(fit(sun(), terrain).view), 1000);
  const View camera = camera_at({100, 20, 100}, {0, -1, 0});
  terrain.camera = &camera;
  const View seen = fit(sun(), terrain).view;
  EXPECT_GE(width_at_ground(seen), 40);
  EXPECT_LE(width_at_ground(seen), 44);
  for (const glm::dvec3& corner : {glm::dvec3(80, 0, 80), glm::dvec3(120, 0, 120)}) {
    const glm::dvec3 found = in_texture(seen, corner);
    EXPECT_TRUE(found.x > 0 && found.x < 1 && found.y > 0 && found.y < 1);
  }
}

TEST(TightFit, HoldsCastersThatAreOutOfView) {
  // The camera looks down on the ground; the tower stands behind it, its shadow falls into the picture.
  FitInput input = {{box({-30, 0, -1}, {-29, 60, 1})}, {box({-100, 0, -100}, {100, 0, 100})}};
  const View camera = camera_at({10, 20, 0}, {0, -1, 0});
  input.camera = &camera;
  const TightFit found = fit(sun({1, -1, 0}), input);
  ASSERT_TRUE(found.needed);
  const glm::dvec3 shadow = in_texture(found.view, {0, 0, 0});  // of the tower at height 30
  EXPECT_TRUE(shadow.x > 0 && shadow.x < 1 && shadow.y > 0 && shadow.y < 1);
}

TEST(TightFit, IsNotNeededWhereNothingIsSeenOrNothingCasts) {
  FitInput input = kTowerOnGround;
  EXPECT_TRUE(fit(sun(), input).needed);
  const View away = camera_at({0, 20, 0}, {0, 1, 0});
  input.camera = &away;
  EXPECT_FALSE(fit(sun(), input).needed);
  const View far_aside = camera_at({90, 5, 90}, {0, -1, 0});
  input.camera = &far_aside;
  EXPECT_FALSE(fit(sun(), input).needed) << "what is in view receives from the ground and the sky alone";
  EXPECT_FALSE(fit(sun(), {{}, input.receivers}).needed);
  EXPECT_FALSE(fit(sun(), {input.casters, {}}).needed);
  EXPECT_FALSE(fit(sun(), {{box({-1, -9, -1}, {1, -8, 1})}, input.receivers}).needed) << "behind all receivers";
  LightFrame weak = lamp();
  weak.radius = 4;
  EXPECT_FALSE(fit(weak, kTowerOnGround).needed) << "the ground is out of reach";
}

TEST(TightFit, LetsShapesWithoutKnownBoundsBeAnywhere) {
  FitInput input = kTowerOnGround;
  input.casters[0].known = false;
  EXPECT_GE(width_at_ground(fit(sun(), input).view), 200);
  input = kTowerOnGround;
  input.receivers[0] = {{{50, 0, 50}, {51, 0, 51}}, glm::dmat4(1.0), false};
  const TightFit found = fit(sun(), input);
  ASSERT_TRUE(found.needed);
  EXPECT_GT(in_texture(found.view, {1, 0, 0}).x, in_texture(found.view, {-1, 0, 0}).x);
  EXPECT_LE(width_at_ground(found.view), 2.2);
}

TEST(TightFit, MovesByWholeTexels) {
  const FitInput terrain = {{box({-500, 0, -500}, {500, 2, 500})}, {box({-500, 0, -500}, {500, 2, 500})}};
  glm::dvec2 first(0);
  for (int i = 0; i < 40; ++i) {
    FitInput input = terrain;
    const View camera = camera_at({100 + i * 1.7, 20, 100 - i * 0.3}, {0, -1, 0});
    input.camera = &camera;
    const View view = fit(sun({0.3, -1, 0.2}), input).view;
    const glm::dvec2 texels = glm::dvec2(in_texture(view, {100, 0, 100})) * 1024.0;
    if (i == 0) first = texels;
    const glm::dvec2 moved = texels - first;
    EXPECT_NEAR(moved.x, std::round(moved.x), 1e-6) << i;
    EXPECT_NEAR(moved.y, std::round(moved.y), 1e-6) << i;
  }
}

TEST(TightFit, KeepsItsViewUnderSmallMovesOfTheCamera) {
  FitMemory memory;
  FitInput input = {{box({-500, 0, -500}, {500, 2, 500})}, {box({-500, 0, -500}, {500, 2, 500})}};
  int changes = 0;
  glm::dmat4 last(0.0);
  for (int i = 0; i < 160; ++i) {  // a sixteenth of a texel each
    const View camera = camera_at({100 + i * 44.0 / 1024 / 16, 20, 100}, {0, -1, 0});
    input.camera = &camera;
    const View view = fit_tightly(sun(), input, memory).view;
    const glm::dmat4 all = view.projection * view.world_to_eye;
    changes += all == last ? 0 : 1;
    last = all;
  }
  EXPECT_LE(changes, 2) << "ten texels are less than a step";
}

TEST(TightFit, NeedsNoMoreOfTheMapThanItsStepsCost) {
  // For any extent: texels at most 1.08 times as large as those of the smallest window.
  for (double size = 1; size < 3; size *= 1.013) {
    const FitInput input = {{box({-size, 0, -1}, {size, 5, 1})}, {box({-100, 0, -100}, {100, 0, 100})}};
    const double width = width_at_ground(fit(sun(), input).view);
    EXPECT_GE(width, 2 * size);
    EXPECT_LE(width, 2 * size * 1.08) << size;
  }
}

TEST(TightFit, LeavesRoomForLookUpsAroundWhatCasts) {
  for (const PackedShadowMethod method : {PackedShadowMethod::bilinear, PackedShadowMethod::pcf4, PackedShadowMethod::msm}) {
    LightFrame light = sun();
    light.reach = look_up_reach(method);
    for (double size = 1; size < 3; size *= 1.0013) {
      const FitInput input = {{box({-size, 0, -1}, {size, 5, 1})}, {box({-100, 0, -100}, {100, 0, 100})}};
      const View view = fit(light, input).view;
      const double low = in_texture(view, {-size, 0, 0}).x * light.map_size;
      const double high = in_texture(view, {size, 0, 0}).x * light.map_size;
      EXPECT_GE(std::min(low, high), light.reach) << size;
      EXPECT_LE(std::max(low, high), light.map_size - light.reach) << size;
    }
  }
  EXPECT_EQ(look_up_reach(PackedShadowMethod::pcf4), 2.5);
}

TEST(TightFit, IsFiniteForDegenerateScenes) {
  const PlacedBox unknown = {{glm::dvec3(-1), glm::dvec3(1)}, glm::dmat4(1.0), false};
  std::vector<FitInput> inputs = test::degenerate_fit_inputs();
  inputs.push_back({{unknown}, {unknown}});
  inputs.push_back({{box({-1, 8, -1}, {1, 12, 1})}, {box({-1, 8, -1}, {1, 12, 1})}});  // around the lamp
  const View camera = camera_at({0, 3, 0}, {0, -1, 0.1});
  for (LightFrame light : {sun(), lamp()}) {
    for (FitInput input : inputs) {
      for (const View* seen : {static_cast<const View*>(nullptr), &camera}) {
        input.camera = seen;
        for (const glm::dvec3& vector : test::degenerate_vectors()) {
          for (const std::uint32_t size : {1U, 17U, 1024U}) {
            light.direction = light.location = vector;
            light.map_size = size;
            const glm::dmat4 all = world_to_texture(fit(light, input).view);
            for (int i = 0; i < 16; ++i) EXPECT_LE(std::abs(all[i / 4][i % 4]), 3e38);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace plugc
