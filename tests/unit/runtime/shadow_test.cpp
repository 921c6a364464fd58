// Scenes that all look from +z at a white receiver in the plane z = 0, 8 by 8, drawn at 8 pixels a unit, and a caster
// above it. What the picture shows is the map's verdict alone: white lit, black shadow.

#include <limits>

#include "runtime/gl/context.h"
#include "runtime/gl/functions.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::kBlack;
using test::kWhite;
using test::make_renderer;
using test::pixel;
using test::Rgb;
using test::SceneBuilder;

constexpr std::uint32_t kSide = 64;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

FrameOptions frame() {
  FrameOptions options;
  options.width = options.height = kSide;
  return options;
}

/// The pixel that shows x, y of the plane.
Rgb at(const Picture& picture, double x, double y) {
  return pixel(picture, static_cast<std::uint32_t>((x + 4) * 8), static_cast<std::uint32_t>((y + 4) * 8));
}

struct ShadowScene {
  SceneBuilder builder;
  std::uint32_t light;
  std::uint32_t map;
  std::uint32_t receiver;
  std::uint32_t caster;
  std::uint32_t caster_place;  ///< Slot: where its centre is.

  ShadowScene(PackedLightKind kind, std::uint32_t size) : light(builder.add_light(kind, "Lamp")) {
    map = builder.add_shadow_map(light, size);
    const std::uint32_t depth = builder.depth_program();
    receiver = builder.shadowed_shape(builder.square(4), builder.shadow_program(), map);
    caster_place = builder.vec3(0, 0, 2);
    // The caster is seen from the camera too, so it is drawn by no colour: a program that discards.
    const std::uint32_t unseen = builder.program(
        "#version 330 core\n"
        "in vec3 castle_Vertex;\n"
        "void main() { gl_Position = vec4(castle_Vertex, 1.0); }\n",
        "#version 330 core\n"
        "out vec4 castle_FragColor;\n"
        "void main() { discard; }\n",
        {{"to_clip", PackedUniformType::mat4}, {"color", PackedUniformType::vec4}});
    caster = builder.flat_shape(builder.square(1), unseen, {0, 0, 0, 1}, builder.transform(-1, caster_place));
    builder.make_caster(caster, depth);
    builder.orthographic_view(4);
  }
};

TEST(Shadow, OfASunFallsBesideTheCaster) {
  // Light along 1,0,-1: the square over -1..1 at height 2 shades x from 1 to 3 and y from -1 to 1.
  ShadowScene scene(PackedLightKind::directional, 256);
  scene.builder.light(0).direction = scene.builder.vec3(1, 0, -1);
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  const Picture picture = renderer->draw(frame());
  EXPECT_EQ(at(picture, 2, 0), kBlack);
  EXPECT_EQ(at(picture, 1.2, -0.8), kBlack);
  EXPECT_EQ(at(picture, 2.8, 0.8), kBlack);
  EXPECT_EQ(at(picture, 0.7, 0), kWhite);
  EXPECT_EQ(at(picture, 3.3, 0), kWhite);
  EXPECT_EQ(at(picture, 2, 1.2), kWhite);
  EXPECT_EQ(at(picture, 2, -1.2), kWhite);
  EXPECT_EQ(at(picture, -3.9, -3.9), kWhite);
  EXPECT_TRUE(renderer->messages().empty());
  EXPECT_EQ(renderer->statistics().shadow_passes, 1U);
  EXPECT_EQ(renderer->statistics().shadow_draw_calls, 1U);
  EXPECT_EQ(renderer->statistics().draw_calls, 2U);
  EXPECT_EQ(renderer->statistics().programs_used, 3U);
}

TEST(Shadow, OfASpotGrowsWithDistance) {
  // A light at height 4 over the origin, the square halfway: its shadow is twice as large, -2..2.
  ShadowScene scene(PackedLightKind::spot, 512);
  scene.builder.light(0).location = scene.builder.vec3(0, 0, 4);
  scene.builder.light(0).direction = scene.builder.vec3(0, 0, -1);
  scene.builder.light(0).cut_off_angle = scene.builder.number(0.8);
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  const Picture picture = renderer->draw(frame());
  for (const double edge : {-1.8, 1.8}) {
    EXPECT_EQ(at(picture, edge, 0), kBlack);
    EXPECT_EQ(at(picture, 0, edge), kBlack);
    EXPECT_EQ(at(picture, edge * 1.25, 0), kWhite);
    EXPECT_EQ(at(picture, 0, edge * 1.25), kWhite);
  }
  EXPECT_EQ(at(picture, 3.9, 3.9), kWhite) << "outside of the map";
  EXPECT_TRUE(renderer->messages().empty());
}

TEST(Shadow, OfASpotWithoutACutOffAngleIsFinite) {
  // X3D's default of 90 degrees would need a map of 180: it is narrowed.
  ShadowScene scene(PackedLightKind::spot, 1024);
  scene.builder.light(0).location = scene.builder.vec3(0, 0, 4);
  const LoadedPackage loaded = scene.builder.pack();
  const Picture picture = make_renderer(loaded)->draw(frame());
  EXPECT_EQ(at(picture, 0, 0), kBlack);
  EXPECT_EQ(at(picture, 3, 3), kWhite);
}

TEST(Shadow, EdgeIsFilteredOverTwoTexelsByTheHardware) {
  // A map of 8 texels on 8 units: texel centres at half units. The caster covers the columns -1..0 and 0..1, so over the
  // texel from centre -1.5 (lit) to centre -0.5 (shadow) the share of light falls linearly.
  ShadowScene scene(PackedLightKind::directional, 8);
  scene.builder.shadow_map(0).rectangle = scene.builder.slot(PackedValueType::vec4, {-4, -4, 4, 4});
  scene.builder.shadow_map(0).location = scene.builder.vec3(0, 0, 5);
  const LoadedPackage loaded = scene.builder.pack();
  const Picture picture = make_renderer(loaded)->draw(frame());
  const std::uint32_t row = kSide / 2;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const double share = 1 - (i + 0.5) / 8;  // pixel i of the eight between the two texel centres
    EXPECT_NEAR(pixel(picture, 20 + i, row)[0], share * 255, 2) << i;
  }
  EXPECT_EQ(pixel(picture, 19, row), kWhite);
  EXPECT_EQ(pixel(picture, 28, row), kBlack);
}

TEST(Shadow, IsCastFromBeforeTheNearPlane) {
  ShadowScene scene(PackedLightKind::directional, 64);
  scene.builder.shadow_map(0).rectangle = scene.builder.slot(PackedValueType::vec4, {-4, -4, 4, 4});
  scene.builder.shadow_map(0).location = scene.builder.vec3(0, 0, 5);
  scene.builder.shadow_map(0).near = scene.builder.number(4);  // the caster is at 3
  scene.builder.shadow_map(0).far = scene.builder.number(6);
  const LoadedPackage loaded = scene.builder.pack();
  EXPECT_EQ(at(make_renderer(loaded)->draw(frame()), 0, 0), kBlack);
}

TEST(Shadow, IsTheSameWhicheverWayItsDepthsAreStored) {
  for (const PackedLightKind kind : {PackedLightKind::directional, PackedLightKind::spot}) {
    std::vector<Picture> pictures;
    for (const bool author_visible : {false, true}) {
      ShadowScene scene(kind, 256);
      scene.builder.light(0).location = scene.builder.vec3(1, 0, 5);
      scene.builder.light(0).direction = scene.builder.vec3(0.1, 0.2, -1);
      scene.builder.light(0).cut_off_angle = scene.builder.number(0.7);
      scene.builder.shadow_map(0).author_visible = author_visible;
      const LoadedPackage loaded = scene.builder.pack();
      pictures.push_back(make_renderer(loaded)->draw(frame()));
    }
    EXPECT_EQ(at(pictures[0], 0, 0), kBlack);
    EXPECT_EQ(at(pictures[0], -3, -3), kWhite);
    int unlike = 0;
    for (std::size_t i = 0; i < pictures[0].pixels.size(); i += 4)
      unlike += std::abs(pictures[0].pixels[i] - pictures[1].pixels[i]) > 64 ? 1 : 0;
    EXPECT_LE(unlike, 24) << "they are fitted apart, so edges differ by parts of a texel";
  }
}

TEST(Shadow, FollowsItsCasterAndIsDrawnOnlyWhenSomethingChanged) {
  ShadowScene scene(PackedLightKind::directional, 128);
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kBlack);
  EXPECT_EQ(renderer->statistics().shadow_passes, 1U);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kBlack);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
  renderer->set_slot(scene.caster_place, {2, 0, 2});
  const Picture moved = renderer->draw(frame());
  EXPECT_EQ(renderer->statistics().shadow_passes, 1U);
  EXPECT_EQ(at(moved, 0, 0), kWhite);
  EXPECT_EQ(at(moved, 2, 0), kBlack);
}

TEST(Shadow, CostsAPassOnlyWhenItWouldComeOutOtherwise) {
  ShadowScene scene(PackedLightKind::directional, 128);
  SceneBuilder& builder = scene.builder;
  const std::uint32_t direction = builder.light(0).direction = builder.vec3(0, 0, -1);
  const std::uint32_t color = builder.light(0).color = builder.vec3(1, 1, 1);
  const std::uint32_t on = builder.light(0).on = builder.slot(PackedValueType::bool_, {1});
  builder.shape(scene.receiver).transform = builder.transform(-1, builder.vec3(0, 0, 0));
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  const auto passes_after = [&](std::uint32_t slot, const std::vector<double>& values) {
    renderer->set_slot(slot, values);
    renderer->draw(frame());
    return renderer->statistics().shadow_passes;
  };
  EXPECT_EQ(passes_after(direction, {0, 0, -1}), 1U);
  EXPECT_EQ(passes_after(color, {1, 0, 0}), 0U) << "no caster sees the light's colour";
  EXPECT_EQ(passes_after(direction, {0.1, 0, -1}), 1U);
  EXPECT_EQ(passes_after(on, {0}), 0U);
  EXPECT_EQ(passes_after(direction, {0.2, 0, -1}), 0U) << "the light is off";
  EXPECT_EQ(passes_after(on, {1}), 1U);
  EXPECT_EQ(passes_after(scene.caster_place, {0, 0, -2}), 0U) << "the caster lies behind all that receives";
  EXPECT_EQ(passes_after(scene.caster_place, {0, 0, 2}), 0U) << "the map that was drawn for this is still there";
}

TEST(Shadow, DrawnOnceStaysWhereItWas) {
  ShadowScene scene(PackedLightKind::directional, 128);
  scene.builder.shadow_map(0).update = PackedShadowUpdate::next_frame_only;
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kBlack);
  renderer->set_slot(scene.caster_place, {2, 0, 2});
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kBlack);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
}

TEST(Shadow, WithUpdateNoneCostsNothingAndShadowsNothing) {
  ShadowScene scene(PackedLightKind::directional, 128);
  scene.builder.shadow_map(0).update = PackedShadowUpdate::none;
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kWhite);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
  EXPECT_EQ(renderer->statistics().shadow_draw_calls, 0U);
}

TEST(Shadow, CanBeSwitchedOffForAFrame) {
  ShadowScene scene(PackedLightKind::directional, 128);
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  FrameOptions lit = frame();
  lit.shadows = false;
  EXPECT_EQ(at(renderer->draw(lit), 0, 0), kWhite);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kBlack);
  EXPECT_EQ(at(renderer->draw(lit), 0, 0), kWhite);
}

TEST(Shadow, NeedsACasterAndAReceiver) {
  ShadowScene alone(PackedLightKind::directional, 64);
  alone.builder.shape(alone.caster).depth_program = -1;
  alone.builder.shape(alone.caster).depth_bindings.clear();
  const LoadedPackage no_caster = alone.builder.pack();
  auto renderer = make_renderer(no_caster);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kWhite);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);

  ShadowScene unseen(PackedLightKind::directional, 64);
  unseen.builder.shape(unseen.receiver).transform =
      unseen.builder.switch_child(-1, unseen.builder.slot(PackedValueType::int_, {-1}), 0);
  const LoadedPackage no_receiver = unseen.builder.pack();
  renderer = make_renderer(no_receiver);
  renderer->draw(frame());
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
}

TEST(Shadow, OfAPointLightIsNotCastByShapesThatHaveNoProgramForIt) {
  ShadowScene scene(PackedLightKind::point, 64);
  const LoadedPackage loaded = scene.builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kWhite);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
}

TEST(Shadow, TakesOddMapSizes) {
  for (const std::uint32_t size : {1U, 17U}) {
    ShadowScene scene(PackedLightKind::directional, size);
    const LoadedPackage loaded = scene.builder.pack();
    const auto renderer = make_renderer(loaded);
    // The one texel of the smallest map fades towards the lit border.
    EXPECT_LT(at(renderer->draw(frame()), 0, 0)[0], 32) << size;
    EXPECT_TRUE(renderer->messages().empty());
  }
}

TEST(Shadow, SurvivesDegenerateScenes) {
  using Change = void (*)(ShadowScene&);
  const auto move_caster = [](ShadowScene& scene, double x, double y, double z, double scale) {
    scene.builder.shape(scene.caster).transform =
        scene.builder.transform(-1, scene.builder.vec3(x, y, z), kNoSlot, scene.builder.vec3(scale, scale, scale));
  };
  static const auto move = move_caster;
  const std::vector<Change> changes = {
      [](ShadowScene& s) { s.builder.light(0).direction = s.builder.vec3(0, 0, 0); },
      [](ShadowScene& s) { s.builder.light(0).direction = s.builder.vec3(kNan, 0, 1e300); },
      [](ShadowScene& s) { s.builder.light(0).direction = s.builder.vec3(1, 0, 0); },  // along the receiver
      [](ShadowScene& s) { s.builder.light(0).location = s.builder.vec3(0, 0, 2); },   // inside the caster
      [](ShadowScene& s) { s.builder.light(0).location = s.builder.vec3(1e30, kNan, 0); },
      [](ShadowScene& s) { s.builder.shadow_map(0).up = s.builder.vec3(0, 0, -1); },  // parallel to the direction
      [](ShadowScene& s) { s.builder.shadow_map(0).up = s.builder.vec3(1e-7, 0, 1); },
      [](ShadowScene& s) {
        s.builder.shadow_map(0).near = s.builder.number(9);
        s.builder.shadow_map(0).far = s.builder.number(3);
      },
      [](ShadowScene& s) {
        s.builder.shadow_map(0).scale = s.builder.number(kNan);
        s.builder.shadow_map(0).bias = s.builder.number(1e30);
      },
      [](ShadowScene& s) { s.builder.shadow_map(0).angle = s.builder.number(400); },
      [](ShadowScene& s) { move(s, 0, 0, 2, 0); },
      [](ShadowScene& s) { move(s, 0, 0, 2, -1); },
      [](ShadowScene& s) { move(s, 0, 0, 1e30, 1); },
      [](ShadowScene& s) { move(s, 0, 0, 2, 1e30); },
      [](ShadowScene& s) { move(s, kNan, 0, 2, 1); },
      [](ShadowScene& s) { s.builder.light(0).transform = s.builder.transform(-1, kNoSlot, kNoSlot, s.builder.vec3(0, 0, 0)); },
      [](ShadowScene& s) {
        s.builder.light(0).transform = s.builder.transform(-1, kNoSlot, kNoSlot, s.builder.vec3(kNan, 1, 1));
      },
      [](ShadowScene& s) { s.builder.shape(s.receiver).mesh = s.builder.mesh({}); },
      [](ShadowScene& s) { s.builder.shape(s.caster).mesh = s.builder.mesh({}); },
      [](ShadowScene& s) {
        s.builder.shape(s.caster).mesh = s.builder.mesh({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
      },
      [](ShadowScene& s) { s.builder.shape(s.caster).bounds_known = false; },
  };
  for (const PackedLightKind kind : {PackedLightKind::directional, PackedLightKind::spot}) {
    for (std::size_t i = 0; i < changes.size(); ++i) {
      ShadowScene scene(kind, 32);
      changes[i](scene);
      const LoadedPackage loaded = scene.builder.pack();
      const auto renderer = make_renderer(loaded);
      EXPECT_EQ(renderer->draw(frame()).pixels.size(), std::size_t{kSide} * kSide * 4);
      for (const std::string& message : renderer->messages())
        EXPECT_EQ(message.find("OpenGL"), std::string::npos) << i << message;
    }
  }
}

TEST(Context, ComesFromEglToo) {
  // The same pictures are drawn through either; here only that the second way leads to a context.
  std::string error;
  const std::unique_ptr<gl::Context> context = gl::make_egl_context(error);
  ASSERT_NE(context, nullptr) << error;
  ASSERT_TRUE(context->make_current());
  gl::Functions functions;
  EXPECT_TRUE(gl::load_functions(*context, functions, error)) << error;
  EXPECT_GE(functions.GetError(), 0U);
}

/// The caster is moved by a texture that the scene draws: nothing but its content changes.
TEST(Shadow, FollowsWhatIsDrawnIntoATextureThatMovesItsCaster) {
  ShadowScene scene(PackedLightKind::directional, 64);
  SceneBuilder& builder = scene.builder;
  const std::uint32_t waves = builder.own_scene_texture(4);
  const std::uint32_t water = builder.flat_shape(builder.square(1), builder.flat_program(), {0, 0, 0, 1});
  builder.shape(water).own_scene_of = static_cast<std::int32_t>(waves);
  const std::uint32_t color = builder.shape(water).bindings[1].a();
  builder.shape(scene.caster).depth_program = static_cast<std::int32_t>(
      builder.program("#version 330 core\n"
                      "in vec3 castle_Vertex;\n"
                      "uniform mat4 to_clip;\n"
                      "uniform sampler2D waves;\n"
                      "void main() {\n"
                      "  vec3 moved = castle_Vertex + vec3(2.0 * textureLod(waves, vec2(0.5), 0.0).r, 0.0, 0.0);\n"
                      "  gl_Position = to_clip * vec4(moved, 1.0);\n"
                      "}\n",
                      "#version 330 core\n"
                      "void main() {}\n",
                      {{"to_clip", PackedUniformType::mat4}, {"waves", PackedUniformType::sampler2D}}));
  builder.shape(scene.caster).depth_bindings.emplace_back(1, waves, 0, 1.0F, PackedSource::rendered_texture);
  SceneBuilder::add_uniform(*builder.package.programs[builder.shape(scene.caster).program],
                            {"waves", PackedUniformType::sampler2D});
  builder.shape(scene.caster).bindings.emplace_back(2, waves, 0, 1.0F, PackedSource::rendered_texture);
  builder.shape(scene.caster).bounds_known = false;
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  Picture picture = renderer->draw(frame());
  EXPECT_EQ(at(picture, 0, 0), kBlack);
  EXPECT_EQ(at(picture, 2.5, 0), kWhite);
  renderer->set_slot(color, {1, 0, 0, 1});
  picture = renderer->draw(frame());
  EXPECT_EQ(at(picture, 0, 0), kWhite);
  EXPECT_EQ(at(picture, 2.5, 0), kBlack);
  EXPECT_TRUE(renderer->messages().empty());
}

/// What was never made of its depths is not read.
TEST(Shadow, IsNoneWhereTheDriverRejectsWhatMakesMoments) {
  ShadowScene scene(PackedLightKind::directional, 64);
  SceneBuilder& builder = scene.builder;
  PackedShadowMapT& map = builder.shadow_map(scene.map);
  map.method = PackedShadowMethod::vsm;
  map.moments_program = static_cast<std::int32_t>(builder.program("no shader", "no shader", {}));
  map.blur_program = map.moments_program;
  builder.shape(scene.receiver).program = builder.program(
      "#version 330 core\n"
      "in vec3 castle_Vertex;\n"
      "uniform mat4 to_eye, projection;\n"
      "void main() { gl_Position = projection * to_eye * vec4(castle_Vertex, 1.0); }\n",
      "#version 330 core\n"
      "uniform sampler2D moments;\n"
      "out vec4 castle_FragColor;\n"
      "void main() { castle_FragColor = texture(moments, vec2(0.5)); }\n",
      {{"to_eye", PackedUniformType::mat4},
       {"projection", PackedUniformType::mat4},
       {"unused", PackedUniformType::mat4},
       {"moments", PackedUniformType::sampler2D}});
  builder.shape(scene.receiver).bindings[3] = PackedBinding(3, scene.map, 0, 1, PackedSource::shadow_moments);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(at(renderer->draw(frame()), 0, 0), kWhite) << "frame " << i;
}

}  // namespace
}  // namespace plugc
