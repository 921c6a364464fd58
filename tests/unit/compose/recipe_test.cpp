#include "compose_fixture.h"

namespace plugc {
namespace {

class RecipeTest : public ComposeTest {
 protected:
  RecipeTest() {
    SceneMaterial material;
    material.lighting = Lighting::phong;
    material.diffuse = material.ambient_color = slot({0.8, 0.8, 0.8});
    material.ambient = slot({0.2});
    material.specular = slot({0, 0, 0});
    material.emissive = slot({0, 0, 0});
    material.shininess = slot({0.2});
    material.transparency = slot({0});
    scene_.materials.push_back(material);
    shape_.material = 0;
  }
  std::uint32_t slot(std::vector<double> values, bool routed = false) {
    Slot made;
    made.values = std::move(values);
    made.routed = routed;
    scene_.slots.push_back(made);
    return static_cast<std::uint32_t>(scene_.slots.size() - 1);
  }
  SceneLight& light(LightKind kind) {
    SceneLight made;
    made.kind = kind;
    made.ambient_intensity = slot({0});
    if (kind != LightKind::directional) {
      made.attenuation = slot({1, 0, 0});
      made.radius = slot({-1});
    }
    if (kind == LightKind::spot) {
      made.cut_off_angle = slot({0.7});
      made.beam_width = slot({0.7});
    }
    shape_.lights.push_back(static_cast<int>(scene_.lights.size()));
    return scene_.lights.emplace_back(made);
  }
  Recipe make() { return make_recipe(scene_, shape_, facts_, effects_); }
  std::string text() { return to_text(make(), scene_); }

  SceneShape shape_;
  ShapeFacts facts_;
};

TEST_F(RecipeTest, LeavesOutTermsThatVanish) {
  light(LightKind::directional);
  EXPECT_EQ(text(), "phong lit; light directional");
  EXPECT_FALSE(make().vertex_eye);
  scene_.slots[scene_.materials[0].specular].values = {0, 0.5, 0};
  scene_.slots[scene_.materials[0].emissive].values = {0.1, 0, 0};
  EXPECT_EQ(text(), "phong lit specular emissive; light directional");
  EXPECT_TRUE(make().vertex_eye);
}

TEST_F(RecipeTest, KeepsTermsThatARouteMayChange) {
  scene_.slots[scene_.materials[0].specular].routed = true;
  light(LightKind::point).attenuation = slot({1, 0, 0}, true);
  EXPECT_EQ(text(), "phong lit specular; light point attenuation");
}

TEST_F(RecipeTest, KnowsWhichFormOfALightIsNeeded) {
  SceneLight& spot = light(LightKind::spot);
  EXPECT_EQ(text(), "phong lit; light spot");
  scene_.slots[spot.attenuation].values = {0, 1, 0};
  scene_.slots[spot.radius].values = {10};
  scene_.slots[spot.beam_width].values = {0.3};
  scene_.slots[spot.ambient_intensity].values = {1};
  EXPECT_EQ(text(), "phong lit; light spot ambient attenuation radius beam_width");
}

TEST_F(RecipeTest, KeepsATermWhosePlugIsFilled) {
  shape_.effects = {fragment("void PLUG_material_emissive(inout vec3 e) {}\nvoid PLUG_material_specular(inout vec3 s) {}")};
  EXPECT_EQ(text(), "phong lit specular emissive; effects `e0`");
}

TEST_F(RecipeTest, AsksForNoNormalsWhenNothingReadsThem) {
  shape_.material = -1;
  EXPECT_FALSE(make().normals);
  shape_.effects = {fragment("void PLUG_fragment_modify(inout vec4 c) {}")};
  EXPECT_TRUE(make().normals);
  facts_.has_normals = false;
  EXPECT_FALSE(make().normals);
}

TEST_F(RecipeTest, NeedsNoLightsWhenUnlit) {
  light(LightKind::point);
  shape_.material = -1;
  EXPECT_EQ(text(), "phong unlit");
}

TEST_F(RecipeTest, ReadsThePositionOnlyForWhatNeedsIt) {
  light(LightKind::directional);
  shape_.effects = {fragment("void PLUG_fragment_modify(inout vec4 c) {}")};
  EXPECT_FALSE(make().vertex_eye);
  shape_.effects = {fragment("void PLUG_fragment_eye_space(const in vec4 v, inout vec3 n) {}")};
  EXPECT_TRUE(make().vertex_eye);
  shape_.effects = {fragment("void PLUG_fragment_modify(inout vec4 c) { c.r = castle_vertex_eye.x; }")};
  EXPECT_TRUE(make().vertex_eye);
}

TEST_F(RecipeTest, LightsPerFragmentWhereAShadowFalls) {
  shape_.shading = Shading::gouraud;
  light(LightKind::spot);
  EXPECT_TRUE(make().gouraud);
  shape_.receives = {{0, 0}};
  scene_.lights[0].shadow_intensity = slot({1});
  scene_.lights[0].shadow_map = 0;
  scene_.shadow_maps.resize(1);
  EXPECT_FALSE(make().gouraud);
  EXPECT_EQ(text(), "phong lit; light spot shadow bilinear");
}

TEST_F(RecipeTest, MovesCastersAsTheirVertexEffectsDo) {
  const int colours = fragment("void PLUG_fragment_modify(inout vec4 c) {}");
  const int moves = vertex("void PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) {}");
  shape_.effects = {colours};
  EXPECT_EQ(to_text(make_depth_recipe(make(), effects_), scene_), "depth");
  const int library = vertex("float wave(float x) { return x; }");
  shape_.effects = {colours, library};
  EXPECT_EQ(to_text(make_depth_recipe(make(), effects_), scene_), "depth");
  shape_.effects = {colours, library, moves};
  EXPECT_EQ(make_depth_recipe(make(), effects_).effects, (std::vector<int>{library, moves}));
}

TEST_F(RecipeTest, KnowsThePrimitiveWhereAGeometryShaderTakesIt) {
  facts_.primitive = Primitive::lines;
  const int optional = effect({{PartStage::geometry, "void PLUG_geometry_vertex_set(const in int index) {}"}});
  shape_.effects = {optional};
  EXPECT_EQ(make().primitive, Primitive::none);
  const int takes = effect({{PartStage::geometry, "layout(lines) in;\nvoid main() {}"}});
  shape_.effects = {optional, takes};
  EXPECT_EQ(make().primitive, Primitive::lines);
}

TEST_F(RecipeTest, GivesTheDepthPassTheGeometryShader) {
  const int colours = fragment("void PLUG_fragment_modify(inout vec4 c) {}");
  const int optional = effect({{PartStage::geometry, "float height() { return 1.0; }"}});
  const int takes = effect({{PartStage::geometry, "layout(triangles) in;\nvoid main() {}"}});
  shape_.effects = {colours, optional};
  EXPECT_EQ(to_text(make_depth_recipe(make(), effects_), scene_), "depth");
  shape_.effects = {colours, optional, takes};
  const Recipe depth = make_depth_recipe(make(), effects_);
  EXPECT_EQ(depth.effects, (std::vector<int>{optional, takes}));
  EXPECT_EQ(depth.primitive, Primitive::triangles);
}

TEST_F(RecipeTest, EqualShapesHaveEqualRecipes) {
  light(LightKind::point);
  const Recipe first = make();
  scene_.slots[scene_.materials[0].diffuse].values = {0.1, 0.2, 0.3};
  EXPECT_EQ(first, make());
}

}  // namespace
}  // namespace plugc
