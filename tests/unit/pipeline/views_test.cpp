// A frame of several views: rendered textures, screen effects, and the shadows of each view.

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "scene/shadow_defaults.h"
#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

/// A scene on the renderer of this process, drawn frame by frame.
class DrawnScene {
 public:
  explicit DrawnScene(const std::string& text, const CompileOptions& options = {}) : compiled_(compile_text(text, options)) {
    EXPECT_THAT(compiled_.messages(), testing::IsEmpty());
    std::string error;
    EXPECT_TRUE(process_renderer()->load(*compiled_.package, 0, error)) << error;
  }

  const Picture& draw(std::uint32_t samples = 1) {
    FrameOptions frame;
    frame.width = frame.height = 64;
    frame.samples = samples;
    picture_ = process_renderer()->draw(frame);
    EXPECT_THAT(process_renderer()->messages(), testing::IsEmpty());
    return picture_;
  }
  const FrameStatistics& statistics() const { return process_renderer()->statistics(); }
  void set(std::string_view field, double value) {
    std::string error;
    EXPECT_TRUE(process_renderer()->set_field(field, {value}, error)) << error;
  }

 private:
  Compiled compiled_;
  Picture picture_;
};

std::string mirror_ball(const std::string& update, const std::string& more = "") {
  return "#X3D V4.0 utf8\nPROFILE Full\n"
         "Background { skyColor 0 0 1 }\n"
         "Shape { appearance Appearance { material UnlitMaterial { emissiveColor 1 1 1 }\n"
         "  texture GeneratedCubeMapTexture { size 32 update \"" +
         update +
         "\" } }\n"
         "  geometry Sphere { texCoord TextureCoordinateGenerator { mode \"WORLDSPACEREFLECTIONVECTOR\" } } }\n" +
         more;
}

TEST(Views, ACubeIsSix) {
  DrawnScene scene(mirror_ball("ALWAYS"));
  scene.draw();
  EXPECT_EQ(scene.statistics().rendered_views, 6U);
  scene.draw();
  EXPECT_EQ(scene.statistics().rendered_views, 6U);
}

TEST(Views, OfNextFrameOnlyAreDrawnOnce) {
  DrawnScene scene(mirror_ball("NEXT_FRAME_ONLY"));
  EXPECT_THAT(color_at(scene.draw(), 32, 32), IsColor(Color{0, 0, 255}));
  EXPECT_EQ(scene.statistics().rendered_views, 6U);
  EXPECT_THAT(color_at(scene.draw(), 32, 32), IsColor(Color{0, 0, 255}));
  EXPECT_EQ(scene.statistics().rendered_views, 0U);
}

TEST(Views, ThatNobodyReadsAreNotDrawn) {
  CompileOptions options;
  options.dynamic = {"Choice.whichChoice"};
  std::string text = mirror_ball("ALWAYS");
  text.insert(text.find("Shape"), "DEF Choice Switch { whichChoice 1 children [ ");
  DrawnScene scene(text + "] }\n", options);
  scene.draw();
  EXPECT_EQ(scene.statistics().rendered_views, 0U);
  scene.set("Choice.whichChoice", 0);
  scene.draw();
  EXPECT_EQ(scene.statistics().rendered_views, 6U);
}

/// A picture that shows nothing but a texture, which shows a floor elsewhere: its right half lies in the shadow of what neither
/// eye sees.
std::string two_eyes() {
  return "#X3D V4.0 utf8\nPROFILE Full\n"
         "NavigationInfo { headlight FALSE }\n"
         "DirectionalLight { direction 1 -1 0 shadows TRUE }\n"
         "OrthoViewpoint { position 0 50 0 orientation 1 0 0 -1.5707963 fieldOfView [ -4 -4 4 4 ] }\n"
         "Transform { translation 20 0 0 rotation 1 0 0 -1.5707963 children Shape {\n"
         "  appearance Appearance { material Material { diffuseColor 1 1 1 ambientIntensity 0 } }\n"
         "  geometry Rectangle2D { size 8 8 } } }\n"
         "Transform { translation 14 8 0 children Shape { geometry Box { size 4 0.1 9 } } }\n"
         "Transform { rotation 1 0 0 -1.5707963 children Shape {\n"
         "  appearance Appearance { material UnlitMaterial { emissiveColor 1 1 1 }\n"
         "    texture RenderedTexture { update \"ALWAYS\" dimensions [ 64 64 ]\n"
         "      viewpoint OrthoViewpoint { position 20 1 0 orientation 1 0 0 -1.5707963 fieldOfView [ -4 -4 4 4 ] } } }\n"
         "  geometry Rectangle2D { size 8 8 } } }\n";
}

const Color kSlanting = from_factors(std::sqrt(0.5), std::sqrt(0.5), std::sqrt(0.5));

/// The maps of the renderer's own are fitted to what an eye sees; here no eye sees what the other does.
TEST(Views, HaveTheirOwnShadows) {
  DrawnScene scene(two_eyes());
  for (int frame = 0; frame < 2; ++frame) {
    const Picture& picture = scene.draw();
    EXPECT_THAT(color_at(picture, 16, 32), IsColor(kSlanting)) << "lit";
    EXPECT_THAT(color_at(picture, 48, 32), IsColor(Color{0, 0, 0})) << "in shadow";
  }
}

TEST(Views, HaveTheirOwnTracedShadows) {
  CompileOptions options;
  options.shadows = read_shadow_defaults("traced").shadows;
  DrawnScene scene(two_eyes(), options);
  const Picture& picture = scene.draw();
  EXPECT_THAT(color_at(picture, 16, 32), IsColor(kSlanting));
  EXPECT_THAT(color_at(picture, 48, 32), IsColor(Color{0, 0, 0}));
}

/// A leaf all of whose texels have an alpha of 0.4, and its shadow beside it.
TEST(Views, TracedShadowsFollowTheAlphaCutoff) {
  CompileOptions options;
  options.shadows = read_shadow_defaults("traced").shadows;
  options.dynamic = {"Leaf.alphaCutoff"};
  DrawnScene scene(
      "#X3D V4.0 utf8\nPROFILE Full\n"
      "NavigationInfo { headlight FALSE }\n"
      "OrthoViewpoint { position 0 0 20 fieldOfView [ -4 -4 4 4 ] }\n"
      "DirectionalLight { direction 1 0 -1 shadows TRUE }\n"
      "Shape { appearance Appearance { material Material { diffuseColor 1 1 1 ambientIntensity 0 } }\n"
      "  geometry Rectangle2D { size 8 8 } }\n"
      "Transform { translation -2 0 2 children Shape {\n"
      "  appearance DEF Leaf Appearance { alphaMode \"MASK\" alphaCutoff 0.5 material UnlitMaterial { }\n"
      "    texture PixelTexture { image 1 1 4 0xffffff66 } }\n"
      "  geometry Rectangle2D { size 2 2 } } }\n",
      options);
  EXPECT_THAT(color_at(scene.draw(), 32, 32), IsColor(kSlanting)) << "all hole";
  scene.set("Leaf.alphaCutoff", 0.2);
  EXPECT_THAT(color_at(scene.draw(), 32, 32), IsColor(Color{0, 0, 0})) << "no hole";
}

/// One fit for six faces: a second frame that changes nothing draws no map again but for the picture's own camera.
TEST(Views, OfACubeShareTheirShadowMaps) {
  DrawnScene scene(
      mirror_ball("ALWAYS",
                  "DirectionalLight { direction 0 -1 0 shadows TRUE global TRUE }\n"
                  "Transform { translation 0 -3 0 children Shape { appearance Appearance { material Material { } } "
                  "geometry Box { size 9 1 9 } } }\n"));
  scene.draw();
  EXPECT_LE(scene.statistics().shadow_passes, 2U) << "one for the cube, one for the picture";
}

/// A wall before the viewer or behind him that mirrors.
std::string mirror_at(double z, bool turned) {
  return "Transform { translation 0 0 " + std::to_string(z) + (turned ? " rotation 0 1 0 3.1415927" : "") +
         " children Shape {\n"
         "  appearance Appearance { material UnlitMaterial { emissiveColor 1 1 1 }\n"
         "    texture RenderedTexture { update \"ALWAYS\" dimensions [ 32 32 ] viewpoint ViewpointMirror { } } }\n"
         "  geometry IndexedFaceSet { coord Coordinate { point [ -2 -2 0, 2 -2 0, 2 2 0, -2 2 0 ] } coordIndex [ 0 1 2 3 -1 ]\n"
         "    texCoord TextureCoordinateGenerator { mode \"MIRROR-PLANE\" } } } }\n";
}

/// The first picture of two mirrors shows what is in the one in the other in the one; from then on a frame goes a step deeper.
TEST(Views, OfMirrorsThatShowEachOtherBeginThreeDeep) {
  const std::string head = "#X3D V4.0 utf8\nPROFILE Full\n";
  DrawnScene one(head + mirror_at(0, false));
  one.draw();
  EXPECT_EQ(one.statistics().rendered_views, 1U) << "nothing in it mirrors";
  DrawnScene two(head + mirror_at(0, false) + mirror_at(20, true));
  two.draw();
  EXPECT_EQ(two.statistics().rendered_views, 6U);
  two.draw();
  EXPECT_EQ(two.statistics().rendered_views, 2U);
}

constexpr std::string_view kWhatIsBetween =
    "#X3D V4.0 utf8\nPROFILE Full\n"
    "OrthoViewpoint { }\n"
    "Background { skyColor 0 0 0 }\n"
    "Shape { appearance Appearance { material UnlitMaterial { emissiveColor 1 1 1 } }\n"
    "  geometry TriangleSet { coord Coordinate { point [ -0.9 -0.9 0, 0.9 -0.7 0, 0 0.9 0 ] } } }\n"
    "ScreenEffect { shaders ComposedShader { parts ShaderPart { type \"FRAGMENT\" url \"data:text/plain,\n"
    "  void main() { float grey = screenf_get_original_color().r;\n"
    "    gl_FragColor = vec4(grey > 0.1 && grey < 0.9 ? 1.0 : 0.0, 0.0, 0.0, 1.0); }\" } } }\n";

int red_pixels(const Picture& picture) {
  int count = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) count += picture.pixels[i] > 128 ? 1 : 0;
  return count;
}

TEST(ScreenEffects, SeeTheAverageOfSamples) {
  DrawnScene scene{std::string(kWhatIsBetween)};
  EXPECT_EQ(red_pixels(scene.draw(1)), 0);
  EXPECT_EQ(scene.statistics().screen_passes, 1U);
  EXPECT_GT(red_pixels(scene.draw(4)), 50) << "along three edges";
  EXPECT_EQ(red_pixels(scene.draw(1)), 0);
}

}  // namespace
}  // namespace plugc
