#include <gmock/gmock.h>

#include <cmath>

#include "base/box_texture.h"
#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

glm::vec3 face_normal(const Mesh& mesh, std::size_t first_index) {
  const glm::vec3 a = mesh.positions[mesh.indices[first_index]];
  return glm::cross(mesh.positions[mesh.indices[first_index + 1]] - a, mesh.positions[mesh.indices[first_index + 2]] - a);
}

// Every triangle has an area and faces the way that its vertices' normals together say.
void expect_outward(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 normal = face_normal(mesh, i);
    EXPECT_GT(glm::length(normal), 1e-8f) << "triangle " << i / 3;
    glm::vec3 sum{0};
    for (std::size_t k = 0; k < 3; ++k) sum += mesh.normals[mesh.indices[i + k]];
    EXPECT_GT(glm::dot(normal, sum), 0) << "triangle " << i / 3;
  }
  for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-5);
}

void expect_box(const Mesh& mesh, const glm::vec3& low, const glm::vec3& high, float tolerance) {
  const Box3 box = box_of(mesh.positions);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.low[i], low[i], tolerance);
    EXPECT_NEAR(box.high[i], high[i], tolerance);
  }
}

// The texture coordinates at the vertex that lies at `position` with `normal`.
glm::vec2 texture_at(const Mesh& mesh, const glm::vec3& position, const glm::vec3& normal) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (glm::distance(mesh.positions[i], position) < 1e-5f && glm::dot(mesh.normals[i], normal) > 0.99f)
      return glm::vec2(mesh.tex_coords[0][i]);
  ADD_FAILURE() << "no such vertex";
  return {};
}

TEST(Box, HasTwelveTrianglesThatFaceOut) {
  const Mesh mesh = mesh_from("Box { size 2 4 6 solid FALSE }");
  EXPECT_EQ(mesh.indices.size(), 36u);
  EXPECT_EQ(mesh.positions.size(), 24u);
  EXPECT_FALSE(mesh.solid);
  EXPECT_TRUE(mesh.ccw);
  expect_outward(mesh);
  expect_box(mesh, {-1, -2, -3}, {1, 2, 3}, 0);
}

TEST(Box, ShowsTheWholePictureUprightOnEachFace) {
  const Mesh mesh = mesh_from("Box { }");
  EXPECT_EQ(texture_at(mesh, {1, 1, 1}, {0, 0, 1}), glm::vec2(1, 1));
  EXPECT_EQ(texture_at(mesh, {-1, -1, 1}, {0, 0, 1}), glm::vec2(0, 0));
  EXPECT_EQ(texture_at(mesh, {1, 1, -1}, {0, 0, -1}), glm::vec2(0, 1));
  EXPECT_EQ(texture_at(mesh, {1, 1, 1}, {1, 0, 0}), glm::vec2(0, 1));
  EXPECT_EQ(texture_at(mesh, {-1, 1, 1}, {-1, 0, 0}), glm::vec2(1, 1));
  EXPECT_EQ(texture_at(mesh, {-1, 1, 1}, {0, 1, 0}), glm::vec2(0, 0));
  EXPECT_EQ(texture_at(mesh, {-1, -1, 1}, {0, -1, 0}), glm::vec2(0, 1));
}

TEST(Sphere, LiesOnItsRadiusAndFacesOut) {
  const Mesh mesh = mesh_from("Sphere { radius 3 }");
  expect_outward(mesh);
  for (const glm::vec3& position : mesh.positions) EXPECT_NEAR(glm::length(position), 3, 1e-5);
  EXPECT_EQ(mesh.indices.size() / 3, 30u * 2 * 19);
}

TEST(Sphere, WrapsItsTextureFromTheBackOverTheLeft) {
  const Mesh mesh = mesh_from("Sphere { }");
  EXPECT_EQ(texture_at(mesh, {0, 0, 1}, {0, 0, 1}), glm::vec2(0.5f, 0.5f));
  EXPECT_EQ(texture_at(mesh, {0, 0, -1}, {0, 0, -1}), glm::vec2(0, 0.5f));
  const float left = std::sin(2 * 3.14159265f * 7 / 30), back = -std::cos(2 * 3.14159265f * 7 / 30);
  EXPECT_EQ(texture_at(mesh, {-left, 0, back}, {-left, 0, back}), glm::vec2(7 / 30.0f, 0.5f));
}

TEST(Cone, LeansItsNormalsUpAndLeavesOutWhatIsOff) {
  const Mesh whole = mesh_from("Cone { bottomRadius 1 height 2 }");
  expect_outward(whole);
  expect_box(whole, {-1, -1, -1}, {1, 1, 1}, 0.01f);
  EXPECT_NEAR(whole.normals[0].y, 1 / std::sqrt(5.0f), 1e-5);
  EXPECT_EQ(mesh_from("Cone { bottom FALSE }").indices.size() / 3, 30u);
  EXPECT_EQ(mesh_from("Cone { side FALSE }").indices.size() / 3, 28u);
}

TEST(Cylinder, HasSideTopAndBottom) {
  const Mesh whole = mesh_from("Cylinder { radius 2 height 3 }");
  expect_outward(whole);
  expect_box(whole, {-2, -1.5f, -2}, {2, 1.5f, 2}, 0.02f);
  EXPECT_EQ(mesh_from("Cylinder { top FALSE bottom FALSE }").indices.size() / 3, 60u);
  EXPECT_EQ(texture_at(whole, {0, 1.5f, 2}, {0, 1, 0}), glm::vec2(0.5f, 0));
  EXPECT_EQ(texture_at(whole, {0, -1.5f, 2}, {0, -1, 0}), glm::vec2(0.5f, 1));
  EXPECT_EQ(texture_at(whole, {0, 1.5f, 2}, {0, 0, 1}), glm::vec2(0.5f, 1));
}

TEST(Cylinder, WithNothingOnIsSaidToBeEmpty) {
  const MadeMesh made = make_mesh_from("Cylinder { side FALSE top FALSE bottom FALSE }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(made.messages, testing::ElementsAre("2:1 this `Cylinder` is empty; nothing is drawn [not-drawn]"));
}

TEST(Rectangle2D, FacesTheViewer) {
  const Mesh mesh = mesh_from("Rectangle2D { size 4 2 }");
  expect_outward(mesh);
  expect_box(mesh, {-2, -1, 0}, {2, 1, 0}, 0);
}

TEST(Teapot, FillsTheWidthAndKeepsItsProportions) {
  const Mesh mesh = mesh_from("Teapot { }");
  expect_outward(mesh);
  expect_box(mesh, {-1.5f, -0.7344f, -0.9326f}, {1.5f, 0.7344f, 0.9326f}, 1e-3f);
}

TEST(Teapot, PutsTheSpoutAtPlusX) {
  const Mesh mesh = mesh_from("Teapot { }");
  const auto tip = std::ranges::max_element(mesh.positions, {}, &glm::vec3::x);
  const auto handle = std::ranges::min_element(mesh.positions, {}, &glm::vec3::x);
  EXPECT_GT(tip->y, 0.3f);
  EXPECT_LT(handle->y, tip->y - 0.2f);
}

TEST(Teapot, ScalesEachAxisByItsSize) {
  const Mesh mesh = mesh_from("Teapot { size 6 1.5 3 }");
  expect_box(mesh, {-3, -0.3672f, -0.9326f}, {3, 0.3672f, 0.9326f}, 1e-3f);
}

TEST(Teapot, TextureLiesOverItsBoxFromAbove) {
  const Mesh mesh = mesh_from("Teapot { }");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(mesh.tex_coords[0][i].x, (mesh.positions[i].x + 1.5f) / 3, 1e-5);
    EXPECT_NEAR(mesh.tex_coords[0][i].y, (mesh.positions[i].z + 0.93257f) / 3, 1e-4);
  }
}

TEST(Teapot, IsWeldedAlongItsPatches) {
  const Mesh mesh = mesh_from("Teapot { }");
  std::vector<glm::vec3> sorted = mesh.positions;
  std::ranges::sort(sorted,
                    [](const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
}

TEST(Mesh, SizesThatAreNoNumbersMakeNoMesh) {
  const MadeMesh made = make_mesh_from("Box { size 1e300 1 1 }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(made.messages, testing::ElementsAre("2:1 this `Box` has sizes that are not finite numbers [geometry-invalid]"));
}

TEST(Mesh, NodesThatAreNotDrawnAreNamed) {
  const MadeMesh made = make_mesh_from("NurbsSwungSurface { }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(made.messages, testing::ElementsAre("2:1 plugc does not draw `NurbsSwungSurface` [not-drawn]"));
}

}  // namespace
}  // namespace plugc
