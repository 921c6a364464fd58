#include "runtime/projection.h"

#include "degenerate_fits.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::box;
using test::kInfinity;
using test::kNan;
using test::SceneBuilder;

constexpr double kPi = std::numbers::pi;

glm::dvec3 in_texture(const View& light, const glm::dvec3& point) {
  const glm::dvec4 projected = world_to_texture(light) * glm::dvec4(point, 1);
  return glm::dvec3(projected) / projected.w;
}

LightFrame sun() {
  LightFrame light;
  light.direction = {0, -1, 0};
  light.up = {0, 0, -1};
  light.located = false;
  light.map_size = 1024;
  return light;
}

LightFrame lamp() {
  LightFrame light;
  light.kind = PackedLightKind::spot;
  light.location = {0, 10, 0};
  light.direction = {0, -1, 0};
  light.up = {0, 0, -1};
  light.angle = kPi / 2;
  light.map_size = 1024;
  return light;
}

void expect_finite(const View& view) {
  const glm::dmat4 all = world_to_texture(view);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      EXPECT_LE(std::abs(all[column][row]), 3e38);
      EXPECT_LE(std::abs(view.projection[column][row]), 3e38);
      EXPECT_LE(std::abs(view.world_to_eye[column][row]), 3e38);
    }
  }
}

TEST(Projection, FitsASunToWhatIsBothCastAndReceived) {
  // A wide ground that receives, a small tower that casts: the map spends its texels on the tower alone.
  const FitInput input{{box({-1, 0, -2}, {1, 5, 2})}, {box({-100, 0, -100}, {100, 0, 100})}};
  const View view = fit_light(sun(), input);
  EXPECT_NEAR(in_texture(view, {-1, 0, 0}).x, 0, 2e-3);
  EXPECT_NEAR(in_texture(view, {1, 0, 0}).x, 1, 2e-3);
  EXPECT_NEAR(in_texture(view, {0, 0, -2}).y, 1, 2e-3);
  EXPECT_GT(in_texture(view, {0, 5, 0}).z, 0);
  EXPECT_LT(in_texture(view, {0, 5, 0}).z, 0.02);
  EXPECT_LT(in_texture(view, {0, 0, 0}).z, 1);
  EXPECT_GT(in_texture(view, {0, 0, 0}).z, 0.98);
}

TEST(Projection, WastesNothingOnAGroundThatCastsToo) {
  const PlacedBox ground = box({-100, 0, -100}, {100, 0, 100});
  const PlacedBox tower = box({-1, 0, -2}, {1, 5, 2});
  EXPECT_NEAR(in_texture(fit_light(sun(), {{ground, tower}, {ground, tower}}), {1, 0, 0}).x, 1, 2e-3);
  // With something beneath it the ground is a caster like any other.
  const PlacedBox cellar = box({-50, -3, -50}, {50, -2, 50});
  EXPECT_NEAR(in_texture(fit_light(sun(), {{ground, tower}, {ground, tower, cellar}}), {100, 0, 0}).x, 1, 2e-3);
}

TEST(Projection, CutsDepthAtTheLastReceiver) {
  const FitInput input{{box({-1, -50, -1}, {1, 5, 1})}, {box({-9, 0, -9}, {9, 1, 9})}};
  EXPECT_NEAR(in_texture(fit_light(sun(), input), {0, 0, 0}).z, 1, 0.02);
}

TEST(Projection, CoversEverythingWhenAProgramMayMoveVertices) {
  FitInput input{{box({-1, 0, -2}, {1, 5, 2})}, {box({-100, 0, -100}, {100, 0, 100})}};
  input.casters[0].known = false;
  EXPECT_NEAR(in_texture(fit_light(sun(), input), {100, 0, 0}).x, 1, 2e-3);
}

TEST(Projection, SeesATurnedBoxThroughItsOwnSides) {
  // A cube turned by 45 degrees about the light: its world box is twice as large as its shadow along the light's axes.
  LightFrame light = sun();
  light.up = {1, 0, -1};
  const PlacedBox turned{{glm::dvec3(-1), glm::dvec3(1)}, rotation_matrix({0, 1, 0, -kPi / 4})};
  const View view = fit_light(light, {{turned}, {turned}});
  EXPECT_NEAR(in_texture(view, {std::sqrt(2.0), 0, 0}).x, 1, 2e-3);
}

TEST(Projection, KeepsAWrittenRectangleAndDistances) {
  LightFrame light = sun();
  light.location = {10, 20, 30};
  light.located = true;
  light.rectangle = {-2, -3, 4, 5};
  light.near = 1;
  light.far = 11;
  const View view = fit_light(light, {{box(glm::dvec3(-9), glm::dvec3(9))}, {box(glm::dvec3(-9), glm::dvec3(9))}});
  const glm::dvec3 corner = in_texture(view, {10 - 2, 20 - 1, 30 + 3});
  EXPECT_NEAR(corner.x, 0, 1e-9);
  EXPECT_NEAR(corner.y, 0, 1e-9);
  EXPECT_NEAR(corner.z, 0, 1e-9);
  const glm::dvec3 opposite = in_texture(view, {10 + 4, 20 - 11, 30 - 5});
  EXPECT_NEAR(opposite.x, 1, 1e-9);
  EXPECT_NEAR(opposite.y, 1, 1e-9);
  EXPECT_NEAR(opposite.z, 1, 1e-9);
}

TEST(Projection, FitsASpotsDistances) {
  const FitInput input{{box({-1, 4, -1}, {1, 6, 1})}, {box({-5, 0, -5}, {5, 1, 5})}};
  const View view = fit_light(lamp(), input);
  EXPECT_NEAR(in_texture(view, {0, 6, 0}).z, 0, 0.05);
  EXPECT_NEAR(in_texture(view, {0, 0, 0}).z, 1, 0.01);
  EXPECT_NEAR(in_texture(view, {10, 0, 0}).x, 1, 1e-9) << "45 degrees aside";
}

TEST(Projection, KeepsASpotsNearAboveAThousandthOfFar) {
  const FitInput input{{box({-1, 9, -1}, {1, 11, 1})}, {box({-5, 0, -5}, {5, 1, 5})}};  // around the light
  const View view = fit_light(lamp(), input);
  const double near = view.projection[3][2] / (view.projection[2][2] - 1);
  const double far = view.projection[3][2] / (view.projection[2][2] + 1);
  EXPECT_NEAR(near, far * 1e-3, 1e-9);
  EXPECT_NEAR(far, 10.1, 1e-6);
}

TEST(Projection, ClampsASpotThatWouldSeeHalfTheWorld) {
  LightFrame light = lamp();
  light.angle = kPi;  // twice the default cutOffAngle
  const View view = fit_light(light, {{}, {box({-5, 0, -5}, {5, 1, 5})}});
  EXPECT_NEAR(view.projection[0][0], 1 / std::tan(0.95 * kPi / 2), 1e-9);
}

/// The light of a scene with one map, as light_frame reads it.
struct OneLight {
  SceneBuilder builder;
  std::uint32_t light;
  explicit OneLight(PackedLightKind kind) : light(builder.add_light(kind, "Sun")) { builder.add_shadow_map(light, 64); }
  LightFrame frame(Messages& messages) {
    const LoadedPackage loaded = builder.pack();
    const PackedScene& scene = *loaded.package->scenes()->Get(0);
    const Slots slots(scene);
    return light_frame(scene, *scene.shadow_maps()->Get(0), slots, place(*loaded.package, scene, slots), messages);
  }
};

TEST(Projection, ReadsTheLightThroughItsTransform) {
  OneLight scene(PackedLightKind::spot);
  SceneBuilder& builder = scene.builder;
  const std::uint32_t scale = builder.vec3(2, 2, 2);
  builder.light(0).transform = builder.transform(-1, builder.vec3(1, 0, 0), builder.rotation(0, 1, 0, kPi / 2), scale);
  builder.light(0).location = builder.vec3(0, 3, 0);
  builder.light(0).cut_off_angle = builder.number(0.5);
  builder.shadow_map(0).near = builder.number(1);
  builder.shadow_map(0).far = builder.number(4);
  Messages messages;
  const LightFrame frame = scene.frame(messages);
  EXPECT_NEAR(glm::distance(frame.location, glm::dvec3(1, 6, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(glm::normalize(frame.direction), glm::dvec3(-1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(frame.near, 2, 1e-12);
  EXPECT_NEAR(frame.far, 8, 1e-12);
  EXPECT_NEAR(frame.angle, 1, 1e-12);
  EXPECT_TRUE(messages.list().empty());
}

TEST(Projection, ReportsWrongValuesAndComputesThemInstead) {
  OneLight scene(PackedLightKind::directional);
  scene.builder.shadow_map(0).near = scene.builder.number(5);
  scene.builder.shadow_map(0).far = scene.builder.number(5);
  scene.builder.shadow_map(0).rectangle = scene.builder.slot(PackedValueType::vec4, {1, -1, 1, 1});
  Messages messages;
  const LightFrame frame = scene.frame(messages);
  EXPECT_EQ(frame.near, 0);
  EXPECT_EQ(frame.far, 0);
  EXPECT_EQ(frame.rectangle, glm::dvec4(0));
  EXPECT_EQ(messages.list(),
            (std::vector<std::string>{
                "`projectionFar` of the light `Sun` is not behind `projectionNear`: both are computed instead",
                "`projectionRectangle` of the light `Sun` is empty (left, bottom, right, top): it is computed instead"}));
}

TEST(Projection, ReportsANegativeNear) {
  OneLight scene(PackedLightKind::spot);
  scene.builder.shadow_map(0).near = scene.builder.number(-1);
  Messages messages;
  EXPECT_EQ(scene.frame(messages).near, 0);
  EXPECT_EQ(messages.list(),
            (std::vector<std::string>{"`projectionNear` of the light `Sun` is no distance: it is computed instead"}));
}

TEST(Projection, MakesAnyUpOrthogonal) {
  for (const glm::dvec3& up : {glm::dvec3(0), glm::dvec3(0, -1, 0), glm::dvec3(0, 5, 0), glm::dvec3(1e-7, -1, 0),
                               glm::dvec3(0, -1, -1e-7), glm::dvec3(1, 1, 1), glm::dvec3(kNan), glm::dvec3(1e200, 0, 0)}) {
    const View view = look_along({1, 2, 3}, {0, -1, 0}, up);
    const glm::dmat3 axes(view.eye_to_world);
    EXPECT_NEAR(glm::determinant(axes), 1, 1e-12);
    EXPECT_NEAR(glm::dot(axes[1], glm::dvec3(0, -1, 0)), 0, 1e-12);
    EXPECT_NEAR(glm::distance(-axes[2], glm::dvec3(0, -1, 0)), 0, 1e-12);
  }
}

TEST(Projection, KeepsUpThatIsSlightlyAslant) {
  const View view = look_along({0, 0, 0}, {0, -1, 0}, {0, 1, -0.01});
  EXPECT_NEAR(glm::distance(glm::dvec3(view.eye_to_world[1]), glm::dvec3(0, 0, -1)), 0, 1e-12);
}

TEST(Projection, IsFiniteForDegenerateScenes) {
  std::vector<FitInput> inputs = test::degenerate_fit_inputs();
  inputs.push_back({{box({0, 0, 0}, {0, 0, 0})}, {}});
  inputs.push_back({{}, {box({0, 0, 0}, {0, 0, 0})}});
  inputs.push_back({{box({-1, 40, -1}, {1, 50, 1})}, {box({-1, 40, -1}, {1, 50, 1})}});  // all behind the lamp
  const std::vector<double> numbers = {0, 1e-300, 1, 1e300, kInfinity, kNan};
  for (LightFrame light : {sun(), lamp()}) {
    for (const FitInput& input : inputs) {
      for (const glm::dvec3& vector : test::degenerate_vectors()) {
        light.direction = vector;
        expect_finite(fit_light(light, input));
        light.location = vector;
        expect_finite(fit_light(light, input));
        for (const double number : numbers) {
          LightFrame odd = light;
          odd.near = odd.angle = number;
          expect_finite(fit_light(odd, input));
          odd.far = number;
          odd.rectangle = glm::dvec4(-number, -number, number, number);
          expect_finite(fit_light(odd, input));
        }
      }
    }
  }
}

}  // namespace
}  // namespace plugc
