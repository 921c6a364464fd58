#include "mesh/backdrop.h"

#include <cmath>
#include <numbers>

#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

constexpr double kPi = std::numbers::pi;

MadeMesh made_part(const std::string& background, ScenePart part) {
  return make_mesh_from(background, "X3DBackgroundNode", [part](const NodeGraph& graph, NodeId node, Diagnostics& diagnostics) {
    return make_backdrop_mesh(graph, node, part, diagnostics);
  });
}

Mesh gradient(const std::string& background) {
  MadeMesh made = made_part(background, ScenePart::gradient);
  EXPECT_EQ(made.messages, std::vector<std::string>{});
  EXPECT_TRUE(made.mesh.has_value());
  return made.mesh.value_or(Mesh{});
}

double angle_from_zenith(const glm::vec3& position) {
  return std::acos(std::clamp(static_cast<double>(position.y), -1.0, 1.0));
}

TEST(Backdrop, GradientIsASphereOfRadiusOneAroundTheEye) {
  const Mesh mesh =
      gradient("Background { skyColor [ 1 0 0, 0 0 1 ] skyAngle 1 groundColor [ 0 1 0, 0 1 1 ] groundAngle 1.5 }");
  double lowest = 0, highest = kPi;
  for (const glm::vec3& position : mesh.positions) {
    EXPECT_NEAR(glm::length(position), 1, 1e-6);
    lowest = std::max(lowest, angle_from_zenith(position));
    highest = std::min(highest, angle_from_zenith(position));
  }
  EXPECT_NEAR(highest, 0, 1e-3);
  EXPECT_NEAR(lowest, kPi, 1e-3);
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  EXPECT_FALSE(mesh.solid);
}

/// The angles from the zenith at which vertices of that colour lie: least and largest.
std::pair<double, double> reach_of(const Mesh& mesh, const glm::vec3& color) {
  std::pair<double, double> reach = {kPi, 0};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (glm::distance(glm::vec3(mesh.colors[i]), color) > 1e-6F) continue;
    const double angle = angle_from_zenith(mesh.positions[i]);
    reach = {std::min(reach.first, angle), std::max(reach.second, angle)};
  }
  return reach;
}

void expect_reach(const Mesh& mesh, const glm::vec3& color, double from, double to) {
  const auto [least, largest] = reach_of(mesh, color);
  EXPECT_NEAR(least, from, 1e-3);
  EXPECT_NEAR(largest, to, 1e-3);
}

TEST(Backdrop, TheSkyHasARingForEachColorAndGoesOnToTheNadir) {
  const Mesh mesh = gradient("Background { skyColor [ 1 0 0, 0 1 0, 0 0 1 ] skyAngle [ 0.5, 2 ] }");
  expect_reach(mesh, {1, 0, 0}, 0, 0);
  expect_reach(mesh, {0, 1, 0}, 0.5, 0.5);
  expect_reach(mesh, {0, 0, 1}, 2, kPi);
}

TEST(Backdrop, TheGroundCountsFromTheNadirAndIsDrawnAfterTheSky) {
  const Mesh mesh = gradient("Background { skyColor [ 1 0 0, 1 0 0 ] skyAngle 1 groundColor [ 0 1 0, 0 0 1 ] groundAngle 1 }");
  expect_reach(mesh, {1, 0, 0}, 0, kPi);
  expect_reach(mesh, {0, 1, 0}, kPi, kPi);
  expect_reach(mesh, {0, 0, 1}, kPi - 1, kPi - 1);
  EXPECT_EQ(mesh.colors[mesh.indices.front()], glm::vec4(1, 0, 0, 1));
  EXPECT_NE(mesh.colors[mesh.indices.back()], glm::vec4(1, 0, 0, 1));
}

TEST(Backdrop, NoBeltPassesThroughTheEye) {
  const Mesh mesh = gradient("Background { skyColor [ 1 0 0, 0 0 1 ] skyAngle 3.14159265 }");
  expect_reach(mesh, {0.5, 0, 0.5}, kPi / 2, kPi / 2);
}

TEST(Backdrop, TooManyColorsAreReported) {
  std::string colors, angles;
  for (int i = 0; i < 400'000; ++i) {
    colors += "1 1 0 ";
    if (i > 0) angles += std::to_string(1e-6 * i) + " ";
  }
  const MadeMesh made =
      made_part("Background { skyColor [ " + colors + " ] skyAngle [ " + angles + " ] }", ScenePart::gradient);
  EXPECT_FALSE(made.mesh.has_value());
  ASSERT_EQ(made.messages.size(), 1U);
  EXPECT_EQ(made.messages[0].find("2:1 the colours of this `Background` make "), 0U) << made.messages[0];
}

TEST(Backdrop, ASideIsASquareThatFillsAQuarterOfTheView) {
  const Mesh mesh = made_part("Background { }", ScenePart::top).mesh.value_or(Mesh{});
  ASSERT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.positions[0], glm::vec3(-1, 1, -1));  // the picture's lower left corner, next to the front and the left side
  EXPECT_EQ(mesh.tex_coords[0][0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 1));
  EXPECT_EQ(mesh.tex_coords[0][2], glm::vec4(1, 1, 0, 1));
}

}  // namespace
}  // namespace plugc
