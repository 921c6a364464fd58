// Shadows of point lights: a cube map around the light. Scenes are small enough that what is lit can be computed by hand.

#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

constexpr std::uint32_t kSide = 64;
constexpr double kHalfWidth = 2.0;  // of what the view from above shows
constexpr double kLightHeight = 0.7;

/// A white floor in the plane z = 0, seen from straight above, with a lamp 0.7 above its middle. The lamp's map is 512 texels
/// wide. The faces of the cube meet on the floor where |x| or |y| is 0.7, at its corners where both are.
std::string floor_text(std::string_view lamp, std::string_view casters) {
  return fmt::format(R"(#X3D V4.0 utf8
NavigationInfo {{ headlight FALSE }}
OrthoViewpoint {{ position 0 0 10 fieldOfView [ -2 -2 2 2 ] }}
PointLight {{ location 0 0 0.7 {} defaultShadowMap GeneratedShadowMap {{ update "ALWAYS" size 512 }} }}
Shape {{ appearance Appearance {{ material Material {{ diffuseColor 1 1 1 ambientIntensity 0 }} }} geometry Rectangle2D {{ size 4 4 }} }}
{}
)",
                     lamp, casters);
}

/// A caster that the view does not show: it is far above the picture's plane for the eye, and cut away by no light.
std::string board(double x, double y, double z, double width, double height) {
  return fmt::format(
      "Transform {{ translation {} {} {} children Shape {{ appearance Appearance {{ material UnlitMaterial {{ }} "
      "effects Effect {{ parts EffectPart {{ type \"FRAGMENT\" url \"data:text/plain,"
      "void PLUG_fragment_modify(inout vec4 c) {{ c = vec4(0.0, 0.0, 1.0, 1.0); }}\" }} }} }} "
      "geometry Rectangle2D {{ size {} {} solid FALSE }} }} }}\n",
      x, y, z, width, height);
}

double position(std::uint32_t pixel) {
  return ((pixel + 0.5) / kSide * 2 - 1) * kHalfWidth;
}

Picture draw(const std::string& text) {
  const Compiled compiled = compile_text(text);
  EXPECT_THAT(compiled.messages(), testing::IsEmpty());
  return draw_package(*compiled.package, kSide, kSide);
}

/// Calls `check` with each pixel's place on the floor and its colour.
void for_each_pixel(const Picture& picture, const std::function<void(double x, double y, const Color&)>& check) {
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column)
      check(position(column), -position(row), color_at(picture, column, row));
  }
}

Color lit_floor(double x, double y) {
  const double factor = kLightHeight / std::sqrt(x * x + y * y + kLightHeight * kLightHeight);
  return from_factors(factor, factor, factor);
}

TEST(PointLights, LeaveNoFalseShadowOnAFloorAcrossTheFacesOfTheirCube) {
  for_each_pixel(draw(floor_text("shadows TRUE", "")), [](double x, double y, const Color& color) {
    EXPECT_THAT(color, IsColor(lit_floor(x, y))) << "at " << x << ", " << y;
  });
}

TEST(PointLights, LeaveNoFalseShadowWhereTheyStandStraightInFrontOfAFloor) {
  // a small map, whose texels are wide: around (0, 0) distances have no slope, yet grow to all sides
  std::string text = floor_text("shadows TRUE", "");
  text.replace(text.find("size 512"), 8, "size 64 method \"PCF3\"");
  for_each_pixel(draw(text), [](double x, double y, const Color& color) {
    if (std::max(std::abs(x), std::abs(y)) > 0.4) return;
    EXPECT_THAT(color, IsColor(lit_floor(x, y))) << "at " << x << ", " << y;
  });
}

TEST(PointLights, LetNothingThroughAtTheEdgesAndCornersOfTheirCube) {
  // a closed box around the lamp, below it cut off by nothing: the floor stands outside
  const std::string closed =
      "Transform { translation 0 0 0.7 children Shape { appearance Appearance { material UnlitMaterial { } } "
      "geometry Box { size 0.6 0.6 0.6 } } }\n";
  for_each_pixel(draw(floor_text("shadows TRUE", closed)), [](double x, double y, const Color& color) {
    if (std::max(std::abs(x), std::abs(y)) < 0.35) return;  // the box itself
    EXPECT_THAT(color, IsColor(Color{0, 0, 0})) << "at " << x << ", " << y;
  });
}

TEST(PointLights, CastStraightEdgesAcrossTheFacesOfTheirCube) {
  // the board at half the height is thrown to twice its size: from 0.4 to 1.6 along x and y, over an edge and a corner
  const Picture picture = draw(floor_text("shadows TRUE", board(0.5, 0.5, 0.35, 0.6, 0.6)));
  for_each_pixel(picture, [](double x, double y, const Color& color) {
    const double inside = std::min(std::min(x, y) - 0.4, 1.6 - std::max(x, y));  // distance to the shadow's edge
    const bool is_board = x > 0.19 && x < 0.81 && y > 0.19 && y < 0.81;
    if (is_board || std::abs(inside) < 0.05) return;
    EXPECT_THAT(color, IsColor(inside > 0 ? Color{0, 0, 0} : lit_floor(x, y))) << "at " << x << ", " << y;
  });
}

/// A room around the lamp with a board in front of the middle of each wall; the view looks at one wall past its board.
std::string room_text(const std::array<double, 3>& direction, const std::array<double, 3>& aside) {
  const auto vec = [](const std::array<double, 3>& v, double factor) {
    return fmt::format("{} {} {}", v[0] * factor, v[1] * factor, v[2] * factor);
  };
  std::string boards;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      std::array<double, 3> place{}, size{0.4, 0.4, 0.4};
      place[static_cast<std::size_t>(axis)] = sign;
      size[static_cast<std::size_t>(axis)] = 0.02;
      boards += fmt::format(
          "Transform {{ translation {} children Shape {{ appearance Appearance {{ material UnlitMaterial {{ emissiveColor 0 0 "
          "1 }} }} "
          "geometry Box {{ size {} }} }} }}\n",
          vec(place, 1), vec(size, 1));
    }
  }
  // turns -z onto the direction, about the axis at right angles to both
  const std::array<double, 3> axis = {direction[1], -direction[0], 0};
  const bool parallel = axis[0] == 0 && axis[1] == 0;
  const std::string turn = parallel ? fmt::format("0 1 0 {}", direction[2] < 0 ? 0.0 : 3.14159265358979)
                                    : fmt::format("{} 1.5707963267949", vec(axis, 1));
  return fmt::format(R"(#X3D V4.0 utf8
NavigationInfo {{ headlight FALSE }}
Viewpoint {{ position {} orientation {} fieldOfView 0.9 }}
PointLight {{ shadows TRUE }}
Shape {{ appearance Appearance {{ material Material {{ diffuseColor 1 1 1 ambientIntensity 0 }} }} geometry Box {{ size 4 4 4 solid FALSE }} }}
{})",
                     vec(aside, 0.7), turn, boards);
}

TEST(PointLights, CastOnAllSixSidesOfARoom) {
  struct Side {
    std::array<double, 3> direction, aside;
  };
  const Side sides[] = {{{1, 0, 0}, {0, 1, 0}},  {{-1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}},
                        {{0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}},  {{0, 0, -1}, {0, 1, 0}}};
  for (const Side& side : sides) {
    const Picture picture = draw(room_text(side.direction, side.aside));
    std::size_t black = 0, white = 0;
    for_each_pixel(picture, [&](double, double, const Color& color) {
      black += is_near(color, {0, 0, 0}, 2) ? 1 : 0;
      white += color[0] > 160 && color[1] == color[0] ? 1 : 0;
    });
    // the shadow is 0.8 wide on a wall at distance 2, of which the view shows 1.93 both ways: 17 % of the picture, if in view
    SCOPED_TRACE(fmt::format("{} {} {}", side.direction[0], side.direction[1], side.direction[2]));
    EXPECT_GT(black, kSide * kSide / 20);
    EXPECT_LT(black, kSide * kSide / 4);
    EXPECT_GT(white, kSide * kSide / 2);
  }
}

TEST(PointLights, CastOnWhatComesToStandInAnotherFaceOfTheirCube) {
  // First the floor is above the lamp, then below it: nothing else changes, neither what casts nor how far the map reaches.
  // A board half-way to each floor throws a shadow of twice its size.
  const std::string floor =
      "Shape { appearance Appearance { material Material { diffuseColor 1 1 1 ambientIntensity 0 } receiveShadows USE Lamp } "
      "castShadow FALSE geometry Rectangle2D { size 1.6 1.6 solid FALSE } }";
  CompileOptions options;
  options.dynamic = {"Place.whichChoice"};
  const Compiled compiled = compile_text(
      "#X3D V4.0 utf8\nNavigationInfo { headlight FALSE }\n"
      "OrthoViewpoint { position 0 0 10 fieldOfView [ -2 -2 2 2 ] }\n"
      "DEF Lamp PointLight { radius 1.5 defaultShadowMap GeneratedShadowMap { update \"ALWAYS\" } }\n" +
          board(0, 0, 0.5, 0.6, 0.6) + board(0, 0, -0.5, 0.6, 0.6) +
          "DEF Place Switch { whichChoice 0 children [\n Transform { translation 0 0 1 children " + floor +
          " }\n Transform { translation 0 0 -1 children " + floor + " } ] }\n",
      options);
  EXPECT_THAT(compiled.messages(), testing::IsEmpty());
  const Picture picture = redraw_package(*compiled.package, kSide, kSide, {{"Place.whichChoice", 1}});
  const auto pixel = [](double x) { return static_cast<std::uint32_t>((x / kHalfWidth + 1) / 2 * kSide); };
  EXPECT_THAT(color_at(picture, pixel(0.45), pixel(0)), IsColor(Color{0, 0, 0}));
  EXPECT_GT(color_at(picture, pixel(0.7), pixel(0))[0], 100);
}

}  // namespace
}  // namespace plugc
