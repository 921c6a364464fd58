// Small files that mean much: USE of USE, prototypes of prototypes, Inlines of Inlines.

#include <fmt/format.h>

#include "attack.h"
#include "base/limits.h"
#include "scene/scene.h"

namespace plugc {
namespace {

using Files = std::map<std::string, std::string>;

TEST(Attacks, AMillionUsesAreOneNode) {
  const auto built = build(classic_scene("DEF A Group { } Group { children [ " + repeated("USE A ", 1'000'000) + "] }"));
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.size(), 2U);
  EXPECT_EQ(built->graph.children(built->root(1), "children").size(), 1'000'000U);
}

TEST(Attacks, APathForEachSubsetIsNoNodeForEachPath) {
  std::string text = "DEF N0 Shape { }\n";
  for (int i = 1; i <= 40; ++i) text += fmt::format("DEF N{} Group {{ children [ USE N{} USE N{} ] }}\n", i, i - 1, i - 1);
  const auto built = build(classic_scene(text));
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.size(), 41U);
}

/// As APathForEachSubset, but walked: each path to the shape is a shape of the scene.
TEST(Attacks, StopWhereShapesMultiply) {
  for (const std::string_view innermost : {"Shape { geometry Box { } }", "Group { }"}) {
    std::string text = fmt::format("DEF N0 {}\n", innermost);
    for (int i = 1; i <= 40; ++i) {
      text += fmt::format("DEF N{} Transform {{ children [ USE N{} USE N{} Effect {{ }} ] }}\n", i, i - 1, i - 1);
    }
    const std::size_t peak = peak_of([&] {
      const auto built = build(classic_scene(text));
      const Scene scene = build_scene(built->graph, built->sources, built->files, {}, built->diagnostics);
      const bool stopped = count_of(built->diagnostics, DiagnosticId::scene_limit) == 1 &&
                           scene.shapes.size() <= kMaxShapeInstances && scene.transforms.size() <= kMaxSceneNodes;
      if (!stopped) _exit(1);
    });
    expect_peak(peak, std::size_t{1} << 30);
  }
}

TEST(Attacks, FindPrototypesThatContainThemselves) {
  EXPECT_EQ(build(classic_scene("PROTO A [ ] { A { } } A { }"))->graph.size(), 0U);
  const std::string by_field =
      "PROTO A [ field SFNode n NULL ] { Group { children IS n } }\nPROTO B [ ] { A { n B { } } }\nB { }";
  EXPECT_LE(build(classic_scene(by_field))->graph.size(), 2U);
  const auto around = build(classic_scene("Inline { url \"a.x3dv\" }"),
                            Files{{"a.x3dv", classic_scene("PROTO P [ ] { Inline { url \"a.x3dv\" } } P { }")}});
  EXPECT_EQ(count_of(around->diagnostics, DiagnosticId::inline_cycle), 1U) << around->said();
  EXPECT_LE(around->graph.size(), kMaxProtoDepth + kMaxInlineDepth);
}

TEST(Attacks, FindExternalPrototypesInACircleOfFiles) {
  const auto outside = [](const std::string& name, const std::string& url) {
    return classic_scene("EXTERNPROTO " + name + " [ ] \"" + url + "\"\n" + name + " { }");
  };
  const auto built =
      build(outside("A", "b.x3dv#B"), Files{{"b.x3dv", outside("B", "c.x3dv#C")}, {"c.x3dv", outside("C", "b.x3dv#B")}});
  EXPECT_EQ(count_of(built->diagnostics, DiagnosticId::externproto_missing), 1U) << built->said();
  const auto bodies =
      build(outside("A", "b.x3dv#A"), Files{{"b.x3dv", classic_scene("EXTERNPROTO B [ ] \"c.x3dv#B\" PROTO A [ ] { B { } }")},
                                            {"c.x3dv", classic_scene("EXTERNPROTO A [ ] \"b.x3dv#A\" PROTO B [ ] { A { } }")}});
  EXPECT_EQ(count_of(bodies->diagnostics, DiagnosticId::proto_cycle), 1U) << bodies->said();
}

/// P0 to P30, each ten times the one before; the last one is used.
std::string tenfold(const std::string& innermost, const std::string& before, const std::string& behind) {
  std::string text = "PROTO P0 [ ] { " + innermost + " }\n";
  for (int i = 1; i <= 30; ++i) {
    text += fmt::format("PROTO P{} [ ] {{ {}{}{} }}\n", i, before, repeated(fmt::format("P{} {{ }} ", i - 1), 10), behind);
  }
  return classic_scene(text + "P30 { }");
}

TEST(Attacks, StopWherePrototypesMultiply) {
  for (const std::string& text : {tenfold("Shape { }", "Group { children [ ", "] }"), tenfold("", "", "")}) {
    const std::size_t peak = peak_of([&] {
      const auto built = build(text);
      const bool stopped = count_of(built->diagnostics, DiagnosticId::scene_limit) == 1 &&
                           built->diagnostics.all().size() == 1 && built->graph.size() <= kMaxSceneNodes;
      if (!stopped) _exit(1);
    });
    expect_peak(peak, std::size_t{1} << 30);
  }
}

TEST(Attacks, StopWhereInlinesMultiply) {
  Files files;
  for (int i = 1; i <= 25; ++i) {
    const std::string inlined = fmt::format("Inline {{ url \"{}.x3dv\" }}\n", i + 1);
    files[std::to_string(i) + ".x3dv"] = classic_scene(inlined + inlined);
  }
  files["26.x3dv"] = classic_scene("Shape { }");
  const std::size_t peak = peak_of([&] {
    const auto built = build(classic_scene("Inline { url \"1.x3dv\" }"), files);
    if (count_of(built->diagnostics, DiagnosticId::scene_limit) != 1 || built->sources.name({26}).empty()) _exit(1);
  });
  expect_peak(peak, std::size_t{1} << 30);
}

TEST(Attacks, EndACircleOfInlines) {
  const auto built = build(
      classic_scene("Inline { url \"a.x3dv\" }"),
      Files{{"a.x3dv", classic_scene("Inline { url \"b.x3dv\" }")}, {"b.x3dv", classic_scene("Inline { url \"a.x3dv\" }")}});
  EXPECT_EQ(built->said(), "b.x3dv:2:14: error: `a.x3dv` includes itself [inline-cycle]\n");
  EXPECT_EQ(built->graph.size(), 3U);
}

TEST(Attacks, EndALongRowOfInlines) {
  Files files;
  for (int i = 0; i < 100; ++i)
    files[std::to_string(i) + ".x3dv"] = classic_scene(fmt::format("Inline {{ url \"{}.x3dv\" }}", i + 1));
  const auto built = build(classic_scene("Inline { url \"0.x3dv\" }"), files);
  EXPECT_EQ(built->said(), "31.x3dv:2:14: error: files are inlined more than 32 deep [inline-cycle]\n");
}

TEST(Attacks, EndALongRowOfPrototypes) {
  std::string text = "PROTO P0 [ ] { Shape { } }\n";
  for (int i = 1; i <= 100; ++i) text += fmt::format("PROTO P{} [ ] {{ P{} {{ }} }}\n", i, i - 1);
  const auto built = build(classic_scene(text + "P100 { }"));
  EXPECT_EQ(count_of(built->diagnostics, DiagnosticId::proto_cycle), built->diagnostics.all().size()) << built->said();
  EXPECT_NE(built->said().find("prototypes stand more than 64 deep inside one another"), std::string::npos);
}

}  // namespace
}  // namespace plugc
