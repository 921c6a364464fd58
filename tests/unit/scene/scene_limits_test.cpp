#include <gtest/gtest.h>

#include "base/script_limits.h"
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

/// Each instance of a prototype has its Script compiled: 100 of 90,000 characters.
TEST(SceneLimits, StopsAtTheLimitOfScripts) {
  std::string text = "PROTO P [] { Script { inputOnly SFFloat a url \"castlescript: function a(v, t) v";
  for (int i = 0; i < 22'500; ++i) text += " + v";
  text += "\" } }\n";
  for (int i = 0; i < 100; ++i) text += "P { } ";
  std::size_t shapes = 0;
  EXPECT_EQ(
      said_of_scene(text, shapes),
      "scene.x3dv:2:14: error: all Scripts together have more than 8000000 characters of code and numbers in their fields; "
      "those from this one on do not run [scene-limit]\n");
}

TEST(SceneLimits, CountsTheFirstValuesOfScripts) {
  std::string text = "PROTO P [] { Script { initializeOnly MFFloat n [";
  for (int i = 0; i < 200'000; ++i) text += " 1";
  text += "] inputOnly SFFloat a url \"castlescript: function a(v, t) v\" } }\n";
  for (int i = 0; i < 39; ++i) text += "P { } ";
  std::size_t shapes = 0;
  EXPECT_EQ(said_of_scene(text, shapes), "");
  EXPECT_NE(said_of_scene(text + "P { } P { }", shapes).find("[scene-limit]"), std::string::npos);
}

TEST(SceneLimits, RunsNoScriptOfTooManyFields) {
  std::string text = "Script { url \"castlescript: function f0(v, t) v\"";
  for (std::size_t i = 0; i < kMaxScriptFields; ++i) text += " inputOnly SFFloat f" + std::to_string(i);
  std::size_t shapes = 0;
  EXPECT_EQ(said_of_scene(text + " }", shapes), "");
  EXPECT_EQ(said_of_scene(text + " inputOnly SFFloat more }", shapes),
            "scene.x3dv:2:1: error: this Script has more than 1024 fields; it does not run [scene-limit]\n");
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
