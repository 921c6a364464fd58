// Every method on one scene: a floor in the plane y = 0, seen from straight above by an orthographic view of 8 by 8 units, and
// a square of 3 by 3 units at height 2. The sun shines along (-1, -1, 0), so its shadow covers x from -3.5 to -0.5 and z from
// -1.5 to 1.5. White is lit, black is not; the square itself is black too.

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

constexpr std::uint32_t kSide = 256;  // pixels; 32 a unit

std::string scene_text(std::string_view light) {
  return fmt::format(R"(#X3D V4.0 utf8
NavigationInfo {{ headlight FALSE }}
OrthoViewpoint {{ position 0 10 0 orientation 1 0 0 -1.5707963267949 fieldOfView [ -4 -4 4 4 ] }}
{}
Shape {{
  appearance Appearance {{ material Material {{ diffuseColor 1 1 1 ambientIntensity 0 }} }}
  geometry IndexedFaceSet {{ coord Coordinate {{ point [ -5 0 5, 5 0 5, 5 0 -5, -5 0 -5 ] }} coordIndex [ 0 1 2 3 -1 ] }}
}}
Transform {{ translation 0 2 0 children Shape {{
  appearance Appearance {{ material Material {{ diffuseColor 0 0 0 ambientIntensity 0 }} }}
  geometry IndexedFaceSet {{ solid FALSE
    coord Coordinate {{ point [ -1.5 0 1.5, 1.5 0 1.5, 1.5 0 -1.5, -1.5 0 -1.5 ] }} coordIndex [ 0 1 2 3 -1 ] }}
}} }}
)",
                     light);
}

constexpr std::string_view kSun = "DirectionalLight { direction -1 -1 0 intensity 1.4143 shadows TRUE }";
// Over (2.5, 0), as far as the sun's shadow is long: its ray through the square's middle ends in (-2.5, 0), and the shadow is
// twice as large as the square.
constexpr std::string_view kLamp =
    "SpotLight { location 2.5 4 0 direction -1 -1 0 cutOffAngle 1.2 beamWidth 1.2 intensity 4 radius 100 shadows TRUE }";

Picture draw(std::string_view light, ShadowMethod method, std::uint32_t size) {
  CompileOptions options;
  options.shadows = {method, size};
  const Compiled compiled = compile_text(scene_text(light), options);
  EXPECT_THAT(compiled.messages(), testing::IsEmpty());
  return draw_package(*compiled.package, kSide, kSide);
}

std::uint32_t pixel(double coordinate) {
  return static_cast<std::uint32_t>(std::lround((coordinate + 4) * kSide / 8 - 0.5));
}

/// Brightness along z = 0 from inside the shadow, at x = -2.8, to beyond its far edge at -3.5.
std::vector<int> row_into_light(const Picture& picture) {
  std::vector<int> row;
  for (std::uint32_t x = pixel(-2.8); x > 0; --x) row.push_back(color_at(picture, x, kSide / 2)[0]);
  return row;
}

class ShadowMethods : public testing::TestWithParam<std::string_view> {
 protected:
  ShadowMethod method() const { return shadow_method_named(GetParam()).value(); }
};

TEST_P(ShadowMethods, LeaveTheMiddleOfAShadowDarkAndAllElseLit) {
  for (const std::string_view light : {kSun, kLamp}) {
    const Picture picture = draw(light, method(), 256);
    EXPECT_LE(color_at(picture, pixel(-2.2), kSide / 2)[0], 1) << light;
    EXPECT_EQ(color_at(picture, pixel(2), pixel(3))[0], 255) << light;
    EXPECT_EQ(color_at(picture, pixel(2), pixel(-3.5))[0], 255) << light;
  }
}

TEST_P(ShadowMethods, CrossAnEdgeWithoutTurningBack) {
  if (method() == ShadowMethod::poisson) GTEST_SKIP() << "its noise is no edge";
  const std::vector<int> row = row_into_light(draw(kSun, method(), 64));
  EXPECT_LE(row.front(), 1);
  EXPECT_EQ(row.back(), 255);
  for (std::size_t i = 1; i < row.size(); ++i) EXPECT_GE(row[i] + 1, row[i - 1]) << "at " << i;
}

TEST_P(ShadowMethods, DrawAStillPictureTwice) {
  EXPECT_EQ(draw(kSun, method(), 64).pixels, draw(kSun, method(), 64).pixels);
}

std::string test_name(const testing::TestParamInfo<std::string_view>& info) {
  return std::string(info.param);
}

INSTANTIATE_TEST_SUITE_P(All, ShadowMethods, testing::ValuesIn(shadow_method_names().begin(), shadow_method_names().end()),
                         test_name);

int largest_difference(const Picture& a, const Picture& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

// Gathers and look-ups weigh the same texels alike.
TEST(ShadowKernels, AreTheSameThroughGathersAndThroughTaps) {
  const std::pair<ShadowMethod, ShadowMethod> kernels[] = {{ShadowMethod::pcf2, ShadowMethod::pcf2_taps},
                                                           {ShadowMethod::pcf3, ShadowMethod::pcf3_taps},
                                                           {ShadowMethod::pcf4, ShadowMethod::pcf4_taps}};
  for (const auto& [gathered, tapped] : kernels) {
    for (const std::string_view light : {kSun, kLamp}) {
      for (const std::uint32_t size : {3U, 16U, 61U})
        EXPECT_LE(largest_difference(draw(light, gathered, size), draw(light, tapped, size)), 1) << to_text(gathered) << size;
    }
  }
  EXPECT_GT(largest_difference(draw(kSun, ShadowMethod::pcf2, 61), draw(kSun, ShadowMethod::pcf3, 61)), 20);
}

std::size_t greys(const std::vector<int>& row) {
  return static_cast<std::size_t>(std::ranges::count_if(row, [](int value) { return value > 1 && value < 254; }));
}

TEST(ShadowKernels, OfANearestTexelHaveNoGreys) {
  const Picture picture = draw(kSun, ShadowMethod::hard, 64);
  std::set<std::uint8_t> values;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) values.insert(picture.pixels[i]);
  EXPECT_THAT(values, testing::ElementsAre(0, 255));
}

// 32 texels over some 4 units: a texel is some four pixels wide, and the 3 x 3 kernel's edge some sixteen.
TEST(ShadowKernels, AreSharpenedToAPixel) {
  EXPECT_GE(greys(row_into_light(draw(kSun, ShadowMethod::pcf3, 32))), 8U);
  EXPECT_LE(greys(row_into_light(draw(kSun, ShadowMethod::sharp3, 32))), 2U);
}

// A second, larger square half as high: over the shadow that it casts on the floor (x from -4 to 0, less the square itself, z
// from -2.5 to 2.5) the edges of the first one run, where a bound on light is weakest.
TEST(ShadowMoments, LeakLittleWhereCastersOverlap) {
  const std::string second = R"(Transform { translation -1 1 0 children Shape {
    appearance Appearance { material Material { diffuseColor 0 0 0 ambientIntensity 0 } }
    geometry IndexedFaceSet { solid FALSE
      coord Coordinate { point [ -2 0 2.5, 2 0 2.5, 2 0 -2.5, -2 0 -2.5 ] } coordIndex [ 0 1 2 3 -1 ] } } })";
  for (const ShadowMethod method : {ShadowMethod::vsm, ShadowMethod::evsm, ShadowMethod::msm}) {
    CompileOptions options;
    options.shadows = {method, 256};
    const Compiled compiled = compile_text(scene_text(kSun) + second, options);
    const Picture picture = draw_package(*compiled.package, kSide, kSide);
    double sum = 0;
    int count = 0;
    for (std::uint32_t y = pixel(-2.3); y <= pixel(2.3); ++y) {
      for (std::uint32_t x = pixel(-3.8); x < pixel(-3.05); ++x, ++count) sum += color_at(picture, x, y)[0] / 255.0;
    }
    EXPECT_LE(sum / count, 0.0005) << to_text(method);
  }
}

// A caster whose vertices are no numbers vanishes; the moments around it stay those of the rest.
TEST(ShadowMoments, SurviveNumbersThatAreNone) {
  const std::string broken = R"(Transform { translation 2 2 2 children Shape {
    appearance Appearance { material Material { }
      effects Effect { inputOutput SFFloat zero 0 parts EffectPart { type "VERTEX" url "data:text/plain,
        uniform float zero;
        void PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) { if (v.x > 0.0) v.y = zero / zero; }" } } }
    geometry Box { } } })";
  for (const ShadowMethod method : {ShadowMethod::vsm, ShadowMethod::evsm, ShadowMethod::msm}) {
    CompileOptions options;
    options.shadows = {method, 64};
    const Compiled compiled = compile_text(scene_text(kSun) + broken, options);
    const Picture picture = draw_package(*compiled.package, kSide, kSide);
    EXPECT_LE(color_at(picture, pixel(-2.2), kSide / 2)[0], 1) << to_text(method);
    EXPECT_EQ(color_at(picture, pixel(-3.8), pixel(-3.8))[0], 255) << to_text(method);
  }
}

// Without its map a shape is lit, whatever the stand-in for the moments holds.
TEST(ShadowMoments, ThatNobodyDrewShadowNothing) {
  for (const ShadowMethod method : {ShadowMethod::vsm, ShadowMethod::evsm, ShadowMethod::msm}) {
    CompileOptions options;
    options.shadows = {method, 64};
    std::string text = scene_text(kSun);
    text.replace(text.find("translation 0 2 0 children Shape {"), 34, "translation 0 2 0 children Shape { castShadow FALSE");
    const Compiled compiled = compile_text(text, options);
    const Picture picture = draw_package(*compiled.package, kSide, kSide);
    EXPECT_EQ(color_at(picture, pixel(-2.2), kSide / 2)[0], 255) << to_text(method);
  }
}

}  // namespace
}  // namespace plugc
