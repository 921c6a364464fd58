// Expected values are worked out by hand from the formulas of X3D 4.1, clause 19.

#include "runtime/interpolate.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

namespace plugc {
namespace {

using Numbers = std::vector<double>;

constexpr double kPi = std::numbers::pi;

auto is_about(const Numbers& expected) {
  constexpr double kError = 1e-9;
  return testing::Pointwise(testing::DoubleNear(kError), expected);
}

TEST(Interpolate, GoesStraightBetweenKeysAndStaysOutside) {
  const Numbers keys = {0, 0.5, 1}, values = {0, 10, 4, 20, 8, 0};
  const KeyFrames frames{keys, values, 2};
  EXPECT_THAT(interpolate_linear(-1, frames), is_about({0, 10}));
  EXPECT_THAT(interpolate_linear(0.25, frames), is_about({2, 15}));
  EXPECT_THAT(interpolate_linear(0.5, frames), is_about({4, 20}));
  EXPECT_THAT(interpolate_linear(0.75, frames), is_about({6, 10}));
  EXPECT_THAT(interpolate_linear(7, frames), is_about({8, 0}));
}

TEST(Interpolate, JumpsWhereTwoKeysAreEqual) {
  const Numbers keys = {0, 0.5, 0.5, 1}, values = {0, 1, 5, 6};
  const KeyFrames frames{keys, values, 1};
  EXPECT_THAT(interpolate_linear(0.25, frames), is_about({0.5}));
  EXPECT_THAT(interpolate_linear(0.5, frames), is_about({5}));
  EXPECT_THAT(interpolate_linear(0.75, frames), is_about({5.5}));
}

TEST(Interpolate, TakesAsManyKeysAsHaveValues) {
  const Numbers keys = {0, 1, 2, 3}, values = {1, 2};
  EXPECT_THAT(interpolate_linear(2.5, {keys, values, 1}), is_about({2}));
  EXPECT_EQ((KeyFrames{keys, values, 3}.count()), 0U);
}

TEST(Interpolate, StaysWithinTheListWhateverTheNumbers) {
  const Numbers keys = {1, 0, std::nan(""), 5}, values = {1, 2, 3, 4};
  for (const double fraction : {-1.0, 0.0, 0.5, 1.0, 3.0, 9.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Numbers value = interpolate_linear(fraction, {keys, values, 1});
    ASSERT_EQ(value.size(), 1U);
    EXPECT_TRUE(value[0] >= 1 && value[0] <= 4) << fraction;
  }
}

TEST(Interpolate, MixesColoursByHue) {
  const Numbers keys = {0, 1};
  const Numbers red_to_green = {1, 0, 0, 0, 1, 0};
  EXPECT_THAT(interpolate_color(0.5, {keys, red_to_green, 3}), is_about({1, 1, 0}));
  const Numbers red_to_blue = {1, 0, 0, 0, 0, 1};  // the shorter way leads over magenta
  EXPECT_THAT(interpolate_color(0.5, {keys, red_to_blue, 3}), is_about({1, 0, 1}));
  const Numbers white_to_blue = {1, 1, 1, 0, 0, 1};  // white has no hue of its own
  EXPECT_THAT(interpolate_color(0.5, {keys, white_to_blue, 3}), is_about({0.5, 0.5, 1}));
  const Numbers grey = {0.2, 0.2, 0.2, 0.6, 0.6, 0.6};
  EXPECT_THAT(interpolate_color(0.25, {keys, grey, 3}), is_about({0.3, 0.3, 0.3}));
}

TEST(Interpolate, TurnsNormalsAlongTheArc) {
  const Numbers keys = {0, 1}, values = {1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
  const double half = std::sqrt(0.5);
  EXPECT_THAT(interpolate_normals(0.5, {keys, values, 6}), is_about({half, half, 0, 0, 0, 1}));
  EXPECT_THAT(interpolate_normals(1.0 / 3, {keys, values, 6}), is_about({std::cos(kPi / 6), 0.5, 0, 0, 0, 1}));
  const Numbers opposite = {1, 0, 0, -1, 0, 0};  // any arc would do: the result is a unit vector
  const Numbers between = interpolate_normals(0.5, {keys, opposite, 3});
  EXPECT_NEAR(between[0] * between[0] + between[1] * between[1] + between[2] * between[2], 1, 1e-9);
}

TEST(Interpolate, TurnsRotationsTheShorterWay) {
  const Numbers keys = {0, 1};
  const Numbers quarter = {0, 0, 1, 0, 0, 0, 1, kPi / 2};
  EXPECT_THAT(interpolate_rotation(0.5, {keys, quarter, 4}), is_about({0, 0, 1, kPi / 4}));
  const Numbers far = {0, 0, 1, 0.25 * kPi, 0, 0, 1, 1.75 * kPi};  // a quarter of a turn backwards
  const Numbers between = interpolate_rotation(0.25, {keys, far, 4});
  EXPECT_NEAR(std::remainder(between[2] * between[3], 2 * kPi), 0.125 * kPi, 1e-9);
  const Numbers axes = {1, 0, 0, kPi / 2, 0, 1, 0, kPi / 2};  // half way: 90 degrees about their bisector, by quaternions
  const double angle = 2 * std::acos(std::sqrt(2.0 / 3));
  const double half = std::sqrt(0.5);
  EXPECT_THAT(interpolate_rotation(0.5, {keys, axes, 4}), is_about({half, half, 0, angle}));
}

TEST(Interpolate, KeepsRotationsAsTheyAreWrittenAtTheirKeys) {
  const Numbers keys = {0, 1}, values = {0, 3, 0, 7, 0, 0, 1, 1};
  EXPECT_THAT(interpolate_rotation(0, {keys, values, 4}), is_about({0, 3, 0, 7}));
  const Numbers no_axis = {0, 0, 0, 1, 0, 0, 1, 1};
  EXPECT_THAT(interpolate_rotation(0.5, {keys, no_axis, 4}), is_about({0, 0, 1, 0.5}));
}

TEST(Interpolate, SquadTurnsEvenlyWhereItsKeysDo) {
  const Numbers keys = {0, 1, 2, 3};
  const Numbers values = {0, 0, 1, 0, 0, 0, 1, 0.5, 0, 0, 1, 1, 0, 0, 1, 1.5};
  EXPECT_THAT(interpolate_squad(1.5, {keys, values, 4}), is_about({0, 0, 1, 0.75}));
  EXPECT_THAT(interpolate_squad(2, {keys, values, 4}), is_about({0, 0, 1, 1}));
  const Numbers at_rest = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
  EXPECT_THAT(interpolate_squad(1.5, {keys, at_rest, 4}), is_about({0, 0, 1, 1}));
}

TEST(Interpolate, SplineHasNoSpeedAtOpenEnds) {
  const Numbers keys = {0, 1, 2}, values = {0, 1, 0};
  const KeyFrames frames{keys, values, 1};
  // First half: tangents 0 and (0 - 0) / 2, so 3 s^2 - 2 s^3.
  EXPECT_THAT(interpolate_spline(0.5, frames, {}), is_about({0.5}));
  EXPECT_THAT(interpolate_spline(0.25, frames, {}), is_about({3.0 / 16 - 2.0 / 64}));
  EXPECT_THAT(interpolate_spline(1, frames, {}), is_about({1}));
}

TEST(Interpolate, SplineLeavesAnInnerKeyAlongItsNeighbours) {
  const Numbers keys = {0, 1, 2, 3}, values = {0, 1, 4, 9};
  // Between keys 1 and 2: tangents (4 - 0) / 2 and (9 - 1) / 2; at s = 1/2: (1 + 4) / 2 + 2 / 8 - 4 / 8.
  EXPECT_THAT(interpolate_spline(1.5, {keys, values, 1}, {}), is_about({2.25}));
}

TEST(Interpolate, SplineHeedsUnequalIntervals) {
  const Numbers keys = {0, 1, 4}, values = {0, 1, 2};
  // At key 1 the tangent is 1, times 2 * 3 / 4 in front of it and 2 * 1 / 4 behind it.
  EXPECT_THAT(interpolate_spline(0.5, {keys, values, 1}, {}), is_about({0.5 - 1.5 / 8}));
  EXPECT_THAT(interpolate_spline(2.5, {keys, values, 1}, {}), is_about({1.5 + 0.5 / 8}));
}

TEST(Interpolate, AClosedSplineIsSmoothWhereItMeets) {
  const Numbers keys = {0, 1, 2, 3}, values = {0, 2, -2, 0};
  // At both ends the tangent is (2 - -2) / 2; at key 1 it is (-2 - 0) / 2.
  EXPECT_THAT(interpolate_spline(0.5, {keys, values, 1}, {.velocities = {}, .normalize = false, .closed = true}),
              is_about({1 + 2.0 / 8 + 1.0 / 8}));
  EXPECT_THAT(interpolate_spline(0.5, {keys, values, 1}, {}), is_about({1 + 1.0 / 8}));
}

TEST(Interpolate, SplineTakesVelocities) {
  const Numbers keys = {0, 1}, values = {0, 0, 3, 4};
  const Numbers velocities = {0, 8, 0, 8};
  // At s = 1/2 tangents count 1/8 and -1/8: equal ones cancel out.
  EXPECT_THAT(interpolate_spline(0.5, {keys, values, 2}, {.velocities = velocities}), is_about({1.5, 2}));
  EXPECT_THAT(interpolate_spline(0.25, {keys, values, 2}, {.velocities = velocities}),
              is_about({3 * 10.0 / 64, 4 * 10.0 / 64 + 8 * 9.0 / 64 - 8 * 3.0 / 64}));
  // Normalised, they are as long as the whole way: 5.
  EXPECT_THAT(interpolate_spline(0.25, {keys, values, 2}, {.velocities = velocities, .normalize = true}),
              is_about({3 * 10.0 / 64, 4 * 10.0 / 64 + 5 * 9.0 / 64 - 5 * 3.0 / 64}));
}

TEST(Interpolate, EasesOutAndIn) {
  const Numbers keys = {0, 1}, easing = {0, 0.5, 0.25, 0};
  // 1 / (2 - 0.25 - 0.5) = 0.8.
  EXPECT_NEAR(ease(0.25, keys, easing), 0.8 / 0.5 * 0.0625, 1e-12);
  EXPECT_NEAR(ease(0.6, keys, easing), 0.8 * (1.2 - 0.5), 1e-12);
  EXPECT_NEAR(ease(0.9, keys, easing), 1 - 0.8 * 0.01 / 0.25, 1e-12);
  EXPECT_EQ(ease(2, keys, easing), 1);
  EXPECT_EQ(ease(-1, keys, easing), 0);
  const Numbers none = {0, 0, 0, 0};
  EXPECT_NEAR(ease(0.3, keys, none), 0.3, 1e-12);
  const Numbers too_much = {0, 3, 1, 0};  // scaled to 0.75 and 0.25
  EXPECT_NEAR(ease(0.5, keys, too_much), 1 / 0.75 * 0.25, 1e-12);
}

}  // namespace
}  // namespace plugc
