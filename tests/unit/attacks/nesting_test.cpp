// Brackets in brackets without end, closed and not, in each encoding: one message, and what is left is no deeper than allowed.

#include "attack.h"
#include "base/limits.h"

namespace plugc {
namespace {

constexpr std::size_t kDepth = 100'000;

std::string nested(std::string_view open, std::string_view close) {
  return repeated(open, kDepth) + repeated(close, kDepth);
}

void expect_cut(const std::string& text) {
  const auto built = build(text);
  EXPECT_EQ(count_of(built->diagnostics, DiagnosticId::nesting_limit), 1U) << built->said().substr(0, 500);
  EXPECT_EQ(built->diagnostics.all().size(), 1U);
  EXPECT_LE(built->graph.size(), kMaxNesting + 1);
}

TEST(Attacks, CutNodesInNodes) {
  expect_cut(classic_scene(nested("Group { children [ ", "] } ")));
  expect_cut("#VRML V2.0 utf8\n" + nested("Group { children [ ", "] } "));
  expect_cut(xml_scene(nested("<Group>", "</Group>")));
  expect_cut(json_scene(nested(R"({"Group":{"-children":[)", "]}}")));
}

TEST(Attacks, CutPrototypesInPrototypes) {
  const auto built = build(classic_scene(nested("PROTO A [ ] { ", "} ")));
  EXPECT_EQ(count_of(built->diagnostics, DiagnosticId::nesting_limit), 1U);
}

TEST(Attacks, SayOnceThatNothingIsClosed) {
  for (const std::string& text :
       {classic_scene(repeated("Group { children [ ", kDepth)), "<X3D version='3.3'><Scene>" + repeated("<Group>", kDepth),
        R"({"X3D":{"Scene":{"-children":[)" + repeated(R"({"Group":{"-children":[)", kDepth)}) {
    const auto built = build(text);
    EXPECT_GE(built->diagnostics.all().size(), 1U);
    EXPECT_LE(built->diagnostics.all().size(), 3U) << built->said();
    EXPECT_LE(built->graph.size(), kMaxNesting + 1);
  }
}

TEST(Attacks, SurviveBracketsAlone) {
  for (const std::string& text :
       {classic_scene("Group { children " + repeated("[", kDepth)), classic_scene(repeated("}", kDepth)),
        classic_scene(repeated("]", kDepth)), repeated("{", kDepth), repeated("<", kDepth), repeated("<a>", kDepth),
        R"({"X3D":)" + repeated(R"({"a":)", kDepth), R"({"X3D":)" + repeated("[", kDepth)}) {
    EXPECT_LE(build(text)->diagnostics.all().size(), kMaxSyntaxMistakes + 1);
  }
}

}  // namespace
}  // namespace plugc
