#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "base/box_texture.h"
#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

using testing::ElementsAre;

/// Of triangles in the plane; negative ones look away.
double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
    sum += glm::cross(at(1) - at(0), at(2) - at(0)).z / 2;
  }
  return sum;
}

double length(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 2)
    sum += glm::distance(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]]);
  return sum;
}

TEST(Planar, ArcsAreAsLongAsTheirAngles) {
  EXPECT_NEAR(length(mesh_from("Arc2D { radius 2 }")), std::numbers::pi, 0.01);
  EXPECT_NEAR(length(mesh_from("Arc2D { startAngle 1 endAngle 0 }")), 2 * std::numbers::pi - 1, 0.01);
  EXPECT_NEAR(length(mesh_from("Arc2D { startAngle -1 endAngle 1 }")), 2, 0.01);
  for (const char* whole : {"Circle2D { }", "Arc2D { startAngle 1 endAngle 1 }", "Arc2D { startAngle -6.2 endAngle 6.2 }"})
    EXPECT_NEAR(length(mesh_from(whole)), 2 * std::numbers::pi, 0.01) << whole;
}

TEST(Planar, ClosedArcsArePiesOrChords) {
  EXPECT_NEAR(area(mesh_from("ArcClose2D { }")), std::numbers::pi / 4, 0.01);
  EXPECT_NEAR(area(mesh_from("ArcClose2D { closureType \"CHORD\" }")), std::numbers::pi / 4 - 0.5, 0.01);
  EXPECT_NEAR(area(mesh_from("ArcClose2D { startAngle 1 endAngle 1 }")), std::numbers::pi, 0.01);
}

TEST(Planar, DisksAreFullOrRingsOrCurves) {
  EXPECT_NEAR(area(mesh_from("Disk2D { outerRadius 2 }")), 4 * std::numbers::pi, 0.05);
  EXPECT_NEAR(area(mesh_from("Disk2D { outerRadius 2 innerRadius 1 }")), 3 * std::numbers::pi, 0.05);
  EXPECT_EQ(mesh_from("Disk2D { outerRadius 2 innerRadius 2 }").topology, Topology::lines);
  EXPECT_THAT(make_mesh_from("Disk2D { outerRadius 2 innerRadius 3 }").messages,
              ElementsAre("2:36 `innerRadius` is 3, more than `outerRadius`, which is 2 [geometry-invalid]"));
}

TEST(Planar, TheTextureOfADiskLiesOverItsSquare) {
  const Mesh mesh = mesh_from("Disk2D { outerRadius 2 }");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_NEAR(glm::distance(glm::vec2(mesh.tex_coords[0][i]), glm::vec2(mesh.positions[i]) / 4.0F + 0.5F), 0, 1e-6);
}

TEST(Planar, CurvesAndPoints) {
  const Mesh line = mesh_from("Polyline2D { lineSegments [ 0 0, 3 4, 3 5 ] }");
  EXPECT_EQ(line.topology, Topology::lines);
  EXPECT_NEAR(length(line), 6, 1e-6);
  const Mesh points = mesh_from("Polypoint2D { point [ 1 2, 3 4 ] }");
  EXPECT_EQ(points.topology, Topology::points);
  EXPECT_THAT(points.positions, ElementsAre(glm::vec3(1, 2, 0), glm::vec3(3, 4, 0)));
}

TEST(Planar, TrianglesLookToTheFrontHoweverTheyRun) {
  const Mesh mesh = mesh_from("TriangleSet2D { vertices [ 0 0, 1 0, 0 1, 0 0, 0 -1, -1 0, 5 5 ] }");
  EXPECT_NEAR(area(mesh), 1, 1e-6);
  EXPECT_EQ(mesh.positions.size(), 6U) << "a rest makes no triangle";
  EXPECT_FALSE(mesh.solid);
}

}  // namespace
}  // namespace plugc
