#include <gtest/gtest.h>

#include "scene/scene.h"
#include "unit/scene/graph_fixture.h"

namespace plugc {
namespace {

/// Each level shows the one below it ten times.
std::string tenfold(int levels, const std::string& innermost) {
  std::string text = "DEF L0 " + innermost + "\n";
  for (int i = 1; i <= levels; ++i) {
    text += "DEF L" + std::to_string(i) + " Group { children [";
    for (int k = 0; k < 10; ++k) text += " USE L" + std::to_string(i - 1);
    text += " ] }\n";
  }
  return text;
}

std::string said_of_scene(const std::string& text, std::size_t& shapes) {
  const auto built = build_classic(text);
  const Scene scene = build_scene(built->graph, built->sources, built->files, {}, built->diagnostics);
  shapes = scene.shapes.size();
  return built->said();
}

TEST(SceneLimits, StopsAtTheLimitOfShapes) {
  std::size_t shapes = 0;
  const std::string said = said_of_scene(tenfold(6, "Shape { geometry Box { } }"), shapes);
  EXPECT_EQ(shapes, 200'000U);
  EXPECT_EQ(said,
            "scene.x3dv:2:8: error: every `USE` counted, the scene holds more than 200000 shapes; what follows is left out "
            "[scene-limit]\n");
}

TEST(SceneLimits, StopsAtTheLimitOfNodes) {
  std::size_t shapes = 0;
  const std::string said = said_of_scene(tenfold(8, "Group { }"), shapes);
  EXPECT_EQ(shapes, 0U);
  EXPECT_NE(said.find("every `USE` counted, the scene holds more than 2000000 nodes; what follows is left out"),
            std::string::npos)
      << said;
}

/// Which is bound, events say: so each has its shapes, beside 199,111 of the world.
TEST(SceneLimits, CountsTheShapesOfBackgrounds) {
  std::string text = tenfold(5, "Shape { geometry Box { } }");
  for (int i = 0; i < 8; ++i) text += "USE L4 USE L3\n";
  text += "DEF Clock TimeSensor { loop TRUE }\n";
  for (int i = 0; i < 200; ++i)
    text += "DEF B" + std::to_string(i) +
            " Background { skyColor [ 1 0 0, 0 0 1 ] skyAngle 1 frontUrl \"a.png\" backUrl \"a.png\" leftUrl \"a.png\" "
            "rightUrl \"a.png\" topUrl \"a.png\" bottomUrl \"a.png\" }\n";
  std::size_t shapes = 0;
  const std::string said = said_of_scene(text + "ROUTE Clock.isActive TO B7.set_bind\n", shapes);
  EXPECT_GE(shapes, 200'000U);
  EXPECT_LT(shapes, 200'007U) << "the last one is whole";
  EXPECT_EQ(said,
            "scene.x3dv:144:10: error: every `USE` counted, the scene holds more than 200000 shapes; what follows is left out "
            "[scene-limit]\n");
}

}  // namespace
}  // namespace plugc
