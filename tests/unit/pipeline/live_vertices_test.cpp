// The law of lists that change while a scene is drawn: once a host has written other numbers into one, the picture is as if the
// scene had been written with them. So everything that the compiler makes of a list, the renderer makes anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

/// A scene in which LIST stands for the numbers of `field`: those of `before`, then those of `after`.
struct ListScene {
  std::string name;
  std::string field;
  std::vector<double> before, after;
  std::string text;
};

std::string joined(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += std::to_string(number) + " ";
  return text;
}

std::string scene_text(const ListScene& scene, const std::vector<double>& numbers) {
  std::string text = "#X3D V4.0 utf8\nViewpoint { position 0 0 6 }\nBackground { skyColor 0 0 0.3 }\n" + scene.text;
  const std::size_t at = text.find("LIST");
  return text.replace(at, 4, joined(numbers));
}

Picture draw(const Package& package) {
  FrameOptions frame;
  frame.width = frame.height = 64;
  return draw_package(package, frame);
}

/// Drawn as the scene says first, then with the other numbers.
Picture draw_changed(const Package& package, const ListScene& scene) {
  draw(package);
  std::string error;
  EXPECT_TRUE(process_renderer()->set_field(scene.field, scene.after, error)) << error;
  FrameOptions frame;
  frame.width = frame.height = 64;
  return process_renderer()->draw(frame);
}

int largest_difference(const Picture& a, const Picture& b) {
  if (a.pixels.size() != b.pixels.size() || a.pixels.empty()) return 256;
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

const std::vector<double> kFlat = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 2, -1, 0, 2, 1, 0};
const std::vector<double> kBent = {-2, -1, 0.5, 0, -2, 0, 0, 1.5, 0.4, -1, 1, -1, 2, -1, -1.5, 2, 1, -1};

/// Two faces with a ridge between them.
std::string faces(const std::string& fields) {
  return "geometry IndexedFaceSet { solid FALSE coordIndex [ 0 1 2 3 -1 1 4 5 2 -1 ] coord DEF P Coordinate { point [ LIST ] "
         "} " +
         fields + " } }";
}

const std::string kLit =
    "Shape { appearance Appearance { material Material { diffuseColor 0.9 0.8 0.7 specularColor 0.5 0.5 0.5 } } ";
const std::string kUnlit = "Shape { appearance Appearance { material UnlitMaterial { } } ";
const std::string kPicture = "texture PixelTexture { image 2 2 3 0xFF0000 0x00FF00 0x0000FF 0xFFFF00 } ";
const std::string kTextured = "Shape { appearance Appearance { material Material { } " + kPicture + "} ";
const std::string kBumpy =
    "Shape { appearance Appearance { material Material { normalTexture PixelTexture { image 2 2 3 0xC080C0 0x80C0C0 0x8080FF "
    "0x4080C0 } } } ";
const std::string kQuad = "geometry QuadSet { coord Coordinate { point [ -1 -1 0, 1 -1 0, 1 1 0, -1 1 0 ] } ";

std::vector<ListScene> list_scenes() {
  const std::vector<double> four_colors = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0},
                            other_colors = {0, 1, 1, 1, 0, 1, 0.5, 0.5, 0, 1, 1, 1};
  const std::vector<double> square = {0, 0, 1, 0, 1, 1, 0, 1}, part = {0.2, 0.1, 0.7, 0.3, 1.5, 1, 0, 2};
  return {
      {"FlatFaces", "P.point", kFlat, kBent, kLit + faces("")},
      {"Creases", "P.point", kFlat, kBent, kLit + faces("creaseAngle 0.9")},
      {"SmoothFaces", "P.point", kFlat, kBent, kLit + faces("creaseAngle 4")},
      {"ClockwiseFaces", "P.point", kFlat, kBent, kLit + faces("creaseAngle 4 ccw FALSE")},
      {"ColorsOfFaces", "P.point", kFlat, kBent, kLit + faces("colorPerVertex FALSE color Color { color [ 1 0 0, 0 1 0 ] }")},
      {"PictureOverTheBox", "P.point", kFlat, kBent, kTextured + faces("")},
      {"PictureOverAllSides", "P.point", kFlat, kBent,
       kTextured + faces("texCoord TextureCoordinateGenerator { mode \"BOUNDS3D\" }")},
      {"NormalMap", "P.point", kFlat, kBent, kBumpy + faces("creaseAngle 4")},
      {"Strips", "P.point", kFlat, kBent,
       kLit + "geometry IndexedTriangleStripSet { solid FALSE index [ 0 1 3 2 5 4 ] coord DEF P Coordinate { point [ LIST ] } "
              "} }"},
      {"WrittenNormals", "P.point", kFlat, kBent,
       kLit + faces("normal Normal { vector [ 0 0 1, 0 0 1, 0 1 1, 1 0 1, 0 0 1, 1 1 1 ] }")},
      {"Lines", "P.point", kFlat, kBent,
       kUnlit + "geometry IndexedLineSet { coordIndex [ 0 1 2 -1 3 4 5 -1 ] coord DEF P Coordinate { point [ LIST ] } } }"},
      {"Points", "P.point", kFlat, kBent, kUnlit + "geometry PointSet { coord DEF P CoordinateDouble { point [ LIST ] } } }"},
      {"Colors", "C.color", four_colors, other_colors, kUnlit + kQuad + "color DEF C Color { color [ LIST ] } } }"},
      {"ColorsWithAlpha",
       "C.color",
       {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 0, 1},
       {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 1},
       kUnlit + kQuad + "color DEF C ColorRGBA { color [ LIST ] } } }"},
      {"Normals",
       "N.vector",
       {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
       {0, 3, 1, 0, 0, 0, 1, 0, 1, 0, 0, 9},
       kLit + kQuad + "normal DEF N Normal { vector [ LIST ] } } }"},
      {"TextureCoordinates", "T.point", square, part,
       kTextured + kQuad + "texCoord DEF T TextureCoordinate { point [ LIST ] } } }"},
      {"TextureCoordinatesOfTangents", "T.point", square, part,
       kBumpy + kQuad + "texCoord DEF T TextureCoordinate { point [ LIST ] } } }"},
      {"TextureCoordinatesThatProject",
       "T.point",
       {0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1},
       {0, 0, 0, 1, 1, 0, 0, 2, 1, 1, 0, 3, 0, 1, 0, 1},
       kTextured + kQuad + "texCoord DEF T TextureCoordinate4D { point [ LIST ] } } }"},
      {"SecondTextureCoordinates", "T.point", square, part,
       "Shape { appearance Appearance { texture MultiTexture { texture [ PixelTexture { image 1 1 3 0xFFFFFF } " +
           kPicture.substr(kPicture.find("Pixel")) + "] } } " + kQuad +
           "texCoord MultiTextureCoordinate { texCoord [ TextureCoordinate { point [ 0 0, 1 0, 1 1, 0 1 ] } DEF T "
           "TextureCoordinate { "
           "point [ LIST ] } ] } } }"},
      {"FogCoordinates",
       "F.depth",
       {0, 0, 0, 0},
       {0, 5, 10, 2},
       "Fog { color 1 0 0 visibilityRange 10 }\n" + kUnlit + kQuad + "fogCoord DEF F FogCoordinate { depth [ LIST ] } } }"},
      {"Attributes",
       "A.value",
       {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0},
       {0, 0, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0},
       "Shape { appearance Appearance { material UnlitMaterial { } effects Effect { language \"GLSL\" parts [ EffectPart { "
       "type "
       "\"VERTEX\" url \"data:text/plain,\nattribute vec3 tint; varying vec3 shade; void PLUG_vertex_eye_space(const in vec4 "
       "v, const "
       "in vec3 n) { shade = tint; }\" } EffectPart { type \"FRAGMENT\" url \"data:text/plain,\nvarying vec3 shade; void "
       "PLUG_fragment_modify(inout vec4 c) { c.rgb = shade; }\" } ] } } " +
           kQuad + "attrib DEF A FloatVertexAttribute { name \"tint\" numComponents 3 value [ LIST ] } } }"},
  };
}

class LiveVertices : public testing::TestWithParam<ListScene> {};

TEST_P(LiveVertices, AreDrawnAsIfTheyHadBeenWritten) {
  const ListScene& scene = GetParam();
  CompileOptions dynamic;
  dynamic.dynamic = {scene.field};
  const Compiled changing = compile_text(scene_text(scene, scene.before), dynamic);
  const Compiled written = compile_text(scene_text(scene, scene.after));
  ASSERT_EQ(changing.messages(), std::vector<std::string>());
  ASSERT_NE(changing.package->scenes()->Get(0)->live_meshes(), nullptr);
  EXPECT_EQ(changing.package->scenes()->Get(0)->live_meshes()->size(), 1U);
  const Picture first = draw(*changing.package), last = draw_changed(*changing.package, scene);
  EXPECT_GT(largest_difference(first, last), 20) << "the change is not seen";
  EXPECT_LE(largest_difference(last, draw(*written.package)), 1);
}

INSTANTIATE_TEST_SUITE_P(Lists, LiveVertices, testing::ValuesIn(list_scenes()), [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace plugc
