#include <fmt/format.h>
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>

#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

using testing::ElementsAre;

double total_area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                     c = mesh.positions[mesh.indices[i + 2]];
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum;
}

// A roof of two quads that meet along y at a right angle, ridge up.
const std::string kRoof =
    "coord Coordinate { point [ -1 0 0, -1 0 2, 0 1 0, 0 1 2, 1 0 0, 1 0 2 ] } coordIndex [ 0 1 3 2 -1 2 3 5 4 -1 ]";

TEST(IndexedFaceSet, QuadsBecomeTwoTriangles) {
  const Mesh mesh = mesh_from("IndexedFaceSet { " + kRoof + " }");
  EXPECT_EQ(mesh.indices.size(), 12u);
  EXPECT_NEAR(total_area(mesh), 2 * 2 * std::sqrt(2.0), 1e-5);
}

TEST(IndexedFaceSet, CreaseAngleSplitsOrSmoothsAnEdge) {
  const Mesh sharp = mesh_from("IndexedFaceSet { creaseAngle 1.5 " + kRoof + " }");
  const Mesh smooth = mesh_from("IndexedFaceSet { creaseAngle 1.6 " + kRoof + " }");
  EXPECT_EQ(sharp.positions.size(), 8u);
  EXPECT_EQ(smooth.positions.size(), 6u);
  for (std::size_t i = 0; i < smooth.positions.size(); ++i) {
    if (smooth.positions[i].x == 0) {
      EXPECT_NEAR(smooth.normals[i].y, 1, 1e-6);
    }
  }
}

TEST(IndexedFaceSet, NormalsPointToTheFrontWhateverTheWinding) {
  const Mesh ccw = mesh_from("IndexedFaceSet { " + kRoof + " }");
  const Mesh cw = mesh_from("IndexedFaceSet { ccw FALSE " + kRoof + " }");
  EXPECT_GT(ccw.normals[0].y, 0);
  EXPECT_LT(cw.normals[0].y, 0);
  EXPECT_FALSE(cw.ccw);
  EXPECT_EQ(cw.indices, ccw.indices);
}

TEST(IndexedFaceSet, TakesNormalsByTheirOwnIndex) {
  const Mesh mesh = mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } coordIndex [ 0 1 2 ]\n"
      "normal Normal { vector [ 1 0 0, 0 3 0 ] } normalIndex [ 1 1 0 ] }");
  EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(0, 1, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)));
}

TEST(IndexedFaceSet, NormalsPerFaceFollowTheFaceNumber) {
  const Mesh mesh =
      mesh_from("IndexedFaceSet { normalPerVertex FALSE normal Normal { vector [ 1 0 0, 0 0 1 ] } " + kRoof + " }");
  EXPECT_THAT(std::vector(mesh.normals.begin(), mesh.normals.begin() + 4), testing::Each(glm::vec3(1, 0, 0)));
  EXPECT_THAT(std::vector(mesh.normals.begin() + 4, mesh.normals.end()), testing::Each(glm::vec3(0, 0, 1)));
}

TEST(IndexedFaceSet, ColorsPerFaceAndPerVertex) {
  const std::string color = "color ColorRGBA { color [ 1 0 0 0.5, 0 1 0 1 ] } ";
  const Mesh per_face = mesh_from("IndexedFaceSet { colorPerVertex FALSE colorIndex [ 1 0 ] " + color + kRoof + " }");
  EXPECT_TRUE(per_face.colors_have_alpha);
  EXPECT_EQ(per_face.colors[0], glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(per_face.colors[4], glm::vec4(1, 0, 0, 0.5));
  const Mesh per_vertex = mesh_from("IndexedFaceSet { colorIndex [ 0 1 0 1 -1 1 1 0 0 -1 ] " + color + kRoof + " }");
  EXPECT_EQ(per_vertex.colors[1], glm::vec4(0, 1, 0, 1));
}

TEST(IndexedFaceSet, DefaultTextureRunsAlongTheTwoLongestSides) {
  const Mesh mesh =
      mesh_from("IndexedFaceSet { coord Coordinate { point [ 0 0 0, 0 1 0, 0 1 4, 0 0 4, 9 9 9 ] } coordIndex [ 0 1 2 3 ] }");
  EXPECT_THAT(mesh.tex_coords[0],
              ElementsAre(glm::vec4(0, 0, 0, 1), glm::vec4(0, 0.25, 0, 1), glm::vec4(1, 0.25, 0, 1), glm::vec4(1, 0, 0, 1)));
}

TEST(IndexedFaceSet, EqualSidesOfTheBoxAreTakenInTheOrderXyz) {
  const Mesh mesh = mesh_from("IndexedFaceSet { coord Coordinate { point [ 0 0 0, 2 0 2, 2 2 2 ] } coordIndex [ 0 1 2 ] }");
  EXPECT_THAT(mesh.tex_coords[0], ElementsAre(glm::vec4(0, 0, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(1, 1, 0, 1)));
}

TEST(IndexedFaceSet, MultiTextureCoordinateGivesUnitsAndGeneratedOnesTheDefault) {
  const Mesh mesh = mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 2 0 0, 2 2 0 ] } coordIndex [ 0 1 2 ] texCoord "
      "MultiTextureCoordinate { texCoord [\n"
      "TextureCoordinate { point [ 5 6, 7 8, 9 10 ] } TextureCoordinateGenerator { }\n"
      "TextureCoordinate4D { point [ 1 2 3 4, 1 2 3 5, 1 2 3 6 ] } TextureCoordinate3D { point [ 1 2 3, 1 2 4, 1 2 5 ] } ] } "
      "}");
  ASSERT_EQ(mesh.tex_coords.size(), 4u);
  EXPECT_EQ(mesh.tex_coords[0][1], glm::vec4(7, 8, 0, 1));
  EXPECT_EQ(mesh.tex_coords[1][1], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(mesh.tex_coords[2][1], glm::vec4(1, 2, 3, 5));
  EXPECT_EQ(mesh.tex_coords[3][2], glm::vec4(1, 2, 5, 1));
}

TEST(IndexedFaceSet, TakesSoManySetsOfCoordinates) {
  std::string sets;
  for (int i = 0; i < 40; ++i) sets += "TextureCoordinate { point [ 0 0, 1 0, 1 1 ] } ";
  const MadeMesh made = make_mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } coordIndex [ 0 1 2 ]\n"
      "texCoord MultiTextureCoordinate { texCoord [ " +
      sets + "] } }");
  EXPECT_THAT(made.messages,
              ElementsAre("3:10 `texCoord` has 40 sets of coordinates; plugc takes the first 32 [geometry-limit]"));
  EXPECT_EQ(made.mesh.value().tex_coords.size(), 32u);
}

TEST(IndexedFaceSet, TakesAsManyAttributesAsAProgramReads) {
  std::string attributes;
  for (const char* const name : {"a", "b", "c", "d"})
    attributes += fmt::format("Matrix4VertexAttribute {{ name \"{}\" value [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ] }} ", name);
  const MadeMesh made =
      make_mesh_from("IndexedTriangleSet { coord Coordinate { point 0 0 0 } index [ 0 0 0 ]\nattrib [ " + attributes + "] }");
  EXPECT_THAT(made.messages,
              ElementsAre("3:8 `attrib` has more than 11 columns, and no program reads more; `c` and what follows "
                          "is left out [geometry-limit]"));
  EXPECT_EQ(made.mesh.value().attributes.size(), 2u);
}

/// Each face is cut in a time that is bearable; so is what a few kilobytes each can ask for together.
TEST(IndexedFaceSet, CutsConcaveFacesWhileThatIsBearable) {
  std::string points, face;
  for (int i = 0; i < 4096; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 4096, radius = i % 2 == 0 ? 1 : 0.9;
    points += fmt::format("{:.5f} {:.5f} 0, ", radius * std::cos(angle), radius * std::sin(angle));
    face += fmt::format("{} ", i);
  }
  std::string faces;
  for (int i = 0; i < 130; ++i) faces += face + "-1 ";
  const MadeMesh made = make_mesh_from("IndexedFaceSet { convex FALSE coord Coordinate { point [ " + points +
                                       "] } coordIndex [ " + faces + "] }");
  EXPECT_EQ(made.mesh.value().indices.size(), 130u * 4094 * 3);
  EXPECT_THAT(made.messages, ElementsAre("2:1 this `IndexedFaceSet` has more concave corners than plugc cuts into triangles in "
                                         "bearable time; it takes some faces as convex [geometry-limit]"));
}

TEST(IndexedFaceSet, ConcaveFacesKeepTheirArea) {
  const std::string arrow = "coord Coordinate { point [ 0 0 0, 4 -3 0, 1 0 0, 4 3 0 ] } coordIndex [ 0 1 2 3 ]";
  EXPECT_NEAR(total_area(mesh_from("IndexedFaceSet { convex FALSE " + arrow + " }")), 3, 1e-6);
  const Mesh back = mesh_from("IndexedFaceSet { convex FALSE ccw FALSE " + arrow + " }");
  EXPECT_NEAR(total_area(back), 3, 1e-6);
  const glm::vec3 a = back.positions[back.indices[0]];
  EXPECT_GT(glm::cross(back.positions[back.indices[1]] - a, back.positions[back.indices[2]] - a).z, 0) << "as written";
}

TEST(IndexedFaceSet, BadIndexLeavesOutItsFaceOnly) {
  const MadeMesh made = make_mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] }\n coordIndex [ 0 1 7 -1 0 1 2 -1 0 1 9 ] }");
  ASSERT_TRUE(made.mesh);
  EXPECT_EQ(made.mesh->indices.size(), 3u);
  EXPECT_THAT(
      made.messages,
      ElementsAre(
          "3:13 `coordIndex` holds 7, but `coord` has 3 entries; faces with such an index are left out [geometry-index]"));
}

TEST(IndexedFaceSet, TooFewNormalsAreReportedAtTheNormals) {
  const MadeMesh made = make_mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } coordIndex [ 0 1 2 ]\n normal Normal { vector 0 0 1 "
      "} }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(
      made.messages,
      ElementsAre("3:9 `normal` has 1 entries, but entry 1 is needed; the faces that need more are left out [geometry-invalid]",
                  "2:1 this `IndexedFaceSet` is empty; nothing is drawn [not-drawn]"));
}

TEST(IndexedFaceSet, ShortIndexListIsReportedAtItsPlace) {
  const MadeMesh made = make_mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } coordIndex [ 0 1 2 -1 2 1 0 ] color Color { color [ "
      "1 0 0 ] }\n"
      " colorIndex [ 0 0 0 -1 0 ] }");
  ASSERT_TRUE(made.mesh);
  EXPECT_EQ(made.mesh->indices.size(), 3u);
  EXPECT_THAT(
      made.messages,
      ElementsAre("3:13 `colorIndex` has 5 entries, too few for the faces; those without are left out [geometry-invalid]"));
}

TEST(IndexedFaceSet, InfiniteCoordinatesAreLeftOut) {
  const MadeMesh made = make_mesh_from(
      "IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0, 1e300 0 0 ] } coordIndex [ 0 1 3 -1 0 1 2 ] }");
  ASSERT_TRUE(made.mesh);
  EXPECT_EQ(made.mesh->indices.size(), 3u);
  EXPECT_THAT(made.messages,
              ElementsAre("2:24 point 3 of `coord` is not finite; the faces that use it are left out [geometry-invalid]"));
}

TEST(IndexedFaceSet, FlatFacesWithoutAreaStillHaveUnitNormals) {
  const Mesh mesh = mesh_from("IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 2 0 0 ] } coordIndex [ 0 1 2 ] }");
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(glm::length(normal), 1);
}

TEST(IndexedFaceSet, HugeFanStaysQuick) {
  std::string points = "0 0 1", indices;
  constexpr int kSpokes = 20000;
  for (int i = 0; i <= kSpokes; ++i) {
    points += fmt::format(" {} {} 0", std::cos(i * 6.2831853 / kSpokes), std::sin(i * 6.2831853 / kSpokes));
    if (i > 0) indices += fmt::format(" 0 {} {} -1", i, i + 1);
  }
  const auto start = std::chrono::steady_clock::now();
  const Mesh mesh =
      mesh_from("IndexedFaceSet { creaseAngle 1 coord Coordinate { point [" + points + "] } coordIndex [" + indices + "] }");
  EXPECT_EQ(mesh.indices.size(), kSpokes * 3u);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(ElevationGrid, StandsOnItsSpacingsAndFacesUp) {
  const Mesh mesh =
      mesh_from("ElevationGrid { xDimension 3 zDimension 2 xSpacing 2 zSpacing 5 height [ 0 1 2 3 4 5 ] creaseAngle 3.2 }");
  EXPECT_THAT(mesh.positions, testing::UnorderedElementsAre(glm::vec3(0, 0, 0), glm::vec3(2, 1, 0), glm::vec3(4, 2, 0),
                                                            glm::vec3(0, 3, 5), glm::vec3(2, 4, 5), glm::vec3(4, 5, 5)));
  EXPECT_EQ(mesh.indices.size(), 12u);
  for (const glm::vec3& normal : mesh.normals) EXPECT_GT(normal.y, 0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_EQ(mesh.tex_coords[0][i], glm::vec4(mesh.positions[i].x / 4, mesh.positions[i].z / 5, 0, 1));
}

// Where the two triangles of a mesh meet.
std::vector<glm::vec3> shared_corners(const Mesh& mesh) {
  std::vector<glm::vec3> shared;
  for (std::size_t first = 0; first < 3; ++first) {
    for (std::size_t second = 3; second < 6; ++second) {
      const glm::vec3& point = mesh.positions[mesh.indices[first]];
      if (point == mesh.positions[mesh.indices[second]]) shared.push_back(point);
    }
  }
  return shared;
}

TEST(ElevationGrid, CellsAreCutAlongTheShorterDiagonal) {
  const std::string grid = "ElevationGrid { xDimension 2 zDimension 2 height ";
  EXPECT_THAT(shared_corners(mesh_from(grid + "[ 0 0 0 5 ] }")),
              testing::UnorderedElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)));
  EXPECT_THAT(shared_corners(mesh_from(grid + "[ 0 5 0 0 ] }")),
              testing::UnorderedElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 1)));
}

TEST(ElevationGrid, TooFewHeightsAreReported) {
  const MadeMesh made = make_mesh_from("ElevationGrid { xDimension 3 zDimension 2\nheight [ 0 1 2 ] }");
  EXPECT_FALSE(made.mesh);
  EXPECT_THAT(made.messages, ElementsAre("3:8 `height` has 3 values; a grid of 3 x 2 needs 6 [geometry-invalid]"));
}

const std::string kStrip = "coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0, 1 1 0, 0 2 0 ] }";

TEST(Triangles, SetsStripsAndFansFaceTheViewer) {
  for (const std::string& node : {
           "IndexedTriangleSet { index [ 0 1 2 2 1 3 2 3 4 ] " + kStrip + " }",
           "IndexedTriangleStripSet { index [ 0 1 2 3 4 -1 ] " + kStrip + " }",
           "TriangleStripSet { stripCount 5 " + kStrip + " }",
       }) {
    const Mesh mesh = mesh_from(node);
    EXPECT_EQ(mesh.indices.size(), 9u) << node;
    EXPECT_EQ(mesh.positions.size(), 5u) << node;
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1)) << node;
  }
}

TEST(Triangles, FansAndQuads) {
  const std::string square = "coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }";
  for (const std::string& node : {
           "TriangleFanSet { fanCount 4 " + square + " }",
           "IndexedTriangleFanSet { index [ 0 1 2 3 ] " + square + " }",
           "QuadSet { " + square + " }",
           "IndexedQuadSet { index [ 0 1 2 3 ] " + square + " }",
       }) {
    const Mesh mesh = mesh_from(node);
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3)) << node;
  }
}

TEST(Triangles, UnindexedTrianglesAreFlat) {
  const Mesh mesh = mesh_from("TriangleSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0, 0 0 0, 0 1 0, 0 0 1 ] } }");
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[3], glm::vec3(1, 0, 0));
}

TEST(Triangles, CountsBehindTheEndAreReported) {
  const MadeMesh made = make_mesh_from("TriangleStripSet { stripCount [ 3 7 ] " + kStrip + " }");
  ASSERT_TRUE(made.mesh);
  EXPECT_THAT(
      made.messages,
      ElementsAre("2:31 `stripCount` holds 7, but 2 points are left in `coord` and a run needs 3; what follows is left out "
                  "[geometry-index]"));
}

TEST(Lines, PolylinesBecomeSegments) {
  const Mesh mesh = mesh_from(
      "IndexedLineSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0 ] } coordIndex [ 0 1 2 -1 2 0 ]\n"
      "colorPerVertex FALSE color Color { color [ 1 0 0, 0 1 0 ] } }");
  EXPECT_EQ(mesh.topology, Topology::lines);
  EXPECT_EQ(mesh.indices.size(), 6u);
  EXPECT_EQ(mesh.colors[3], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(mesh.colors[4], glm::vec4(0, 1, 0, 1));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_EQ(mesh_from("LineSet { vertexCount 3 coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0 ] } }").indices.size(), 4u);
}

TEST(Points, EachIsAVertex) {
  const Mesh mesh = mesh_from("PointSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0 ] } }");
  EXPECT_EQ(mesh.topology, Topology::points);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace plugc
