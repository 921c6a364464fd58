#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/scene/graph_fixture.h"

namespace plugc {
namespace {

TEST(Prototypes, EachInstanceIsAFreshCopyWithItsValues) {
  const auto built = build_classic(
      "PROTO Ball [ initializeOnly SFFloat r 2 ] { Shape { geometry DEF S Sphere { radius IS r } } }\n"
      "Ball { } Ball { r 3 }");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump(),
            "roots #0 #2\n"
            "#0 Shape (scene.x3dv:2:45) geometry #1\n"
            "#1 Sphere DEF S (scene.x3dv:2:68) radius 2\n"
            "#2 Shape (scene.x3dv:2:45) geometry #3\n"
            "#3 Sphere DEF S (scene.x3dv:2:68) radius 3\n");
}

TEST(Prototypes, NodesGivenToAnInstanceAreSharedByEveryIs) {
  const auto built = build_classic(
      "PROTO Twice [ initializeOnly MFNode what [ ] initializeOnly SFNode look NULL ] {\n"
      "  Group { children [ Group { children IS what } Group { children IS what } Shape { appearance IS look } ] } }\n"
      "Twice { what [ DEF A Shape { } Shape { } ] look Appearance { } }\nUSE A");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump(),
            "roots #3 #0\n"
            "#0 Shape DEF A (scene.x3dv:4:22)\n"
            "#1 Shape (scene.x3dv:4:32)\n"
            "#2 Appearance (scene.x3dv:4:49)\n"
            "#3 Group (scene.x3dv:3:3) children #4 #5 #6\n"
            "#4 Group (scene.x3dv:3:22) children #0 #1\n"
            "#5 Group (scene.x3dv:3:49) children #0 #1\n"
            "#6 Shape (scene.x3dv:3:76) appearance #2\n");
}

TEST(Prototypes, ValuesPassThroughNestedPrototypes) {
  const auto built = build_classic(
      "PROTO Inner [ inputOutput SFColor c 0 0 0 ] { Material { diffuseColor IS c } }\n"
      "PROTO Outer [ inputOutput SFColor paint 1 0 0 ] {\n"
      "  Shape { appearance Appearance { material Inner { c IS paint } } } }\n"
      "Outer { paint 0 1 0 } Outer { }");
  EXPECT_EQ(built->said(), "");
  const NodeGraph& graph = built->graph;
  EXPECT_EQ(graph.vec3(graph.child(graph.child(built->root(0), "appearance"), "material"), "diffuseColor"),
            glm::dvec3(0, 1, 0));
  EXPECT_EQ(graph.vec3(graph.child(graph.child(built->root(1), "appearance"), "material"), "diffuseColor"),
            glm::dvec3(1, 0, 0));
}

TEST(Prototypes, InterfaceFieldsInABodyTakeValuesToo) {
  const auto built = build_classic(
      "PROTO P [ inputOutput SFFloat a 1 initializeOnly SFNode map NULL ] {\n"
      "  Effect { inputOutput SFFloat alpha IS a initializeOnly SFNode picture IS map } }\n"
      "P { a 7 map ImageTexture { } }");
  EXPECT_EQ(built->said(), "");
  const GraphNode& effect = built->graph[built->root()];
  ASSERT_EQ(effect.interface().size(), 2U);
  EXPECT_EQ(effect.interface()[0].value.numbers[0], 7);
  ASSERT_EQ(effect.interface()[1].value.nodes.size(), 1U);
  EXPECT_TRUE(built->graph.is(effect.interface()[1].value.nodes[0], "ImageTexture"));
}

TEST(Prototypes, OnlyTheFirstNodeOfABodyTakesTheInstancesPlace) {
  const auto built = build_classic(
      "PROTO P [ ] { DEF T Transform { } DEF C TimeSensor { } DEF I PositionInterpolator { }\n"
      "  ROUTE C.fraction_changed TO I.set_fraction ROUTE I.value_changed TO T.translation }\n"
      "P { }");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump(),
            "roots #0\n"
            "#0 Transform DEF T (scene.x3dv:2:21)\n"
            "#1 TimeSensor DEF C (scene.x3dv:2:41)\n"
            "#2 PositionInterpolator DEF I (scene.x3dv:2:62)\n"
            "route #1.fraction_changed to #2.set_fraction\n"
            "route #2.value_changed to #0.translation\n");
}

TEST(Prototypes, AnInstanceIsCheckedByItsFirstNode) {
  const auto built =
      build_classic("PROTO Look [ ] { Appearance { } }\nShape { appearance Look { } }\nShape { geometry Look { } }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:4:18: warning: `Appearance` stands in `geometry` of `Shape`, which takes `X3DGeometryNode` "
            "[node-misplaced]\n");
}

TEST(Prototypes, ADefOfAnInstanceMeansItsFirstNode) {
  const auto built =
      build_classic("PROTO In [ ] { Box { } } PROTO P [ ] { In { } }\nShape { geometry DEF X P { } } Shape { geometry USE X }");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.child(built->root(0), "geometry"), built->graph.child(built->root(1), "geometry"));
}

TEST(Prototypes, NamesOutsideABodyAreNotSeenInIt) {
  const auto built = build_classic("DEF A Shape { }\nPROTO P [ ] { Group { children USE A } }\nP { }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:3:36: error: no `DEF A` stands before this `USE`; names outside a prototype's body or an inlined file "
            "cannot be seen in it [use-unknown]\n");
}

TEST(Prototypes, APrototypeInABodyIsSeenThereOnly) {
  const auto built = build_classic("PROTO P [ ] { PROTO Q [ ] { Box { } } Q { } }\nP { }\nQ { }");
  EXPECT_EQ(built->said(), "scene.x3dv:4:1: warning: unknown node `Q` [node-unknown]\n");
  EXPECT_TRUE(built->graph.is(built->root(), "Box"));
}

TEST(Prototypes, APrototypeHidesTheBuiltInNodeOfItsName) {
  const auto built = build_classic("PROTO Box [ initializeOnly SFFloat r 1 ] { Sphere { radius IS r } }\nBox { r 3 }");
  EXPECT_EQ(built->said(), "");
  EXPECT_TRUE(built->graph.is(built->root(), "Sphere"));
}

TEST(Prototypes, ABodySeesOnlyEarlierPrototypes) {
  const auto built =
      build_classic("PROTO A [ ] { Group { children Bee { } } }\nPROTO Bee [ ] { Group { children A { } } }\nBee { }");
  EXPECT_EQ(built->said(), "scene.x3dv:2:32: warning: unknown node `Bee` [node-unknown]\n");
}

TEST(Prototypes, ReportsMistakesInAnUnusedBodyOnce) {
  const auto built = build_classic("PROTO P [ ] { Group { radius 1 } }\nPROTO Q [ ] { Group { children [ P { } P { } ] } }");
  EXPECT_EQ(built->said(), "scene.x3dv:2:23: warning: `Group` has no field `radius` [field-unknown]\n");
  EXPECT_TRUE(built->graph.roots().empty());
  EXPECT_EQ(built->graph.size(), 3U);
}

TEST(Prototypes, ReportsWrongFieldsAndTypes) {
  const auto built = build_classic(
      "PROTO P [ initializeOnly SFFloat radius 1 initializeOnly SFColor c 0 0 0 ] {\n"
      "  Sphere { radius IS radios solid IS c } }\n"
      "P { radus 2 }\nP { radius \"x\" }\nSphere { radius IS r }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:4:5: warning: prototype `P` has no field `radus`; did you mean `radius`? [field-unknown]\n"
            "scene.x3dv:3:19: error: prototype `P` declares no field `radios`; did you mean `radius`? [proto-unknown-field]\n"
            "scene.x3dv:3:35: error: `solid` is of type SFBool, but the prototype's `c` is of type SFColor [field-type]\n"
            "scene.x3dv:5:12: error: `radius` of `P` takes SFFloat, but a string stands here [field-type]\n"
            "scene.x3dv:6:17: error: `IS r` stands outside a prototype's body [proto-unknown-field]\n");
}

TEST(Prototypes, ExternalOnesAreReadFromFilesInTurn) {
  const auto built = build_classic(
      "EXTERNPROTO Red [ initializeOnly SFFloat r ] [ \"http://example.org/a.wrl#Red\" \"lib/missing.x3dv\" "
      "\"lib/paint.x3dv#Ball\" ]\n"
      "Red { r 5 }",
      {{"lib/paint.x3dv",
        "#X3D V3.2 utf8\nPROTO Look [ ] { Material { } }\n"
        "PROTO Ball [ initializeOnly SFFloat r 1 ] { Group { children [ Shape { appearance Appearance { material Look { } "
        "texture ImageTexture { url \"a.png\" } } geometry Sphere { radius IS r } } ] } }\nWorldInfo { }"}});
  EXPECT_EQ(built->said(), "");
  const NodeGraph& graph = built->graph;
  const NodeId shape = graph.children(built->root(), "children")[0];
  EXPECT_EQ(graph.number(graph.child(shape, "geometry"), "radius"), 5);
  EXPECT_EQ(graph.base_path(graph.child(graph.child(shape, "appearance"), "texture")), "lib/paint.x3dv");
  EXPECT_EQ(graph.roots().size(), 1U);
}

TEST(Prototypes, AUrlGivenToAnInstanceIsRelativeToTheFileThatGivesIt) {
  const auto built = build_classic(
      "EXTERNPROTO P [ initializeOnly MFString url ] \"lib/p.x3dv#P\"\nP { url \"a.png\" }\nP { }",
      {{"lib/p.x3dv", "#X3D V3.2 utf8\nPROTO P [ initializeOnly MFString url \"b.png\" ] { ImageTexture { url IS url } }"}});
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.base_path(built->root(0)), "scene.x3dv");
  EXPECT_EQ(built->graph.base_path(built->root(1)), "lib/p.x3dv");
}

TEST(Prototypes, ExternalOnesMayNameBuiltInNodes) {
  const auto built = build_classic(
      "EXTERNPROTO KambiAppearance [ inputOutput MFNode effects ] [ \"urn:castle-engine.io:node:KambiAppearance\" ]\n"
      "Shape { appearance KambiAppearance { effects Effect { } } }");
  EXPECT_EQ(built->said(), "");
  EXPECT_TRUE(built->graph.is(built->graph.child(built->root(), "appearance"), "Appearance"));
}

TEST(Prototypes, ReportsMissingExternalOnes) {
  const auto built = build_classic("EXTERNPROTO Far [ ] [ \"far.x3dv\" \"urn:x:node:Nothing\" ]\nFar { }\nFar { }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:24: error: cannot read `far.x3dv` [file-unreadable]\n"
            "scene.x3dv:2:35: error: plugc knows no node called `urn:x:node:Nothing` [externproto-missing]\n");
}

TEST(Prototypes, ReportsExternalOnesThatContainThemselves) {
  const auto built =
      build_classic("EXTERNPROTO P [ ] \"p.x3dv#P\"\nP { }",
                    {{"p.x3dv", "#X3D V3.2 utf8\nEXTERNPROTO Q [ ] \"p.x3dv#P\"\nPROTO P [ ] { Group { children Q { } } }\n"}});
  EXPECT_EQ(built->said(), "p.x3dv:3:32: error: prototype `P` contains itself [proto-cycle]\n");
}

TEST(Prototypes, StopAtTheLimitOfPrototypesInsidePrototypes) {
  std::string text = "PROTO P0 [ ] { Group { } }\n";
  for (int i = 1; i < 80; ++i) text += fmt::format("PROTO P{} [ ] {{ Group {{ children P{} {{ }} }} }}\n", i, i - 1);
  const auto built = build_classic(text + "P79 { }");
  EXPECT_EQ(built->said(), "scene.x3dv:18:34: error: prototypes stand more than 64 deep inside one another [proto-cycle]\n");
}

TEST(Prototypes, WorkInXml) {
  const auto built = build(
      "<X3D version='3.2'><Scene>\n"
      "<ProtoDeclare name='P'><ProtoInterface><field accessType='initializeOnly' type='SFFloat' name='r' value='2'/>"
      "<field accessType='inputOutput' type='MFNode' name='kids'/></ProtoInterface>"
      "<ProtoBody><Group><IS><connect nodeField='children' protoField='kids'/></IS></Group></ProtoBody></ProtoDeclare>\n"
      "<ProtoInstance name='P'><fieldValue name='kids'><Shape/><Shape/></fieldValue></ProtoInstance>\n"
      "</Scene></X3D>",
      {}, "scene.x3d");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.children(built->root(), "children").size(), 2U);
}

TEST(ExpandPrototypes, XmlGivesNoNodeAsTheTextNull) {
  const auto built = build(
      "<X3D version='3.3'><Scene><ProtoDeclare name='P'><ProtoInterface>"
      "<field name='one' type='SFNode' accessType='initializeOnly'><Box/></field>"
      "<field name='kids' type='MFNode' accessType='initializeOnly'><Shape/></field></ProtoInterface><ProtoBody>\n"
      "<Group><Shape><IS><connect nodeField='geometry' protoField='one'/></IS></Shape>"
      "<Group><IS><connect nodeField='children' protoField='kids'/></IS></Group></Group></ProtoBody></ProtoDeclare>\n"
      "<ProtoInstance name='P'><fieldValue name='one' value='NULL'/><fieldValue name='kids' value=''/></ProtoInstance>\n"
      "<ProtoInstance name='P'><fieldValue name='one' value='none'/></ProtoInstance></Scene></X3D>",
      {}, "scene.x3d");
  EXPECT_EQ(built->said(), "scene.x3d:4:55: error: `one` of `P` takes SFNode, but text stands here [field-type]\n");
  const NodeId group = built->root();
  const auto children = built->graph.field(group, "children").nodes;
  ASSERT_EQ(children.size(), 2U);
  EXPECT_FALSE(built->graph.child(children[0], "geometry").valid());
  EXPECT_TRUE(built->graph.field(children[1], "children").nodes.empty());
}

}  // namespace
}  // namespace plugc
