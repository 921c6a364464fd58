#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/limits.h"
#include "unit/scene/graph_fixture.h"

namespace plugc {
namespace {

TEST(BuildGraph, TypesFieldsAndFallsBackOnDefaults) {
  const auto built = build_classic("Transform { translation 1 2 3 children Shape { geometry Sphere { radius 2 } } }");
  EXPECT_EQ(built->said(), "");
  const NodeGraph& graph = built->graph;
  const NodeId transform = built->root();
  ASSERT_TRUE(graph.is(transform, "Transform"));
  EXPECT_EQ(graph.vec3(transform, "translation"), glm::dvec3(1, 2, 3));
  EXPECT_EQ(graph.vec3(transform, "scale"), glm::dvec3(1, 1, 1));
  EXPECT_TRUE(graph.is_written(transform, "translation"));
  EXPECT_FALSE(graph.is_written(transform, "scale"));
  const NodeId sphere = graph.child(graph.children(transform, "children")[0], "geometry");
  EXPECT_EQ(graph.number(sphere, "radius"), 2);
  EXPECT_TRUE(graph.boolean(sphere, "solid"));
  EXPECT_EQ(built->sources.text(graph.field_span(sphere, "radius")), "2");
  EXPECT_EQ(built->sources.text(graph.field_span(sphere, "solid")), "Sphere");
  EXPECT_FALSE(graph.child(transform, "metadata").valid());
}

TEST(BuildGraph, UseIsTheSameNode) {
  const auto built = build_classic("DEF A Shape { geometry DEF B Box { } } USE A Shape { geometry USE B }");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump(),
            "roots #0 #0 #2\n"
            "#0 Shape DEF A (scene.x3dv:2:7) geometry #1\n"
            "#1 Box DEF B (scene.x3dv:2:30)\n"
            "#2 Shape (scene.x3dv:2:46) geometry #1\n");
}

TEST(BuildGraph, ALaterDefOfTheSameNameHidesTheEarlierOne) {
  const auto built = build_classic("DEF A Box { } USE A DEF A Sphere { } USE A");
  EXPECT_EQ(built->dump().substr(0, 17), "roots #0 #0 #1 #1");
}

TEST(BuildGraph, ReportsUseOfUnknownNames) {
  const auto built = build_classic("Group { children [ DEF Tower Shape { } USE Towr ] }\nUSE Later\nDEF Later Group { }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:44: error: no `DEF Towr` stands before this `USE`; did you mean `Tower`? [use-unknown]\n"
            "scene.x3dv:3:5: error: no `DEF Later` stands before this `USE`; one stands behind it [use-unknown]\n");
}

TEST(BuildGraph, ReportsANodeThatContainsItself) {
  const auto built = build_classic("DEF A Group {\n  children Group { children USE A } }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:3:33: error: this `USE` stands inside `DEF A`, so that it would contain itself [use-cycle]\n");
  EXPECT_EQ(built->graph.size(), 2U);
}

TEST(BuildGraph, AScriptMayReferToANodeAroundIt) {
  const auto built = build_classic(
      "DEF A Group { children DEF S Script { initializeOnly SFNode self USE S initializeOnly SFNode top USE A } }");
  EXPECT_EQ(built->said(), "");
}

TEST(BuildGraph, PassesOverUnknownNodesAndFields) {
  const auto built = build_classic("Shap { geometry Box { } }\nBox { sise 1 1 1\n size 4 5 6 }\nGroup { addChildren [ ] }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:1: warning: unknown node `Shap`; did you mean `Shape`? [node-unknown]\n"
            "scene.x3dv:3:7: warning: `Box` has no field `sise`; did you mean `size`? [field-unknown]\n"
            "scene.x3dv:5:9: warning: `addChildren` of `Group` is an event and takes no value [field-unknown]\n");
  EXPECT_EQ(built->graph.size(), 2U);
  EXPECT_EQ(built->graph.vec3(built->root(), "size"), glm::dvec3(4, 5, 6));
}

TEST(BuildGraph, ReportsValuesOfTheWrongType) {
  const auto built = build_classic(
      "Box { size \"big\" }\n"
      "Box { size 1 2 }\n"
      "Box { solid 1 }\n"
      "Box { size TRUE }\n"
      "Coordinate { point [ 1 2 3 4 ] }\n"
      "IndexedFaceSet { coordIndex [ 0 1.5 ] }\n"
      "Shape { appearance \"red\" }\n"
      "Shape { geometry [ Box { } Sphere { } ] }\n"
      "EffectPart { type [ \"VERTEX\" \"FRAGMENT\" ] }\n"
      "PixelTexture { image 2 2 3 0xFF }\n");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:12: error: `size` of `Box` takes SFVec3f, but a string stands here [field-type]\n"
            "scene.x3dv:3:12: error: `size` of `Box` takes SFVec3f, but 2 numbers stand here instead of 3 [field-type]\n"
            "scene.x3dv:4:13: error: `solid` of `Box` takes SFBool, but a number stands here [field-type]\n"
            "scene.x3dv:5:12: error: `size` of `Box` takes SFVec3f, but a boolean stands here [field-type]\n"
            "scene.x3dv:6:20: error: `point` of `Coordinate` takes MFVec3f, but 4 numbers are no multiple of 3 [field-type]\n"
            "scene.x3dv:7:33: error: `coordIndex` of `IndexedFaceSet` takes MFInt32, but 1.5 is no whole number [field-type]\n"
            "scene.x3dv:8:20: error: `appearance` of `Shape` takes SFNode, but a string stands here [field-type]\n"
            "scene.x3dv:9:28: error: this field takes one node; the first one counts [field-type]\n"
            "scene.x3dv:10:19: error: `type` of `EffectPart` takes SFString, but 2 strings stand here [field-type]\n"
            "scene.x3dv:11:22: error: `image` of `PixelTexture` takes SFImage, but an image of 2 x 2 needs 4 pixels, "
            "and a pixel stands here "
            "[field-type]\n");
  EXPECT_FALSE(built->graph.is_written(built->root(0), "size"));
  EXPECT_EQ(built->graph.field(built->root(4), "point").numbers.size(), 3U);
  EXPECT_TRUE(built->graph.is(built->graph.child(built->root(7), "geometry"), "Box"));
}

TEST(BuildGraph, KeepsValuesOutOfRange) {
  const auto built = build_classic("Sphere { radius -1 }\nMaterial { transparency 1.5 }\nSpotLight { beamWidth 1.5708 }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:17: warning: `radius` of `Sphere` is -1, but should be >0 [field-range]\n"
            "scene.x3dv:3:25: warning: `transparency` of `Material` is 1.5, but should be <=1 [field-range]\n");
  EXPECT_EQ(built->graph.number(built->root(), "radius"), -1);
}

TEST(BuildGraph, TheLastValueOfAFieldGivenTwiceCounts) {
  const auto built = build_classic("Shape { geometry Box { }\n geometry Sphere { } }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:3:2: warning: `geometry` of `Shape` is given twice; the last value counts [field-repeated]\n");
  EXPECT_TRUE(built->graph.is(built->graph.child(built->root(), "geometry"), "Sphere"));
}

TEST(BuildGraph, ReportsMisplacedNodesAndKeepsThem) {
  const auto built =
      build_classic("Shape { geometry Material { }\n appearance DEF B Box { } }\nIndexedFaceSet { texCoord USE B }");
  EXPECT_EQ(
      built->said(),
      "scene.x3dv:2:18: warning: `Material` stands in `geometry` of `Shape`, which takes `X3DGeometryNode` [node-misplaced]\n"
      "scene.x3dv:3:19: warning: `Box` stands in `appearance` of `Shape`, which takes `X3DAppearanceNode` [node-misplaced]\n"
      "scene.x3dv:4:31: warning: `Box` stands in `texCoord` of `IndexedFaceSet`, which takes "
      "`X3DSingleTextureCoordinateNode` or `MultiTextureCoordinate` [node-misplaced]\n");
  EXPECT_TRUE(built->graph.is(built->graph.child(built->root(), "geometry"), "Material"));
}

TEST(BuildGraph, AcceptsListsOfOneAndSingleElements) {
  const auto built = build_classic(
      "Shape { geometry [ Box { } ] }\nGroup { children Shape { } }\nCoordinate { point 1 2 3 }\nAnchor { url \"a\" }\nGroup { "
      "children [ ] metadata NULL }");
  EXPECT_EQ(built->said(), "");
  EXPECT_TRUE(built->graph.is(built->graph.child(built->root(), "geometry"), "Box"));
  EXPECT_TRUE(built->graph.is_written(built->root(4), "children"));
}

TEST(BuildGraph, ReadsInterfaceFields) {
  const auto built = build_classic(
      "Effect { inputOutput SFFloat alpha 0.5 inputOnly SFTime tick\n"
      "  initializeOnly SFNode map ImageTexture { } initializeOnly MFColor c [ 1 0 0, 0 1 0 ]\n"
      "  initializeOnly SFFlot f 1 }\n"
      "Box { inputOutput SFFloat a 1 }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:4:18: error: no field type is called `SFFlot`; did you mean `SFFloat`? [field-type]\n"
            "scene.x3dv:5:27: warning: `Box` declares no fields of its own, such as `a` [field-unknown]\n");
  EXPECT_EQ(built->dump(),
            "roots #0 #2\n"
            "#0 Effect (scene.x3dv:2:1) inputOutput SFFloat alpha 0.5; inputOnly SFTime tick; initializeOnly SFNode map #1; "
            "initializeOnly MFColor c 1 0 0 0 1 0\n"
            "#1 ImageTexture (scene.x3dv:3:29)\n"
            "#2 Box (scene.x3dv:5:1)\n");
}

TEST(BuildGraph, UnderstandsVrml2Names) {
  const auto built = build(
      "#VRML V2.0 utf8\nSwitch { whichChoice 0 choice [ Group { } ] }\nLOD { level Group { } }\nCollision { collide FALSE }",
      {}, "scene.wrl");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.children(built->root(0), "children").size(), 1U);
  EXPECT_EQ(built->graph.children(built->root(1), "children").size(), 1U);
  EXPECT_FALSE(built->graph.boolean(built->root(2), "enabled"));
}

TEST(BuildGraph, TellsX3dItsOwnNamesForThoseOfVrml2) {
  const auto built = build_classic("Switch { choice Group { } }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:10: warning: `choice` is the name of VRML 2.0; the field of `Switch` is called `children` in X3D "
            "[field-unknown]\n");
  EXPECT_EQ(built->graph.children(built->root(), "children").size(), 1U);
}

std::unique_ptr<BuiltGraph> build_xml(const std::string& scene) {
  return build("<X3D version='3.2'><Scene>\n" + scene + "\n</Scene></X3D>", {}, "scene.x3d");
}

TEST(BuildGraph, PutsXmlChildrenIntoTheirFields) {
  const auto built = build_xml(
      "<Shape><Appearance><Material diffuseColor='1 0 0'/><ImageTexture url='\"a.png\" \"b.png\"'/><Effect/>"
      "<ImageTexture containerField='normalMap'/></Appearance><Box DEF='B' size='1 2 3' solid='false'/></Shape>\n"
      "<Shape><Box USE='B'/></Shape><Group><Shape/><Shape/></Group>");
  EXPECT_EQ(built->said(), "");
  const NodeGraph& graph = built->graph;
  const NodeId appearance = graph.child(built->root(), "appearance");
  EXPECT_EQ(graph.vec3(graph.child(appearance, "material"), "diffuseColor"), glm::dvec3(1, 0, 0));
  EXPECT_EQ(graph.field(graph.child(appearance, "texture"), "url").strings.size(), 2U);
  EXPECT_EQ(graph.children(appearance, "effects").size(), 1U);
  EXPECT_TRUE(graph.child(appearance, "normalMap").valid());
  EXPECT_EQ(graph.child(built->root(1), "geometry"), graph.child(built->root(0), "geometry"));
  EXPECT_FALSE(graph.boolean(graph.child(built->root(1), "geometry"), "solid"));
  EXPECT_EQ(graph.children(built->root(2), "children").size(), 2U);
}

TEST(BuildGraph, ReportsXmlChildrenWithoutAField) {
  const auto built =
      build_xml("<Shape><Box/><Sphere/></Shape>\n<Box><Group/></Box>\n<Shape><Box containerField='geo'/></Shape>");
  EXPECT_EQ(built->said(),
            "scene.x3d:2:15: error: this field takes one node; the first one counts [field-type]\n"
            "scene.x3d:3:7: warning: `Box` has no field for a `Group`; it is left out [node-misplaced]\n"
            "scene.x3d:4:29: warning: `Shape` has no field `geo` for nodes [field-unknown]\n");
  EXPECT_TRUE(built->graph.is(built->graph.child(built->root(2), "geometry"), "Box"));
}

TEST(BuildGraph, DeepSharingStaysWithinTheDepthOfAScene) {
  std::string text;
  for (int i = 0; i < 10; ++i) {
    text += fmt::format("DEF G{} ", i);
    for (int k = 0; k < 250; ++k) text += "Group { children ";
    text += i == 0 ? "Group { }" : fmt::format("USE G{}", i - 1);
    text += std::string(250, '}') + "\n";
  }
  const auto built = build_classic(text);
  EXPECT_NE(built->said().find("error: more than 2000 nodes inside one another [nesting-limit]"), std::string::npos);
}

TEST(BuildGraph, StopsAtTheLimitOfNodes) {
  std::string many = "#X3D V3.2 utf8\n";
  for (int i = 0; i < 20000; ++i) many += "Group{}";
  std::string text;
  for (int i = 0; i < 101; ++i) text += "Inline { url \"many.x3dv\" }\n";
  const auto built = build_classic(text, {{"many.x3dv", many}});
  EXPECT_EQ(
      built->said(),
      "many.x3dv:2:139301: error: the scene expands to more than 2000000 nodes; what follows is left out [scene-limit]\n");
  EXPECT_EQ(built->graph.size(), kMaxSceneNodes);
}

TEST(BuildGraph, StopsWherePrototypesMultiplyWithoutNodes) {
  std::string text = "PROTO P0 [ ] { }\n";
  for (int i = 1; i < 60; ++i) {
    text += fmt::format("PROTO P{} [ ] {{ P{} {{ }} P{} {{ }} }}\n", i, i - 1, i - 1);
  }
  const auto built = build_classic(text + "P59 { }");
  EXPECT_NE(built->said().find("[scene-limit]"), std::string::npos);
}

}  // namespace
}  // namespace plugc
