// What viewpoints project onto shapes, where it depends on the shape of the picture.

#include <fmt/format.h>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

constexpr std::uint32_t kWidth = 96, kHeight = 32;

/// A wall that fills the picture, coloured by the coordinates (s / q, t / q) that `projector` gives it.
Picture draw_wall(std::string_view projector) {
  const Compiled compiled = compile_text(fmt::format(R"(#X3D V4.0 utf8
NavigationInfo {{ headlight FALSE }}
DEF Bound Viewpoint {{ position 1 2 10 fieldOfView 0.8 }}
Shape {{
  appearance Appearance {{
    material UnlitMaterial {{ emissiveColor 1 1 1 }}
    texture ShaderTexture {{ effects Effect {{ parts EffectPart {{ type "FRAGMENT" url "data:text/plain,
      void PLUG_texture_color(inout vec4 color, const in vec4 tex_coord) {{ color = vec4(tex_coord.st / tex_coord.q, 0.0, 1.0); }}" }} }} }}
  }}
  geometry IndexedFaceSet {{ coordIndex [ 0 1 2 3 ] coord Coordinate {{ point [ -40 -40 0, 40 -40 0, 40 40 0, -40 40 0 ] }}
    texCoord ProjectedTextureCoordinate {{ projector {} }} }}
}}
)",
                                                     projector));
  EXPECT_THAT(compiled.messages(), testing::IsEmpty());
  return draw_package(*compiled.package, kWidth, kHeight);
}

double across(std::uint32_t pixel, std::uint32_t size) {
  return (pixel + 0.5) / size;
}

TEST(Projectors, ThatAreTheBoundViewpointShowThePictureItself) {
  const Picture picture = draw_wall("USE Bound");
  for (const std::uint32_t x : {3U, 40U, 90U}) {
    for (const std::uint32_t y : {2U, 20U})
      EXPECT_THAT(color_at(picture, x, y), IsColor(from_factors(across(x, kWidth), 1 - across(y, kHeight), 0)));
  }
}

TEST(Projectors, ThatAreNotBoundHaveTheirFieldOfViewBothWays) {
  const Picture picture = draw_wall("Viewpoint { position 1 2 10 fieldOfView 0.8 }");
  const double shape = static_cast<double>(kWidth) / kHeight;  // the height is what fieldOfView says
  for (const std::uint32_t x : {34U, 48U, 62U}) {
    const double s = 0.5 + (across(x, kWidth) - 0.5) * shape;
    EXPECT_THAT(color_at(picture, x, 20), IsColor(from_factors(s, 1 - across(20, kHeight), 0)));
  }
}

}  // namespace
}  // namespace plugc
