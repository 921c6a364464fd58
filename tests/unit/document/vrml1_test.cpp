#include "document/vrml1_binding.h"

#include <gmock/gmock.h>

#include "reading.h"

namespace plugc {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr Vrml1Binding kPerVertex = {Vrml1Per::vertex, false}, kPerVertexIndexed = {Vrml1Per::vertex, true};
constexpr Vrml1Binding kPerFace = {Vrml1Per::face, false}, kPerFaceIndexed = {Vrml1Per::face, true};
const std::vector<double> kTwoFaces = {0, 1, 2, -1, 2, 1, 3};

std::string reading_of(const std::string& body) {
  return dump_of("#VRML V1.0 ascii\n" + body);
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(Vrml1Binding, ReadsItsWords) {
  EXPECT_EQ(read_binding("PER_FACE_INDEXED", {}).per, Vrml1Per::face);
  EXPECT_TRUE(read_binding("PER_FACE_INDEXED", {}).indexed);
  EXPECT_EQ(read_binding("OVERALL", kPerVertex).per, Vrml1Per::overall);
  EXPECT_EQ(read_binding("DEFAULT", kPerVertexIndexed).per, Vrml1Per::vertex);
}

TEST(Vrml1Binding, CountsFacesOrTakesTheirIndices) {
  EXPECT_THAT(bound_indices(kPerFace, kTwoFaces, {}, {2, 4}), ElementsAre(0, 1));
  EXPECT_THAT(bound_indices(kPerFaceIndexed, kTwoFaces, std::vector<double>{5, 4}, {6, 4}), ElementsAre(5, 4));
  EXPECT_THAT(bound_indices({}, kTwoFaces, {}, {1, 4}), ElementsAre(0, 0));
}

TEST(Vrml1Binding, TakesTheIndicesOfTheCoordinatesWhereThereAreNone) {
  EXPECT_THAT(bound_indices(kPerVertexIndexed, kTwoFaces, {}, {4, 4}), ElementsAre(0, 1, 2, -1, 2, 1, 3));
  const std::vector<double> own = {3, 3, 3, -1, 2, 2, 2};
  EXPECT_THAT(bound_indices(kPerVertexIndexed, kTwoFaces, own, {4, 4}), ElementsAre(3, 3, 3, -1, 2, 2, 2));
}

TEST(Vrml1Binding, TellsTheMeaningOfPerVertexByHowManyValuesThereAre) {
  EXPECT_THAT(bound_indices(kPerVertex, kTwoFaces, {}, {6, 4}), ElementsAre(0, 1, 2, -1, 3, 4, 5));
  EXPECT_THAT(bound_indices(kPerVertex, kTwoFaces, {}, {4, 4}), ElementsAre(0, 1, 2, -1, 2, 1, 3));
  EXPECT_THAT(bound_indices(kPerVertex, kTwoFaces, {}, {3, 4}), ElementsAre(0, 1, 2, -1, 3, 4, 5));
}

TEST(Vrml1, WritesAListOnceForAllShapesThatUseIt) {
  const std::string dump = reading_of(
      "Coordinate3 { point [ 0 0 0, 1 0 0, 0 1 0 ] }\n"
      "IndexedFaceSet { coordIndex [ 0, 1, 2 ] } IndexedFaceSet { coordIndex [ 2, 1, 0 ] }\n");
  EXPECT_EQ(count_of(dump, "field point"), 1U);
  EXPECT_EQ(count_of(dump, "USE Coordinate3"), 1U);
}

TEST(Vrml1, UsesAgainWhatHasTheSameProperties) {
  const std::string dump = reading_of("DEF A Separator { Cube { } } USE A Material { } USE A");
  EXPECT_EQ(count_of(dump, "USE A"), 1U);
  EXPECT_EQ(count_of(dump, "DEF A_2"), 1U);
}

/// The specification's own example: a component with fewer values than another keeps its last one.
TEST(Vrml1, MaterialsBeginAnewBehindTheLastOfTheLongestComponent) {
  const std::string dump = reading_of(
      "Material { ambientColor [ 0 0 0, 0 0 0, 0 0 0 ] diffuseColor [ 1 0 0, 0 1 0 ] } MaterialBinding { value "
      "PER_FACE_INDEXED }\n"
      "IndexedFaceSet { coordIndex [ 0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2, -1, 0, 1, 2 ] materialIndex [ 0, 1, 2, 3 ] }");
  EXPECT_THAT(dump, HasSubstr("colorIndex 0 1 1 0\n"));
}

TEST(Vrml1, NamesThatX3dWouldNotTakeAreChanged) {
  EXPECT_THAT(reading_of("DEF +1.5 Separator { Cube { } }"), HasSubstr("DEF _+1_5 Group"));
}

/// Each level draws the one below with two materials, so that nothing can be used again.
TEST(Vrml1, AFileThatDoublesAtEachLineStopsAtALimit) {
  std::string body = "DEF L0 Group { Cube { } }\n";
  for (int i = 1; i < 60; ++i) {
    const std::string below = "USE L" + std::to_string(i - 1);
    body += "DEF L" + std::to_string(i) + " Group { " + below + " Material { } " + below + " }\n";
  }
  EXPECT_THAT(Reading("#VRML V1.0 ascii\n" + body).messages(), HasSubstr("this file expands to more nodes than plugc takes"));
}

/// With another material at its end the chain has to be written anew, one node inside the other.
TEST(Vrml1, AChainOfUsesStopsAtTheDepthLimit) {
  std::string body = "DEF L0 Separator { Cube { } }\n";
  for (int i = 1; i < 3000; ++i) {
    body += "DEF L" + std::to_string(i) + " Separator { USE L" + std::to_string(i - 1) + " }\n";
  }
  body += "Material { } USE L2999";
  EXPECT_THAT(Reading("#VRML V1.0 ascii\n" + body).messages(), HasSubstr("nodes are nested more than 512 deep"));
}

TEST(Vrml1, NodesAreNestedToALimit) {
  std::string body;
  for (int i = 0; i < 600; ++i) body += "Separator { ";
  EXPECT_THAT(Reading("#VRML V1.0 ascii\n" + body + "Cube { }").messages(), HasSubstr("nodes are nested more than 512 deep"));
}

/// A light opens a group for what stands behind it; so many groups would leave no room for the shapes.
TEST(Vrml1, AnyNumberOfLightsBetweenShapesLosesNoShape) {
  std::string body;
  for (int i = 0; i < 600; ++i) body += "Cube { } PointLight { }\n";
  const Reading reading("#VRML V1.0 ascii\n" + body + "Sphere { }");
  EXPECT_EQ(
      reading.messages(),
      "258:10 10 this light needs a group more than 256 deep; like those behind it, it lights some shapes before it, too\n");
  EXPECT_EQ(count_of(reading.dump(), "Box"), 600U);
  EXPECT_EQ(count_of(reading.dump(), "PointLight"), 600U);
  EXPECT_EQ(count_of(reading.dump(), "Sphere"), 1U);
}

TEST(Vrml1, OfAFieldThatIsGivenTwiceTheLastValueCounts) {
  const Reading reading("#VRML V1.0 ascii\nSphere { radius 2 radius 3 radius [ ] }");
  EXPECT_THAT(reading.messages(), HasSubstr("2:19 6 `radius` of `Sphere` is given twice; the last value counts\n"));
  EXPECT_THAT(reading.dump(), AllOf(HasSubstr("3"), Not(HasSubstr("2 "))));
}

TEST(Vrml1, ALongNameIsCutAndNumberedAtItsBeginning) {
  const std::string name(5000, 'n');
  const Reading reading("#VRML V1.0 ascii\nDEF " + name + " Separator { Cube { } } Material { } USE " + name);
  EXPECT_THAT(reading.messages(), HasSubstr("2:5 5000 a name is longer than 1024 bytes; only its beginning counts\n"));
  EXPECT_THAT(reading.dump(), HasSubstr("DEF " + std::string(1023, 'n') + " Group"));
  EXPECT_THAT(reading.dump(), HasSubstr("DEF " + std::string(64, 'n') + "_2 Group"));
}

TEST(Vrml1, AnOddHeaderIsTold) {
  const Reading reading("#VRML V1.0 utf8\nCube { }");
  EXPECT_EQ(reading.messages(), "1:1 15 this header is not quite `#VRML V1.0 ascii`, but is read as that\n");
  EXPECT_EQ(reading.diagnostics.all()[0].id, DiagnosticId::header_odd);
}

}  // namespace
}  // namespace plugc
