#include "runtime/uniforms.h"

#include <ctime>
#include <limits>

#include "runtime/projection.h"
#include "runtime/tracer.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::SceneBuilder;

/// A scene, seen from a camera at 0,0,10 that looks along -z.
struct Seen {
  explicit Seen(const SceneBuilder& builder)
      : loaded(builder.pack()),
        scene(*loaded.package->scenes()->Get(0)),
        slots(scene),
        world(place(*loaded.package, scene, slots)),
        view(look_along({0, 0, 10}, {0, 0, -1}, {0, 1, 0})) {}

  std::vector<float> value(PackedSource source, PackedUniformType type, std::uint32_t a = 0, std::uint32_t b = 0,
                           float scale = 1, std::uint32_t count = 1) const {
    const UniformInputs inputs{scene, slots, world, view, shadow_views, nullptr, object_to_world};
    return evaluate(PackedBinding(0, a, b, scale, source), type, count, inputs);
  }

  LoadedPackage loaded;
  const PackedScene& scene;
  Slots slots;
  World world;
  View view;
  std::vector<View> shadow_views;
  glm::dmat4 object_to_world{1.0};
};

using Floats = std::vector<float>;

void expect_near(const Floats& actual, const Floats& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-6F) << i;
}

TEST(Uniforms, CopySlotsElementByElement) {
  SceneBuilder builder;
  const std::uint32_t pair = builder.slot(PackedValueType::vec3, {1, 2, 3, 4, 5, 6});
  const std::uint32_t half = builder.number(0.5);
  const Seen seen(builder);
  expect_near(seen.value(PackedSource::slot, PackedUniformType::vec3, pair), {1, 2, 3});
  expect_near(seen.value(PackedSource::slot, PackedUniformType::vec3, pair, 0, 1, 3), {1, 2, 3, 4, 5, 6, 0, 0, 0});
  expect_near(seen.value(PackedSource::slot, PackedUniformType::vec2, pair, 0, 1, 2), {1, 2, 4, 5});
  expect_near(seen.value(PackedSource::slot, PackedUniformType::vec4, pair, 0, 1, 2), {1, 2, 3, 0, 4, 5, 6, 0});
  expect_near(seen.value(PackedSource::slot_scaled, PackedUniformType::vec3, pair, 0, 2), {2, 4, 6});
  expect_near(seen.value(PackedSource::slot_product, PackedUniformType::vec3, pair, half), {0.5, 1, 1.5});
}

/// A draw costs what its uniforms take, not what the slots hold that it names.
TEST(Uniforms, LeaveTheRestOfALongSlotAlone) {
  SceneBuilder builder;
  const std::uint32_t list = builder.slot(PackedValueType::float_, std::vector<double>(2'000'000, 0.5));
  const Seen seen(builder);
  const std::clock_t start = std::clock();
  for (int i = 0; i < 5000; ++i) seen.value(PackedSource::slot, PackedUniformType::float_, list);
  EXPECT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC);
}

TEST(Uniforms, TurnTransparencyIntoAlpha) {
  SceneBuilder builder;
  const std::uint32_t color = builder.vec3(0.1, 0.2, 0.3);
  const std::uint32_t transparency = builder.number(0.25);
  const Seen seen(builder);
  expect_near(seen.value(PackedSource::color_and_transparency, PackedUniformType::vec4, color, transparency),
              {0.1F, 0.2F, 0.3F, 0.75F});
}

TEST(Uniforms, AreFiniteWhateverASlotHolds) {
  SceneBuilder builder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::uint32_t odd = builder.vec3(nan, 1e300, -std::numeric_limits<double>::infinity());
  const float largest = std::numeric_limits<float>::max();
  EXPECT_EQ(Seen(builder).value(PackedSource::slot, PackedUniformType::vec3, odd), (Floats{0, largest, -largest}));
}

TEST(Uniforms, PutLightsIntoEyeSpace) {
  SceneBuilder builder;
  const std::uint32_t spot = builder.add_light(PackedLightKind::spot, "Lamp");
  builder.light(spot).transform = builder.transform(-1, builder.vec3(1, 2, 3), kNoSlot, builder.vec3(2, 2, 5));
  builder.light(spot).location = builder.vec3(1, 0, 0);
  builder.light(spot).direction = builder.vec3(0, -3, 0);
  builder.light(spot).cut_off_angle = builder.number(0.5);
  builder.light(spot).beam_width = builder.number(0.25);
  builder.light(spot).radius = builder.number(10);
  builder.light(spot).attenuation = builder.vec3(1, 0.5, 0.25);
  const std::uint32_t sun = builder.add_light(PackedLightKind::directional, "Sun");
  builder.light(sun).direction = builder.vec3(0, 0, -2);
  const Seen seen(builder);
  expect_near(seen.value(PackedSource::light_position, PackedUniformType::vec4, spot), {3, 2, -7, 1});
  expect_near(seen.value(PackedSource::light_position, PackedUniformType::vec4, sun), {0, 0, 1, 0});
  expect_near(seen.value(PackedSource::light_spot_direction, PackedUniformType::vec3, spot), {0, -1, 0});
  expect_near(seen.value(PackedSource::light_spot_cos_cutoff, PackedUniformType::float_, spot), {std::cos(0.5F)});
  expect_near(seen.value(PackedSource::light_spot_cutoff, PackedUniformType::float_, spot), {0.5F});
  expect_near(seen.value(PackedSource::light_beam_width, PackedUniformType::float_, spot), {0.25F});
  expect_near(seen.value(PackedSource::light_radius, PackedUniformType::float_, spot), {30});
  expect_near(seen.value(PackedSource::light_attenuation, PackedUniformType::vec3, spot), {1, 0.5F, 0.25F});
}

/// As its shadow map and its rays have it: no camera turns it.
TEST(Uniforms, ALightWithoutADirectionShinesAlongMinusZOfTheWorld) {
  SceneBuilder builder;
  const std::uint32_t sun = builder.add_light(PackedLightKind::directional, "Sun");
  builder.light(sun).direction = builder.vec3(0, 0, 0);
  builder.add_shadow_map(sun, 16);
  Seen seen(builder);
  seen.view = look_along({5, 6, 7}, {1, 0, 0}, {0, 1, 0});
  expect_near(seen.value(PackedSource::light_position, PackedUniformType::vec4, sun), {1, 0, 0, 0});
  expect_near(seen.value(PackedSource::light_spot_direction, PackedUniformType::vec3, sun), {-1, 0, 0});
  const PackedShadowMap& map = *seen.scene.shadow_maps()->Get(0);
  EXPECT_EQ(light_source(seen.scene, map, seen.slots, seen.world).towards, glm::dvec3(0, 0, 1));
}

TEST(Uniforms, HangHeadlightsOnTheCamera) {
  SceneBuilder builder;
  builder.light(builder.add_light(PackedLightKind::directional, "Headlight")).headlight = true;
  Seen seen(builder);
  seen.view = look_along({5, 6, 7}, {1, 0, 0}, {0, 0, 1});
  expect_near(seen.value(PackedSource::light_position, PackedUniformType::vec4), {0, 0, 1, 0});
}

TEST(Uniforms, BlackenLightsThatAreOffOrHidden) {
  SceneBuilder builder;
  const std::uint32_t on = builder.add_light(PackedLightKind::point, "On");
  builder.light(on).color = builder.vec3(0.5, 1, 0);
  builder.light(on).intensity = builder.number(0.5);
  builder.light(on).ambient_intensity = builder.number(0.1);
  const std::uint32_t off = builder.add_light(PackedLightKind::point, "Off");
  builder.light(off).on = builder.slot(PackedValueType::bool_, {0});
  const std::uint32_t hidden = builder.add_light(PackedLightKind::point, "Hidden");
  builder.light(hidden).transform = builder.switch_child(-1, builder.slot(PackedValueType::int_, {-1}), 0);
  const Seen seen(builder);
  expect_near(seen.value(PackedSource::light_color, PackedUniformType::vec3, on), {0.25F, 0.5F, 0});
  expect_near(seen.value(PackedSource::light_ambient_color, PackedUniformType::vec3, on), {0.05F, 0.1F, 0});
  expect_near(seen.value(PackedSource::light_color, PackedUniformType::vec3, off), {0, 0, 0});
  expect_near(seen.value(PackedSource::light_color, PackedUniformType::vec3, hidden), {0, 0, 0});
}

TEST(Uniforms, TransformTextureCoordinatesInTheOrderOfTheSpecification) {
  SceneBuilder builder;
  const auto vec2 = [&builder](double x, double y) { return builder.slot(PackedValueType::vec2, {x, y}); };
  builder.scene().texture_transforms.emplace_back(vec2(0.5, 0), builder.number(std::numbers::pi / 2), vec2(2, 3), vec2(1, 0));
  const Floats m = Seen(builder).value(PackedSource::texture_matrix, PackedUniformType::mat4);
  // 0,0: translated 0.5,0; plus center 1.5,0; rotated 0,1.5; scaled 0,4.5; minus center -1,4.5.
  expect_near({m[12], m[13], m[14], m[15]}, {-1, 4.5F, 0, 1});
  // 1,0 moves on by 0,1 rotated and 0,3 scaled.
  expect_near({m[0], m[1]}, {0, 3});
}

TEST(Uniforms, GiveTheUpperLeftOfAMatrixToASmallerOne) {
  Seen seen{SceneBuilder()};
  seen.object_to_world = transform_matrix({7, 8, 9}, {0, 0, 1, 0}, {2, 3, 4}, {0, 0, 1, 0}, {0, 0, 0});
  expect_near(seen.value(PackedSource::model_view_matrix, PackedUniformType::mat3), {2, 0, 0, 0, 3, 0, 0, 0, 4});
  expect_near(seen.value(PackedSource::normal_matrix, PackedUniformType::mat3), {0.5F, 0, 0, 0, 1 / 3.0F, 0, 0, 0, 0.25F});
}

TEST(Uniforms, KeepNormalsOfAFlattenedShape) {
  const glm::dmat4 flattened = transform_matrix({0, 0, 0}, {0, 0, 1, 0}, {2, 3, 0}, {0, 0, 1, 0}, {0, 0, 0});
  const glm::dmat3 matrix = normal_matrix(flattened);
  EXPECT_EQ(glm::normalize(matrix * glm::dvec3(0, 0.6, 0.8)), glm::dvec3(0, 0, 1));
}

TEST(Uniforms, LeadFromTheEyeToTheShadowMap) {
  SceneBuilder builder;
  const std::uint32_t light = builder.add_light(PackedLightKind::directional, "Sun");
  builder.add_shadow_map(light, 16);
  Seen seen(builder);
  View map = look_along({0, 0, 4}, {0, 0, -1}, {0, 1, 0});
  map.projection = glm::dmat4(0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, -0.25, 0, 0, 0, -1, 1);  // 4 wide and high, 0 to 8 deep
  seen.shadow_views = {map};
  const Floats m = seen.value(PackedSource::projector_matrix, PackedUniformType::mat4);
  const auto at = [&m](float x, float y, float z) {
    return Floats{m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13],
                  m[2] * x + m[6] * y + m[10] * z + m[14], m[3] * x + m[7] * y + m[11] * z + m[15]};
  };
  expect_near(at(-2, -2, -6), {0, 0, 0, 1});  // the eye is at 10, the light at 4
  expect_near(at(2, 2, -14), {1, 1, 1, 1});
  expect_near(at(0, 1, -10), {0.5F, 0.75F, 0.5F, 1});
}

}  // namespace
}  // namespace plugc
