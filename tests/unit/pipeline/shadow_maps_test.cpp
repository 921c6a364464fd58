// What the compiler says of a shadow map to the renderer.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "support/compile_text.h"

namespace plugc {
namespace {

/// A lit box under a sun with shadows; `appearance` goes into its Appearance, `more` to the end of the scene.
std::string sunny_scene(const std::string& appearance, const std::string& more = "") {
  return "#X3D V4.0 utf8\nPROFILE Full\n"
         "DEF Sun DirectionalLight { direction 0 -1 -1 shadows TRUE }\n"
         "Shape { appearance Appearance { material Material {} " +
         appearance + " } geometry Box {} }\n" + more;
}

bool author_visible(const std::string& scene) {
  const Compiled compiled = compile_text(scene);
  EXPECT_TRUE(compiled.messages().empty());
  const auto& maps = *compiled.package->scenes()->Get(0)->shadow_maps();
  EXPECT_GE(maps.size(), 1U);
  return std::any_of(maps.begin(), maps.end(), [](const PackedShadowMap* map) { return map->author_visible(); });
}

std::string fragment_effect(const std::string& code) {
  return "effects Effect { language \"GLSL\" parts EffectPart { type \"FRAGMENT\" url \"data:text/plain,\n" + code + "\" } }";
}

TEST(ShadowMaps, AreTheRenderersOwnWhereNoAuthorLooks) {
  EXPECT_FALSE(author_visible(sunny_scene("")));
  EXPECT_FALSE(author_visible(
      sunny_scene(fragment_effect("void PLUG_fragment_modify(inout vec4 fragment_color) { fragment_color.r = 1.0; }"))));
}

TEST(ShadowMaps, AreSeenByAnEffectThatNamesThem) {
  EXPECT_TRUE(author_visible(sunny_scene(
      fragment_effect("uniform mat4 castle_projector_matrix_0; void PLUG_fragment_modify(inout vec4 fragment_color) "
                      "{ fragment_color.r = castle_projector_matrix_0[3][2]; }"))));
}

TEST(ShadowMaps, OfALightStayTheRenderersOwnWhereItProjectsSomethingElse) {
  const Compiled compiled = compile_text(
      sunny_scene("",
                  "Shape { appearance Appearance { texture PixelTexture { image 1 1 3 0xffffff } } "
                  "geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 0 1 0] } coordIndex [0 1 2 -1] "
                  "texCoord ProjectedTextureCoordinate { projector USE Sun } } }\n"));
  const auto& maps = *compiled.package->scenes()->Get(0)->shadow_maps();
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_FALSE(maps.Get(0)->author_visible());
  EXPECT_EQ(maps.Get(1)->update(), PackedShadowUpdate::none) << "what only projects has no texels";
}

TEST(ShadowMaps, AreSeenAsTexturesAndThroughProjectedCoordinates) {
  EXPECT_TRUE(author_visible(
      sunny_scene("",
                  "Shape { appearance Appearance { texture GeneratedShadowMap { update \"ALWAYS\" light USE Sun } } "
                  "geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 0 1 0] } coordIndex [0 1 2 -1] "
                  "texCoord ProjectedTextureCoordinate { projector USE Sun } } }\n")));
}

}  // namespace
}  // namespace plugc
