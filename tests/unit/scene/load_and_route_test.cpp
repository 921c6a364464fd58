#include <gtest/gtest.h>

#include "unit/scene/graph_fixture.h"

namespace plugc {
namespace {

const char* const kHeader = "#X3D V3.2 utf8\n";

TEST(Inline, ItsChildrenAreTheNodesOfTheFile) {
  const auto built =
      build_classic("Inline { url [ \"missing.x3dv\" \"sub/a.x3dv\" ] }\nInline { load FALSE url \"none.x3dv\" }",
                    {{"sub/a.x3dv", std::string(kHeader) + "DEF A Shape { } Inline { url \"b.wrl\" }"},
                     {"sub/b.wrl", "#VRML V2.0 utf8\nGroup { }"}});
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump(),
            "roots #0 #4\n"
            "#0 Inline (scene.x3dv:2:1) url \"missing.x3dv\" \"sub/a.x3dv\"; children #1 #2\n"
            "#1 Shape DEF A (sub/a.x3dv:2:7)\n"
            "#2 Inline (sub/a.x3dv:2:17) url \"b.wrl\"; children #3\n"
            "#3 Group (sub/b.wrl:2:1)\n"
            "#4 Inline (scene.x3dv:3:1) load FALSE; url \"none.x3dv\"\n");
}

TEST(Inline, EachOneIsAFreshCopy) {
  const auto built =
      build_classic("Inline { url \"a.x3dv\" } Inline { url \"a.x3dv\" }", {{"a.x3dv", std::string(kHeader) + "Group { }"}});
  EXPECT_NE(built->graph.children(built->root(0), "children")[0], built->graph.children(built->root(1), "children")[0]);
}

TEST(Inline, ReportsWhatCannotBeReadAndGoesOn) {
  const auto built = build_classic(
      "Inline { url \"none.x3dv\" }\nInline { url \"none.glb\" }\nInline { url \"http://example.org/a.x3d\" }\nGroup { }");
  EXPECT_EQ(built->said(),
            "scene.x3dv:2:15: error: cannot read `none.x3dv` [file-unreadable]\n"
            "scene.x3dv:3:15: error: cannot read `none.glb` [file-unreadable]\n"
            "scene.x3dv:4:15: error: `http://example.org/a.x3d` is no local file; plugc reads no network [file-unreadable]\n");
  EXPECT_EQ(built->graph.roots().size(), 4U);
}

TEST(Inline, TakesGltf) {
  const auto built = build_classic("Inline { url \"model.gltf\" }",
                                   {{"model.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"name":"A"},{"mesh":0}]})"}});
  EXPECT_EQ(built->said(), "model.gltf:1:58: error: `nodes[1].mesh`: there is no 0; `meshes` holds 0 [gltf-invalid]\n");
  EXPECT_EQ(built->dump(),
            "roots #0\n"
            "#0 Inline (scene.x3dv:2:1) url \"model.gltf\"; children #1 #2\n"
            "#1 Transform DEF A (model.gltf:1:37)\n"
            "#2 Transform (model.gltf:1:50)\n");
}

TEST(Inline, ReportsFilesThatIncludeThemselves) {
  const auto built =
      build_classic("Inline { url \"a.x3dv\" }", {{"a.x3dv", std::string(kHeader) + "Inline { url \"scene.x3dv\" }"}});
  EXPECT_EQ(built->said(), "a.x3dv:2:14: error: `scene.x3dv` includes itself [inline-cycle]\n");
}

TEST(Inline, StopsAtTheLimitOfFilesInsideFiles) {
  std::map<std::string, std::string> files;
  for (int i = 0; i < 40; ++i) {
    files[std::to_string(i) + ".x3dv"] = std::string(kHeader) + "Inline { url \"" + std::to_string(i + 1) + ".x3dv\" }";
  }
  const auto built = build_classic("Inline { url \"0.x3dv\" }", files);
  EXPECT_EQ(built->said(), "31.x3dv:2:14: error: files are inlined more than 32 deep [inline-cycle]\n");
}

TEST(Inline, ExportedNodesCanBeImported) {
  const auto built = build_classic(
      "DEF I Inline { url \"a.x3dv\" }\nIMPORT I.Spin AS Turn\nIMPORT I.Hidden\n"
      "DEF T Transform { }\nROUTE Turn.value_changed TO T.rotation",
      {{"a.x3dv", std::string(kHeader) + "DEF O OrientationInterpolator { }\nDEF Hidden Group { }\nEXPORT O AS Spin"}});
  EXPECT_EQ(
      built->said(),
      "scene.x3dv:4:10: error: the file that `I` inlines exports no `Hidden`; it needs an `EXPORT Hidden` [import-invalid]\n");
  ASSERT_EQ(built->graph.routes().size(), 1U);
  EXPECT_TRUE(built->graph.is(built->graph.routes()[0].from, "OrientationInterpolator"));
}

TEST(Routes, ResolveNodesAndEventNames) {
  const auto built = build_classic(
      "DEF C TimeSensor { } DEF I ScalarInterpolator { } DEF M Material { } DEF E Effect { inputOutput SFFloat a 0 }\n"
      "ROUTE C.fraction_changed TO I.set_fraction\n"
      "ROUTE I.value_changed TO M.set_transparency\n"
      "ROUTE M.transparency_changed TO E.a\n");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump().substr(built->dump().find("route")),
            "route #0.fraction_changed to #1.set_fraction\n"
            "route #1.value_changed to #2.transparency\n"
            "route #2.transparency to #3.a\n");
}

TEST(Routes, FollowIsIntoPrototypes) {
  const auto built = build_classic(
      "PROTO In [ inputOutput SFFloat t 0 ] { Group { children [ Shape { appearance Appearance { material DEF M Material { "
      "transparency IS t } } } Shape { appearance Appearance { material Material { transparency IS t } } } ] } }\n"
      "PROTO Out [ inputOnly SFFloat set_t outputOnly SFFloat sent ] { Group { children [ In { t IS set_t } "
      "DEF I ScalarInterpolator { set_fraction IS set_t value_changed IS sent } ] } }\n"
      "DEF C TimeSensor { } DEF P Out { }\n"
      "ROUTE C.fraction_changed TO P.set_t\nDEF M Material { }\nROUTE P.sent TO M.shininess");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->dump().substr(built->dump().find("route")),
            "route #0.fraction_changed to #5.transparency\n"
            "route #0.fraction_changed to #8.transparency\n"
            "route #0.fraction_changed to #9.set_fraction\n"
            "route #9.value_changed to #10.shininess\n");
}

TEST(Routes, ReportsWhatDoesNotFit) {
  const auto built = build_classic(
      "DEF C TimeSensor { } DEF T Transform { } DEF B Box { }\n"
      "ROUTE C.fraction_changed TO T.translation\n"
      "ROUTE C.fraction TO T.translation\n"
      "ROUTE D.fraction_changed TO T.translation\n"
      "ROUTE T.translation TO B.size\n"
      "ROUTE C.fraction_changed TO C.isActive\n");
  EXPECT_EQ(
      built->said(),
      "scene.x3dv:3:1: warning: `C.fraction_changed` sends SFFloat, but `T.translation` receives SFVec3f [route-invalid]\n"
      "scene.x3dv:4:9: warning: `TimeSensor` has no field `fraction` that sends events [route-invalid]\n"
      "scene.x3dv:5:7: warning: no node is named `D` [route-invalid]\n"
      "scene.x3dv:6:26: warning: `Box` has no field `size` that receives events [route-invalid]\n"
      "scene.x3dv:7:31: warning: `TimeSensor` has no field `isActive` that receives events [route-invalid]\n");
  EXPECT_TRUE(built->graph.routes().empty());
}

TEST(Routes, ALoggerTakesAnyType) {
  const auto built = build_classic("DEF C TimeSensor { } DEF L Logger { }\nROUTE C.isActive TO L.write");
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.routes().size(), 1U);
}

}  // namespace
}  // namespace plugc
