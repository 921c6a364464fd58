// Random scenes: up to six objects under a sun and a spot light, anywhere, at any size, turned, squeezed and cut off, and one
// number in ten of the kind that nobody means. All are states of one package, so that code is generated once.
// PLUGC_RANDOM_SCENES says how many are drawn.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "stage.h"

namespace plugc {
namespace {

constexpr int kObjects = 6;
constexpr int kUsualCount = 400;

std::string field_list(const std::string& node, std::initializer_list<const char*> names, std::vector<std::string>& all) {
  for (const char* const name : names) all.push_back(node + "." + name);
  return node;
}

/// Kinds of geometry, each once: objects choose among them.
std::string geometries() {
  const char* const kinds[] = {
      "Box { solid FALSE }",
      "Sphere { solid FALSE }",
      "Cone { solid FALSE }",
      "Cylinder { solid FALSE }",
      "IndexedFaceSet { solid FALSE coordIndex [0 1 2 -1] coord Coordinate { point [-1 0 0, 1 0.3 0, 0 1 1] } }",
      "IndexedFaceSet { solid FALSE coordIndex [0 1 2 3 -1] coord Coordinate { point [-9 0 9, 9 0 9, 9 0 -9, -9 0 -9] } }",
      "IndexedFaceSet { solid FALSE coordIndex [0 1 2 3 -1] coord Coordinate { point [0 -2 -2, 0 2 -2, 0 2 2, 0 -2 2] } }",
      "IndexedFaceSet { solid FALSE coordIndex [0 1 2 -1] coord Coordinate { point [1 1 1, 1 1 1, 1 1 1] } }"};
  std::string text;
  for (const char* const kind : kinds)
    text += "Shape { appearance Appearance { material Material { ambientIntensity 0 } } geometry " + std::string(kind) + " }\n";
  return text;
}

std::string scene(std::vector<std::string>& fields) {
  std::string text =
      "#X3D V4.0 utf8\nPROFILE Full\nNavigationInfo { headlight FALSE }\nDEF Eye Viewpoint { position 0 3 12 }\n";
  field_list("Eye", {"position", "orientation", "fieldOfView"}, fields);
  const char* const map = "shadows TRUE defaultShadowMap GeneratedShadowMap { update \"ALWAYS\" size 64 }";
  text += "DEF Sun DirectionalLight { intensity 0.4 direction -0.3 -1 -0.2 " + std::string(map) + " }\n";
  field_list("Sun", {"direction", "up", "projectionNear", "projectionFar", "projectionRectangle", "projectionLocation"},
             fields);
  text += "DEF Spot SpotLight { intensity 0.4 location 3 8 3 direction -3 -8 -3 " + std::string(map) + " }\n";
  field_list("Spot",
             {"location", "direction", "cutOffAngle", "radius", "up", "projectionNear", "projectionFar", "projectionAngle"},
             fields);
  for (int i = 0; i < kObjects; ++i) {
    const std::string place = "Place" + std::to_string(i);
    const std::string choice = "Choice" + std::to_string(i);
    text += "DEF " + place + " Transform { children DEF " + choice + " Switch { whichChoice 0 children [\n" + geometries() +
            "] } }\n";
    field_list(place, {"translation", "rotation", "scale"}, fields);
    fields.push_back(choice + ".whichChoice");
  }
  return text;
}

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(engine_) == 1; }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }

  /// A number as authors write it, or one in ten times another.
  double number(double low, double high, bool may_be_odd) {
    constexpr double kOdd[] = {0,
                               -1,
                               1e-7,
                               1e-30,
                               1e6,
                               1e30,
                               -1e30,
                               1e300,
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()};
    if (may_be_odd && one_in(10)) return kOdd[below(std::size(kOdd))];
    return between(low, high);
  }
  std::vector<double> numbers(std::size_t count, double low, double high, bool may_be_odd) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(number(low, high, may_be_odd));
    return all;
  }

 private:
  std::mt19937 engine_;
};

void roll(Stage& stage, Chance& chance) {
  const bool odd = !chance.one_in(3);      // a third of the scenes is all ordinary
  const bool anywhere = chance.one_in(4);  // else it looks at the objects
  const bool odd_eye = odd && chance.one_in(4);
  stage.set("Eye.position", anywhere ? chance.numbers(3, -12, 12, odd_eye) : std::vector<double>{chance.between(-2, 2), 2, 12});
  stage.set("Eye.orientation",
            anywhere ? chance.numbers(4, -3, 3, odd_eye) : std::vector<double>{0, 0, 1, chance.between(-3, 3)});
  stage.set("Eye.fieldOfView", {chance.number(0.1, 2, odd && chance.one_in(4))});
  for (const std::string light : {"Sun", "Spot"}) {
    stage.set(light + ".direction", chance.numbers(3, -1, 1, odd));
    stage.set(light + ".up", chance.one_in(2) ? std::vector<double>{0, 0, 0} : chance.numbers(3, -1, 1, odd));
    const bool written = chance.one_in(3);
    stage.set(light + ".projectionNear", {written ? chance.number(0, 5, odd) : 0});
    stage.set(light + ".projectionFar", {written ? chance.number(0, 30, odd) : 0});
  }
  stage.set("Sun.projectionRectangle", chance.one_in(4) ? chance.numbers(4, -5, 5, odd) : std::vector<double>{0, 0, 0, 0});
  stage.set("Sun.projectionLocation", chance.one_in(4) ? chance.numbers(3, -5, 5, odd) : std::vector<double>{0, 0, 0});
  stage.set("Spot.location", chance.numbers(3, -10, 10, odd));
  stage.set("Spot.cutOffAngle", {chance.number(0.01, 1.6, odd)});
  stage.set("Spot.radius", {chance.number(0, 100, odd)});
  stage.set("Spot.projectionAngle", {chance.one_in(4) ? chance.number(0, 3.2, odd) : 0});
  for (int i = 0; i < kObjects; ++i) {
    const std::string place = "Place" + std::to_string(i);
    stage.set(place + ".translation", chance.numbers(3, -6, 6, odd));
    stage.set(place + ".rotation", chance.numbers(4, -3, 3, odd));
    stage.set(place + ".scale", chance.numbers(3, -0.5, 2, odd));
    stage.set("Choice" + std::to_string(i) + ".whichChoice", {static_cast<double>(chance.below(10) - 1)});
  }
}

int scene_count() {
  const char* const wanted = std::getenv("PLUGC_RANDOM_SCENES");
  return wanted != nullptr ? std::atoi(wanted) : kUsualCount;
}

TEST(ShadowStability, RandomScenesAreFinite) {
  std::vector<std::string> fields;
  const std::string text = scene(fields);
  Stage stage(text, fields, 32, true);
  int shadows = 0;
  for (int i = 0; i < scene_count(); ++i) {
    Chance chance(static_cast<unsigned>(i));
    roll(stage, chance);
    const FloatPicture picture = stage.draw();
    shadows += stage.statistics().shadow_passes > 0 ? 1 : 0;
    for (const float value : picture.values) {
      if (std::isfinite(value)) continue;
      ADD_FAILURE() << "scene " << i << ": a pixel is " << value;
      break;
    }
    if (testing::Test::HasFailure()) FAIL() << "scene " << i;
  }
  EXPECT_GT(shadows, scene_count() / 3);
}

}  // namespace
}  // namespace plugc
