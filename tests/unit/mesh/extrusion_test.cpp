#include <gmock/gmock.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "base/box_texture.h"
#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

using testing::ElementsAre;

/// The volume inside closed triangles that look outward.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
    sum += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
  }
  return sum;
}

/// Normals look where the triangles do.
void expect_normals_of_triangles(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
    const glm::vec3 across = glm::cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(glm::dot(across, mesh.normals[mesh.indices[i + k]]), 0) << i / 3;
  }
}

TEST(Extrusion, TheDefaultIsABoxOfOneStorey) {
  const Mesh mesh = mesh_from("Extrusion { }");
  const Box3 box = box_of(mesh.positions);
  EXPECT_EQ(box.low, glm::vec3(-1, 0, -1));
  EXPECT_EQ(box.high, glm::vec3(1, 1, 1));
  EXPECT_EQ(mesh.indices.size(), 6U * 6);
  EXPECT_NEAR(volume(mesh), 4, 1e-5);
  expect_normals_of_triangles(mesh);
}

TEST(Extrusion, CapsAreLeftOutWhereNotWanted) {
  EXPECT_EQ(mesh_from("Extrusion { beginCap FALSE endCap FALSE }").indices.size(), 4U * 6);
  EXPECT_EQ(mesh_from("Extrusion { crossSection [ 0 0, 1 0 ] solid FALSE }").indices.size(), 6U) << "a line encloses nothing";
}

TEST(Extrusion, AnOpenCrossSectionIsClosedByItsCaps) {
  const Mesh mesh = mesh_from("Extrusion { crossSection [ 1 1, 1 -1, -1 -1 ] endCap FALSE }");
  EXPECT_EQ(mesh.indices.size(), 2U * 6 + 3);
}

// A straight spine turns the cross-section the shortest way: x stays where the spine goes along z.
TEST(Extrusion, AStraightSpineTurnsTheShortestWay) {
  const Mesh along_z = mesh_from("Extrusion { crossSection [ 2 1, 2 -1, -2 -1, -2 1, 2 1 ] spine [ 0 0 0, 0 0 3 ] }");
  const Box3 box = box_of(along_z.positions);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.low[i], glm::vec3(-2, -1, 0)[i], 1e-6);
    EXPECT_NEAR(box.high[i], glm::vec3(2, 1, 3)[i], 1e-6);
  }
  EXPECT_NEAR(volume(along_z), 24, 1e-4);
  EXPECT_NEAR(volume(mesh_from("Extrusion { spine [ 0 3 0, 0 0 0 ] }")), 12, 1e-4) << "downwards too the sides look outward";
}

TEST(Extrusion, ScaleAndOrientationActAtEachPointOfTheSpine) {
  const Mesh frustum = mesh_from("Extrusion { scale [ 1 1, 0.5 0.5 ] }");
  EXPECT_NEAR(volume(frustum), (4 + 1 + 2) / 3.0, 1e-5);
  const Mesh turned = mesh_from("Extrusion { orientation 0 1 0 0.7853982 }");
  EXPECT_NEAR(box_of(turned.positions).high.x, std::sqrt(2.0), 1e-5);
}

TEST(Extrusion, ScaleAndOrientationOfTooFewPointsServeAllOthers) {
  const Mesh mesh = mesh_from("Extrusion { spine [ 0 0 0, 0 1 0, 0 2 0 ] scale [ 1 1, 0.5 0.5 ] }");
  EXPECT_NEAR(volume(mesh), 7 / 3.0 + 1, 1e-5);
}

// A ring of sixteen segments: the volume of a torus, less what its corners lack; and no edge where the spine closes.
TEST(Extrusion, AClosedSpineHasNoSeam) {
  std::string spine;
  for (int i = 0; i <= 16; ++i) {
    const double angle = 2 * std::numbers::pi * (i % 16) / 16;
    spine += std::to_string(3 * std::cos(angle)) + " 0 " + std::to_string(3 * std::sin(angle)) + ", ";
  }
  const Mesh mesh = mesh_from("Extrusion { beginCap FALSE endCap FALSE creaseAngle 2 scale 0.1 0.1 spine [ " + spine + "] }");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (glm::distance(mesh.positions[i], mesh.positions[k]) > 1e-4F) continue;
      EXPECT_NEAR(glm::distance(mesh.normals[i], mesh.normals[k]), 0, 1e-3) << i << " and " << k;
    }
  }
  EXPECT_NEAR(std::abs(volume(mesh)), 0.04 * 16 * 2 * 3 * std::sin(std::numbers::pi / 16) * std::cos(std::numbers::pi / 16),
              0.02);
}

TEST(Extrusion, DirectionChangesKeepTheSectionFromFlipping) {
  const Mesh mesh = mesh_from("Extrusion { scale 0.1 0.1 spine [ 0 0 0, 0 1 0, 1 1 0, 1 2 0, 2 2 0 ] }");
  EXPECT_GT(volume(mesh), 0.1);
  expect_normals_of_triangles(mesh_from("Extrusion { scale 0.1 0.1 spine [ 0 0 0, 0 1 0, 1 2 0, 1 3 0 ] convex FALSE }"));
}

TEST(Extrusion, PointsThatCoincideHaveOnePlane) {
  const Mesh mesh = mesh_from("Extrusion { spine [ 0 0 0, 0 0 0, 0 1 0, 0 1 0 ] beginCap FALSE endCap FALSE }");
  for (const glm::vec3& point : mesh.positions) EXPECT_TRUE(std::isfinite(point.x + point.y + point.z));
  const Box3 box = box_of(mesh.positions);
  EXPECT_EQ(box.high, glm::vec3(1, 1, 1));
}

std::string repeated(std::string_view piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

TEST(Extrusion, ManyPointsInOnePlaceStayQuick) {
  const std::string cross_section = "Extrusion { beginCap FALSE endCap FALSE crossSection [ 1 0, -1 0 ] spine [ ";
  const std::clock_t start = std::clock();
  EXPECT_EQ(mesh_from(cross_section + repeated("0 0 0, ", 100'000) + "] }").indices.size(), 6U * 99'999);
  const Mesh bent = mesh_from(cross_section + repeated("0 0 0, ", 50'000) + repeated("0 2 0, ", 50'000) + "3 2 0 ] }");
  EXPECT_LT(std::clock() - start, 10 * CLOCKS_PER_SEC);
  EXPECT_EQ(box_of(bent.positions).low.y, box_of(mesh_from(cross_section + "0 0 0, 0 2 0, 3 2 0 ] }").positions).low.y);
}

TEST(Extrusion, IsLimitedByTheCornersOfItsFaces) {
  const MadeMesh made = make_mesh_from("Extrusion { crossSection [ " + repeated("1 0 0 1 ", 1'800) + "] spine [ " +
                                       repeated("0 1 0 ", 3'600) + "] }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(made.messages, ElementsAre("2:1 this `Extrusion` has 3599 x 3599 faces, more than 50000000 corners; plugc takes "
                                         "no more [geometry-limit]"));
}

TEST(Extrusion, SaysWhereThereIsNothingToDraw) {
  EXPECT_THAT(make_mesh_from("Extrusion { spine [ 0 0 0 ] }").messages,
              ElementsAre("2:1 this `Extrusion` is empty; nothing is drawn [not-drawn]"));
  EXPECT_THAT(make_mesh_from("Extrusion { scale 1e38 1e38 crossSection [ 1e30 0, 0 1e30, 0 0 ] }").messages,
              ElementsAre("2:1 this `Extrusion` has sizes that are not finite numbers [geometry-invalid]"));
}

TEST(Extrusion, TheTextureLiesOnceAroundAndOnceAlong) {
  const Mesh mesh = mesh_from("Extrusion { beginCap FALSE endCap FALSE }");
  bool found = false;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i] != glm::vec3(1, 1, -1)) continue;
    EXPECT_EQ(glm::vec2(mesh.tex_coords[0][i]), glm::vec2(0.25, 1));
    found = true;
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace plugc
