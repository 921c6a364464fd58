#include <gmock/gmock.h>

#include <filesystem>

#include "base/box_texture.h"
#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

// These need the DejaVu fonts (package fonts-dejavu-core).
class Text : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf")) GTEST_SKIP() << "no DejaVu fonts";
  }
};

std::string text_node(const std::string& strings, const std::string& style) {
  return "Text { string [ " + strings + " ] fontStyle FontStyle { " + style + " } }";
}

constexpr float kPixel = 1.0f / 19;  // DejaVu Serif: 15 pixels up and 4 down at 20 an em

void expect_box(const Mesh& mesh, float left, float bottom, float right, float top) {
  const Box3 box = box_of(mesh.positions);
  EXPECT_NEAR(box.low.x, left, 1e-4);
  EXPECT_NEAR(box.low.y, bottom, 1e-4);
  EXPECT_NEAR(box.high.x, right, 1e-4);
  EXPECT_NEAR(box.high.y, top, 1e-4);
}

TEST_F(Text, IsAsHighAsItsSizeAndAsLongAsItsGlyphs) {
  const Mesh mesh = mesh_from(text_node("\"HHHHH\"", "size 2"));
  expect_box(mesh, 0, -3 * kPixel * 2, 5 * 17 * kPixel * 2, 16 * kPixel * 2);
  EXPECT_FALSE(mesh.solid);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST_F(Text, EveryTriangleFacesTheViewer) {
  const Mesh mesh = mesh_from(text_node("\"The quick brown fox jumps 0123456789 &%@#$ A\xc3\x84\xc3\x98\xe2\x82\xac\"", ""));
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                    c = mesh.positions[mesh.indices[i + 2]];
    EXPECT_GE(glm::cross(b - a, c - a).z, -1e-7f) << "triangle " << i / 3;
  }
}

TEST_F(Text, HolesStayOpen) {
  const Mesh mesh = mesh_from(text_node("\"O\"", ""));
  const Box3 box = box_of(mesh.positions);
  const glm::vec2 center{(box.low.x + box.high.x) / 2, 8.5f * kPixel};
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec2 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                    c = mesh.positions[mesh.indices[i + 2]];
    const auto side = [&center](glm::vec2 p, glm::vec2 q) {
      return (q.x - p.x) * (center.y - p.y) - (q.y - p.y) * (center.x - p.x);
    };
    EXPECT_FALSE(side(a, b) > 0 && side(b, c) > 0 && side(c, a) > 0) << "triangle " << i / 3;
  }
}

TEST_F(Text, JustifiesLinesAlongAndAcross) {
  const std::string lines = "\"H\" \"H\" \"H\"";
  const float width = 17 * kPixel;
  expect_box(mesh_from(text_node(lines, "")), 0, -2 - 3 * kPixel, width, 16 * kPixel);
  expect_box(mesh_from(text_node(lines, "justify [ \"BEGIN\" \"BEGIN\" ]")), 0, -3, width, 0);
  expect_box(mesh_from(text_node(lines, "justify [ \"MIDDLE\" \"MIDDLE\" ]")), -width / 2, -1.5, width / 2, 1.5);
  expect_box(mesh_from(text_node(lines, "justify [ \"END\" \"END\" ]")), -width, 0, 0, 3);
}

TEST_F(Text, SpacingMovesTheLinesApart) {
  const Box3 box = box_of(mesh_from(text_node("\"H\" \"H\" \"H\"", "spacing 2")).positions);
  EXPECT_NEAR(box.high.y - box.low.y, 5, 1e-4);
}

TEST_F(Text, LengthAndMaxExtentStretchLines) {
  EXPECT_NEAR(box_of(mesh_from("Text { string [ \"HH\" \"HHHH\" ] length [ 10 ] }").positions).high.x, 10, 1e-3);
  EXPECT_NEAR(box_of(mesh_from("Text { string [ \"HH\" \"HHHH\" ] maxExtent 1 }").positions).high.x, 1, 1e-4);
}

TEST_F(Text, TextureCountsUnitsOfSizeFromTheFirstLine) {
  const Mesh mesh = mesh_from(text_node("\"H\" \"H\"", "size 4 justify \"MIDDLE\""));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(mesh.tex_coords[0][i].x, (mesh.positions[i].x + 17 * kPixel * 2) / 4, 1e-5);
    EXPECT_NEAR(mesh.tex_coords[0][i].y, mesh.positions[i].y / 4, 1e-5);
  }
}

TEST_F(Text, FamiliesHaveTheirOwnWidths) {
  EXPECT_NEAR(box_of(mesh_from(text_node("\"H\"", "family \"SANS\"")).positions).high.x, 15 * kPixel, 1e-4);
  EXPECT_NEAR(box_of(mesh_from(text_node("\"H\"", "family \"TYPEWRITER\"")).positions).high.x, 12 * kPixel, 1e-4);
  EXPECT_NEAR(box_of(mesh_from(text_node("\"H\"", "style \"BOLD\"")).positions).high.x, 19 * kPixel, 1e-4);
}

TEST_F(Text, BlankTextIsEmpty) {
  const MadeMesh made = make_mesh_from("Text { string [ \"  \" \"\" ] }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(made.messages, testing::ElementsAre("2:1 this `Text` is empty; nothing is drawn [not-drawn]"));
}

TEST_F(Text, BrokenUtf8IsDrawnAsReplacement) {
  EXPECT_FALSE(mesh_from("Text { string \"a\xff\xc3\" }").indices.empty());
}

TEST_F(Text, LinesMayRunToTheLeftAndUpwards) {
  const float width = 17 * kPixel;
  const std::string lines = "\"H\" \"H\" \"H\"";
  expect_box(mesh_from(text_node(lines, "leftToRight FALSE justify [ \"BEGIN\" \"BEGIN\" ]")), -width, -3, 0, 0);
  expect_box(mesh_from(text_node(lines, "leftToRight FALSE justify [ \"END\" \"BEGIN\" ]")), 0, -3, width, 0);
  expect_box(mesh_from(text_node(lines, "topToBottom FALSE justify [ \"BEGIN\" \"BEGIN\" ]")), 0, 0, width, 3);
  expect_box(mesh_from(text_node(lines, "topToBottom FALSE justify [ \"BEGIN\" \"END\" ]")), 0, -3, width, 0);
}

TEST_F(Text, CharactersFromTheRightComeInTheirOrder) {
  const Mesh mesh = mesh_from(text_node("\"Hi\"", "leftToRight FALSE"));
  const Mesh mirrored = mesh_from(text_node("\"iH\"", "justify \"END\""));
  EXPECT_EQ(mesh.positions, mirrored.positions);
}

TEST_F(Text, ColumnsStandSideBySide) {
  const std::string columns = "\"HH\" \"H\" \"H\"";
  expect_box(mesh_from(text_node(columns, "horizontal FALSE")), 0, -2, 3, 0);
  expect_box(mesh_from(text_node(columns, "horizontal FALSE leftToRight FALSE")), -3, -2, 0, 0);
  expect_box(mesh_from(text_node(columns, "horizontal FALSE topToBottom FALSE")), 0, 0, 3, 2);
  expect_box(mesh_from(text_node(columns, "horizontal FALSE justify [ \"END\" \"END\" ]")), -3, 0, 0, 2);
  expect_box(mesh_from(text_node(columns, "horizontal FALSE justify [ \"MIDDLE\" \"MIDDLE\" ]")), -1.5, -1, 1.5, 1);
}

TEST_F(Text, SolidTextIsSeenFromTheFrontAlone) {
  EXPECT_FALSE(mesh_from("Text { string \"H\" }").solid);
  EXPECT_TRUE(mesh_from("Text { string \"H\" solid TRUE }").solid);
}

}  // namespace
}  // namespace plugc
