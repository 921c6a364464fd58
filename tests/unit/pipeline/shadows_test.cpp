// Shadows, with colours computed by hand.
//
// The scene: a floor in the plane y = 0, seen from straight above by an orthographic view of 8 by 8 units, so that pixel
// (x, y) of a 64 by 64 picture shows the point (x - 31.5) / 8, 0, (y - 31.5) / 8. A square of 1 by 1 floats over the middle
// and casts. Lights come from above but slanted along x, so that the shadow does not lie under the square.
//
// The sum (X3D 4.1, 17.2.2, with the reference's global ambient light of 0.2; no specular part, no headlight):
//   colour = 0.2 * ambientIntensity * diffuse + sum over lights of shadow * (diffuse * light * N.L + ambient)

#include <cmath>

#include <fmt/format.h>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

constexpr double kDiffuse = 0.5;
constexpr double kAmbientIntensity = 0.4;
constexpr double kGlobalAmbient = 0.2 * kAmbientIntensity * kDiffuse;  // 0.04

/// Floor and square under the given lights. `floor` goes into the floor's Appearance, `square` into the square's Shape.
std::string scene_text(std::string_view lights, std::string_view floor = "", std::string_view square = "") {
  return fmt::format(R"(#X3D V4.0 utf8
NavigationInfo {{ headlight FALSE }}
OrthoViewpoint {{ position 0 10 0 orientation 1 0 0 -1.5707963267949 fieldOfView [ -4 -4 4 4 ] }}
{}
Shape {{
  appearance Appearance {{ material Material {{ diffuseColor 0.5 0.5 0.5 ambientIntensity 0.4 }} {} }}
  geometry IndexedFaceSet {{ coord Coordinate {{ point [ -5 0 5, 5 0 5, 5 0 -5, -5 0 -5 ] }} coordIndex [ 0 1 2 3 -1 ] }}
}}
Shape {{
  {}
  appearance Appearance {{ material Material {{ }} {} }}
  geometry IndexedFaceSet {{ solid FALSE
    coord Coordinate {{ point [ -0.5 2 0.5, 0.5 2 0.5, 0.5 2 -0.5, -0.5 2 -0.5 ] }} coordIndex [ 0 1 2 3 -1 ] }}
}}
)",
                     lights, floor, square.starts_with("cast") ? square : "", square.starts_with("shadow") ? square : "");
}

struct Floor {
  Color shadowed;  ///< At (-2, 0, 0).
  Color lit;       ///< At (2, 0, 0).
};

std::uint32_t pixel(double x) {
  return static_cast<std::uint32_t>(std::lround(x * 8 + 31.5));
}

Floor draw_floor(const std::string& text) {
  const Compiled compiled = compile_text(text);
  EXPECT_THAT(compiled.messages(), testing::IsEmpty());
  const Picture picture = draw_package(*compiled.package);
  return {color_at(picture, pixel(-2), 32), color_at(picture, pixel(2), 32)};
}

Color grey(double factor) {
  return from_factors(factor, factor, factor);
}

// The sun shines along (-1, -1, 0), so that the shadow of the square at height 2 lies 2 units along -x, around (-2, 0, 0).
// N.L = 1 / sqrt(2). Its own ambient term is ambientIntensity (0.5) * ambient colour (0.4 * 0.5).
constexpr std::string_view kSun =
    "DEF Sun DirectionalLight { direction -1 -1 0 intensity 0.8 ambientIntensity 0.5 shadows TRUE }";
const double kSunDiffuse = kDiffuse * 0.8 / std::sqrt(2.0);         // 0.28284
constexpr double kSunAmbient = 0.5 * kAmbientIntensity * kDiffuse;  // 0.1

// The lamp stands at (2, 4, 0) and looks at (-2, 0, 0); the ray to it passes (0, 2, 0), the square's middle.
// At (2, 0, 0), below the lamp, N.L = 1; the angle to the lamp's axis is 45 degrees, inside the cone of 60. No attenuation,
// and beamWidth = cutOffAngle: full intensity up to the cone's edge.
constexpr std::string_view kLamp =
    "DEF Lamp SpotLight { location 2 4 0 direction -1 -1 0 cutOffAngle 1.0472 beamWidth 1.0472 intensity 0.8 radius 100 "
    "shadows TRUE }";
constexpr double kLampBelow = kDiffuse * 0.8;  // 0.4

TEST(Shadows, OfADirectionalLightDarkenItsDiffuseAndAmbientTerm) {
  const Floor floor = draw_floor(scene_text(kSun));
  EXPECT_THAT(floor.shadowed, IsColor(grey(kGlobalAmbient)));                         // 0.04
  EXPECT_THAT(floor.lit, IsColor(grey(kGlobalAmbient + kSunDiffuse + kSunAmbient)));  // 0.42284
}

TEST(Shadows, OfASpotLightFallWhereItsRaysAreCut) {
  const Floor floor = draw_floor(scene_text(kLamp));
  EXPECT_THAT(floor.shadowed, IsColor(grey(kGlobalAmbient)));          // 0.04
  EXPECT_THAT(floor.lit, IsColor(grey(kGlobalAmbient + kLampBelow)));  // 0.44
}

// A blue light from straight above (N.L = 1) without shadows adds 0.5 * 0.6 to blue in both places.
constexpr std::string_view kBlue = " DirectionalLight { direction 0 -1 0 color 0 0 1 intensity 0.6 }";

TEST(Shadows, LeaveOtherLightsAlone) {
  const Floor floor = draw_floor(scene_text(std::string(kSun) + std::string(kBlue)));
  EXPECT_THAT(floor.shadowed, IsColor(from_factors(kGlobalAmbient, kGlobalAmbient, kGlobalAmbient + 0.3)));
  const double lit = kGlobalAmbient + kSunDiffuse + kSunAmbient;
  EXPECT_THAT(floor.lit, IsColor(from_factors(lit, lit, lit + 0.3)));

  const Floor under_lamp = draw_floor(scene_text(std::string(kLamp) + std::string(kBlue)));
  EXPECT_THAT(under_lamp.shadowed, IsColor(from_factors(kGlobalAmbient, kGlobalAmbient, kGlobalAmbient + 0.3)));
  EXPECT_THAT(under_lamp.lit, IsColor(from_factors(kGlobalAmbient + kLampBelow, kGlobalAmbient + kLampBelow,
                                                   kGlobalAmbient + kLampBelow + 0.3)));
}

TEST(Shadows, OfHalfIntensityTakeHalf) {
  const Floor floor = draw_floor(
      scene_text("DirectionalLight { direction -1 -1 0 intensity 0.8 ambientIntensity 0.5 shadows TRUE shadowIntensity 0.5 }"));
  EXPECT_THAT(floor.shadowed, IsColor(grey(kGlobalAmbient + 0.5 * (kSunDiffuse + kSunAmbient))));  // 0.23142
  EXPECT_THAT(floor.lit, IsColor(grey(kGlobalAmbient + kSunDiffuse + kSunAmbient)));
}

// Without `shadows`, the Appearance names one light; a second one along the same direction keeps shining into its shadow.
TEST(Shadows, AreReceivedFromTheNamedLightOnly) {
  const Floor floor =
      draw_floor(scene_text("DEF Sun DirectionalLight { direction -1 -1 0 intensity 0.8 }"
                            "DirectionalLight { direction -1 -1 0 intensity 0.4 color 0 1 0 }",
                            "receiveShadows USE Sun"));
  const double green = kDiffuse * 0.4 / std::sqrt(2.0);  // 0.14142
  EXPECT_THAT(floor.shadowed, IsColor(from_factors(kGlobalAmbient, kGlobalAmbient + green, kGlobalAmbient)));
  const double lit = kGlobalAmbient + kSunDiffuse;
  EXPECT_THAT(floor.lit, IsColor(from_factors(lit, lit + green, lit)));
}

TEST(Shadows, AreNotReceivedByAShapeThatNamesNoLight) {
  const Floor floor = draw_floor(scene_text("DirectionalLight { direction -1 -1 0 intensity 0.8 }"));
  EXPECT_THAT(floor.shadowed, IsColor(grey(kGlobalAmbient + kSunDiffuse)));
}

TEST(Shadows, AreNotCastByAShapeThatMustNot) {
  const double lit = kGlobalAmbient + kSunDiffuse + kSunAmbient;
  EXPECT_THAT(draw_floor(scene_text(kSun, "", "castShadow FALSE")).shadowed, IsColor(grey(lit)));
  EXPECT_THAT(draw_floor(scene_text(kSun, "", "shadowCaster FALSE")).shadowed, IsColor(grey(lit)));
}

TEST(Shadows, AreNotThereWithAMapThatIsNeverDrawn) {
  const Compiled compiled =
      compile_text(scene_text("DirectionalLight { direction -1 -1 0 intensity 0.8 shadows TRUE defaultShadowMap "
                              "GeneratedShadowMap { update \"NONE\" } }"));
  EXPECT_THAT(compiled.messages(), testing::ElementsAre(testing::HasSubstr("shadow-map-update-none")));
  EXPECT_EQ(compiled.package->scenes()->Get(0)->shadow_maps()->size(), 0U);
  EXPECT_THAT(color_at(draw_package(*compiled.package), pixel(-2), 32), IsColor(grey(kGlobalAmbient + kSunDiffuse)));
}

// The same lamp, made global and turned half around y, stands at (-2, 4, 0): its shadow lies around (2, 0, 0).
TEST(Shadows, TurnWithTheTransformOfTheirLight) {
  const std::string lamp = fmt::format("Transform {{ rotation 0 1 0 3.14159265 children {} }}", kLamp);
  const Floor floor = draw_floor(scene_text(std::string(lamp).replace(lamp.find("shadows TRUE"), 0, "global TRUE ")));
  EXPECT_THAT(floor.lit, IsColor(grey(kGlobalAmbient)));
  EXPECT_THAT(floor.shadowed, IsColor(grey(kGlobalAmbient + kLampBelow)));
}

// A square of 1 unit in parallel light: 8 pixels of shadow along x, from -2.5 to -1.5.
TEST(Shadows, AreAsLargeAsTheirCaster) {
  const Compiled compiled = compile_text(scene_text(kSun));
  const Picture picture = draw_package(*compiled.package);
  int dark = 0;
  for (std::uint32_t x = 0; x < pixel(-1); ++x) dark += is_near(color_at(picture, x, 32), grey(kGlobalAmbient), 8) ? 1 : 0;
  EXPECT_NEAR(dark, 8, 1);
}

}  // namespace
}  // namespace plugc
