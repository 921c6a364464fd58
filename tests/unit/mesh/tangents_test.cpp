// Tangents follow the texture coordinates and stay perpendicular to normals.

#include "mesh/tangents.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

Mesh quad() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

TEST(Tangents, PointWhereSGrows) {
  const auto tangents = make_tangents(quad(), {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}});
  ASSERT_EQ(tangents.size(), 4U);
  for (const glm::vec4& tangent : tangents) EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
}

TEST(Tangents, TurnWithTheCoordinates) {
  const auto tangents = make_tangents(quad(), {{0, 1, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}});
  for (const glm::vec4& tangent : tangents) EXPECT_EQ(tangent, glm::vec4(0, 1, 0, 1));
}

TEST(Tangents, FollowTheCoordinatesHoweverSmallTheMeshIs) {
  constexpr float kSmall = 1e-7F;
  Mesh mesh = quad();
  for (glm::vec3& position : mesh.positions) position *= kSmall;
  const auto tangents = make_tangents(mesh, {{0, kSmall, 0, 1}, {0, 0, 0, 1}, {kSmall, 0, 0, 1}, {kSmall, kSmall, 0, 1}});
  for (const glm::vec4& tangent : tangents) EXPECT_EQ(tangent, glm::vec4(0, 1, 0, 1));
}

TEST(Tangents, SayThatAMirroredTextureIsMirrored) {
  const auto tangents = make_tangents(quad(), {{1, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}});
  for (const glm::vec4& tangent : tangents) EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(Tangents, StayPerpendicularToSmoothNormals) {
  Mesh mesh = quad();
  for (glm::vec3& normal : mesh.normals) normal = glm::normalize(glm::vec3(1, 0, 1));
  for (const glm::vec4& tangent : make_tangents(mesh, {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}})) {
    EXPECT_NEAR(glm::dot(glm::vec3(tangent), mesh.normals[0]), 0, 1e-6);
    EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
  }
}

TEST(Tangents, AreAlongTheSurfaceWhereCoordinatesSayNothing) {
  const auto tangents = make_tangents(quad(), std::vector<glm::vec4>(4, {0.5, 0.5, 0, 1}));
  for (const glm::vec4& tangent : tangents) {
    EXPECT_NEAR(tangent.z, 0, 1e-6);
    EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
  }
}

TEST(Tangents, AreNotMadeForLines) {
  Mesh mesh = quad();
  mesh.topology = Topology::lines;
  EXPECT_TRUE(make_tangents(mesh, std::vector<glm::vec4>(4)).empty());
}

}  // namespace
}  // namespace plugc
