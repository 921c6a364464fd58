#include "runtime/render.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "test_scene.h"

namespace plugc {
namespace {

using test::kBlack;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::kWhite;
using test::make_renderer;
using test::pixel;
using test::Rgb;
using test::SceneBuilder;

FrameOptions small(std::uint32_t width = 16, std::uint32_t height = 16) {
  FrameOptions options;
  options.width = width;
  options.height = height;
  return options;
}

TEST(Render, DrawsALitTriangleInItsExactColours) {
  // Lambert: light 0.4,1,0.3 from 60 degrees beside the normal -> half of it, plus the ambient 0.2.
  SceneBuilder builder;
  const std::uint32_t lit = builder.program(
      "#version 330 core\n"
      "in vec3 castle_Vertex;\n"
      "in vec3 castle_Normal;\n"
      "uniform mat4 to_clip;\n"
      "uniform mat3 normal_matrix;\n"
      "out vec3 normal;\n"
      "void main() { normal = normal_matrix * castle_Normal; gl_Position = to_clip * vec4(castle_Vertex, 1.0); }\n",
      "#version 330 core\n"
      "in vec3 normal;\n"
      "uniform vec3 towards, color, ambient;\n"
      "out vec4 castle_FragColor;\n"
      "void main() { castle_FragColor = vec4(color * dot(normalize(normal), towards) + ambient, 1.0); }\n",
      {{"to_clip", PackedUniformType::mat4},
       {"normal_matrix", PackedUniformType::mat3},
       {"towards", PackedUniformType::vec3},
       {"color", PackedUniformType::vec3},
       {"ambient", PackedUniformType::vec3}});
  builder.package.programs[lit]->attributes.push_back(std::make_unique<PackedAttributeT>());
  builder.package.programs[lit]->attributes[1]->name = "castle_Normal";
  builder.package.programs[lit]->attributes[1]->semantic = PackedSemantic::normal;
  const std::uint32_t light = builder.add_light(PackedLightKind::directional, "Sun");
  builder.light(light).direction = builder.vec3(std::sqrt(3.0), 0, -1);
  builder.light(light).color = builder.vec3(0.4, 1, 0.3);
  builder.light(light).intensity = builder.number(0.8);
  builder.light(light).ambient_intensity = builder.number(0.2);
  builder.scene().shapes.push_back(std::make_unique<PackedShapeT>());
  PackedShapeT& shape = builder.shape(0);
  shape.mesh = builder.mesh({{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}});  // no normals: 0 0 1
  shape.program = lit;
  shape.bindings = {{0, 0, 0, 1, PackedSource::model_view_projection_matrix},
                    {1, 0, 0, 1, PackedSource::normal_matrix},
                    {2, light, 0, 1, PackedSource::light_position},
                    {3, light, 0, 1, PackedSource::light_color},
                    {4, light, 0, 1, PackedSource::light_ambient_color}};
  builder.orthographic_view(1);
  builder.scene().background_color = builder.vec3(0, 0, 1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  const Picture picture = renderer->draw(small());
  EXPECT_EQ(pixel(picture, 2, 2), (Rgb{61, 153, 46}));  // (0.4, 1, 0.3) * (0.8 * 0.5 + 0.2)
  EXPECT_EQ(pixel(picture, 13, 13), kBlue);
  EXPECT_EQ(pixel(picture, 7, 7), (Rgb{61, 153, 46}));
  EXPECT_EQ(pixel(picture, 9, 9), kBlue);
  EXPECT_EQ(picture.pixels[3], 255);
  EXPECT_TRUE(renderer->messages().empty());
  EXPECT_EQ(renderer->statistics().draw_calls, 1U);
  EXPECT_EQ(renderer->statistics().programs_used, 1U);
  EXPECT_EQ(renderer->statistics().shadow_passes, 0U);
}

TEST(Render, FollowsTransformsAndSlots) {
  SceneBuilder builder;
  const std::uint32_t translation = builder.vec3(-0.5, 0.5, 0);
  const std::int32_t moved = builder.transform(-1, translation);
  builder.flat_shape(builder.square(0.25F), builder.flat_program(), {1, 0, 0, 1}, moved);
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  Picture picture = renderer->draw(small());
  EXPECT_EQ(pixel(picture, 4, 12), kRed);
  EXPECT_EQ(pixel(picture, 12, 4), kBlack);
  renderer->set_slot(translation, {0.5, -0.5, 0});
  picture = renderer->draw(small());
  EXPECT_EQ(pixel(picture, 4, 12), kBlack);
  EXPECT_EQ(pixel(picture, 12, 4), kRed);
  renderer->set_slot(translation, {1});
  ASSERT_EQ(renderer->messages().size(), 1U);
  EXPECT_EQ(renderer->messages()[0], "slot " + std::to_string(translation) + " does not hold 1 values: it keeps what it had");
}

TEST(Render, KeepsAPictureFarFromTheOrigin) {
  // Matrices are composed in double: a million units away the same pixels are covered.
  SceneBuilder builder;
  const std::int32_t far_away = builder.transform(-1, builder.vec3(1e6, 1e6, 1e6));
  builder.flat_shape(builder.square(0.5F), builder.flat_program(), {1, 0, 0, 1}, far_away);
  builder.orthographic_view(1);
  builder.scene().viewpoints[0]->transform = far_away;
  const LoadedPackage loaded = builder.pack();
  const Picture picture = make_renderer(loaded)->draw(small());
  EXPECT_EQ(pixel(picture, 3, 3), kBlack);
  EXPECT_EQ(pixel(picture, 4, 4), kRed);
  EXPECT_EQ(pixel(picture, 11, 11), kRed);
  EXPECT_EQ(pixel(picture, 12, 12), kBlack);
}

TEST(Render, DrawsOnlyTheChosenChildOfASwitch) {
  SceneBuilder builder;
  const std::uint32_t which = builder.slot(PackedValueType::int_, {0});
  const std::uint32_t square = builder.square(1);
  const std::uint32_t flat = builder.flat_program();
  builder.flat_shape(square, flat, {1, 0, 0, 1}, builder.switch_child(-1, which, 0));
  builder.flat_shape(square, flat, {0, 1, 0, 1}, builder.switch_child(-1, which, 1));
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kRed);
  renderer->set_slot(which, {1});
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kGreen);
  EXPECT_EQ(renderer->statistics().draw_calls, 1U);
  renderer->set_slot(which, {-1});
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kBlack);
  EXPECT_EQ(renderer->statistics().draw_calls, 0U);
}

TEST(Render, BlendsFromFarToNearBehindNothingOpaque) {
  SceneBuilder builder;
  const std::uint32_t flat = builder.flat_program();
  builder.flat_shape(builder.square(1, 2), flat, {1, 0, 0, 0.5});  // nearest, written first
  builder.flat_shape(builder.square(1, 1), flat, {0, 1, 0, 0.5});
  builder.flat_shape(builder.square(1, 0), flat, {0, 0, 1, 1});     // opaque
  builder.flat_shape(builder.square(1, -1), flat, {1, 1, 1, 0.5});  // hidden by it
  for (const std::uint32_t shape : {0U, 1U, 3U}) builder.shape(shape).blended = true;
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  // Blue, half green over it: 0 .5 .5, half red over that: .5 .25 .25. Each step may round by one.
  const Rgb seen = pixel(make_renderer(loaded)->draw(small()), 8, 8);
  EXPECT_NEAR(seen[0], 128, 1);
  EXPECT_NEAR(seen[1], 64, 1);
  EXPECT_NEAR(seen[2], 64, 1);
}

TEST(Render, UsesTheBlendFactorsOfTheShape) {
  SceneBuilder builder;
  const std::uint32_t flat = builder.flat_program();
  builder.flat_shape(builder.square(1, 0), flat, {0.2, 0.4, 0.6, 1});
  builder.flat_shape(builder.square(1, 1), flat, {0.4, 0.2, 0, 0.5});
  builder.shape(1).blended = true;
  builder.shape(1).blend_source = PackedBlendFactor::one;
  builder.shape(1).blend_destination = PackedBlendFactor::one;
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  EXPECT_EQ(pixel(make_renderer(loaded)->draw(small()), 8, 8), (Rgb{153, 153, 153}));
}

TEST(Render, CullsBackFacesAlsoOfMirroredShapes) {
  SceneBuilder builder;
  const std::uint32_t flat = builder.flat_program();
  const std::uint32_t square = builder.square(0.4F);
  const std::uint32_t mirror = builder.vec3(-1, 1, 1);
  const auto at = [&builder](double x, double y, std::uint32_t scale) {
    return builder.transform(-1, builder.vec3(x, y, 0), kNoSlot, scale);
  };
  builder.flat_shape(square, flat, {1, 0, 0, 1}, at(-0.5, -0.5, kNoSlot));
  builder.flat_shape(square, flat, {1, 0, 0, 1}, at(0.5, -0.5, mirror));
  builder.flat_shape(square, flat, {1, 0, 0, 1}, at(-0.5, 0.5, kNoSlot));
  builder.flat_shape(square, flat, {1, 0, 0, 1}, at(0.5, 0.5, mirror));
  for (std::uint32_t i = 0; i < 4; ++i) builder.shape(i).cull_back = true;
  builder.shape(2).front_cw = builder.shape(3).front_cw = true;
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const Picture picture = make_renderer(loaded)->draw(small());
  EXPECT_EQ(pixel(picture, 4, 4), kRed);
  EXPECT_EQ(pixel(picture, 12, 4), kRed) << "mirrored: still faces the camera";
  EXPECT_EQ(pixel(picture, 4, 12), kBlack) << "its front is clockwise";
  EXPECT_EQ(pixel(picture, 12, 12), kBlack);
}

TEST(Render, CutsNoHoleNearTheCamera) {
  // A floor that runs under the camera and to the horizon: the lower half of the picture is covered wholly.
  SceneBuilder builder;
  const std::uint32_t floor = builder.mesh(
      {{-1e4F, -1, -1e4F}, {-1e4F, -1, 1e4F}, {1e4F, -1, 1e4F}, {-1e4F, -1, -1e4F}, {1e4F, -1, 1e4F}, {1e4F, -1, -1e4F}});
  builder.flat_shape(floor, builder.flat_program(), {0, 1, 0, 1});
  builder.scene().viewpoints.push_back(std::make_unique<PackedViewpointT>());
  builder.scene().viewpoints[0]->position = builder.vec3(0, 0, 0);
  builder.scene().viewpoints[0]->field_of_view = builder.number(2.5);
  const LoadedPackage loaded = builder.pack();
  const Picture picture = make_renderer(loaded)->draw(small(32, 32));
  for (std::uint32_t y = 0; y < 32; ++y) {
    for (std::uint32_t x = 0; x < 32; ++x) ASSERT_EQ(pixel(picture, x, y), y < 16 ? kGreen : kBlack) << x << " " << y;
  }
}

TEST(Render, SkipsWhatLiesBesideTheViewUnlessItsProgramMayMoveIt) {
  SceneBuilder builder;
  const std::int32_t aside = builder.transform(-1, builder.vec3(50, 0, 0));
  const std::uint32_t square = builder.square(1);
  const std::uint32_t flat = builder.flat_program();
  builder.flat_shape(square, flat, {1, 0, 0, 1}, aside);
  builder.flat_shape(square, flat, {1, 0, 0, 1}, aside);
  builder.shape(1).bounds_known = false;
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  renderer->draw(small());
  EXPECT_EQ(renderer->statistics().draw_calls, 1U);
}

TEST(Render, ShowsTexturesOfEveryChannelCount) {
  SceneBuilder builder;
  const std::uint32_t textured = builder.program(
      "#version 330 core\n"
      "in vec3 castle_Vertex;\n"
      "uniform mat4 to_clip;\n"
      "void main() { gl_Position = to_clip * vec4(castle_Vertex, 1.0); }\n",
      "#version 330 core\n"
      "uniform sampler2D picture, nothing;\n"
      "out vec4 castle_FragColor;\n"
      "void main() { vec4 t = texture(picture, vec2(0.5)) * texture(nothing, vec2(0.5));\n"
      "  castle_FragColor = vec4(t.rgb * t.a, 1.0); }\n",
      {{"to_clip", PackedUniformType::mat4},
       {"picture", PackedUniformType::sampler2D},
       {"nothing", PackedUniformType::sampler2D}});
  const std::vector<std::vector<std::uint8_t>> texels = {{100}, {200, 51}, {10, 20, 30}, {250, 200, 150, 51}};
  const std::uint32_t square = builder.square(0.4F);
  for (std::uint32_t i = 0; i < 4; ++i) {
    builder.package.images.push_back(std::make_unique<PackedImageT>());
    PackedImageT& image = *builder.package.images.back();
    image.width = image.height = 1;
    image.channels = static_cast<std::uint8_t>(texels[i].size());
    image.pixels = texels[i];
    builder.package.textures.push_back(std::make_unique<PackedTextureT>());
    builder.package.textures.back()->image = i;
    builder.scene().shapes.push_back(std::make_unique<PackedShapeT>());
    PackedShapeT& shape = builder.shape(i);
    shape.mesh = square;
    shape.program = textured;
    shape.transform = builder.transform(-1, builder.vec3(i % 2 == 0 ? -0.5 : 0.5, i < 2 ? -0.5 : 0.5, 0));
    shape.bindings = {{0, 0, 0, 1, PackedSource::model_view_projection_matrix}, {1, i, 0, 1, PackedSource::texture}};
  }
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  const Picture picture = renderer->draw(small());
  EXPECT_EQ(pixel(picture, 4, 4), (Rgb{100, 100, 100}));
  EXPECT_EQ(pixel(picture, 12, 4), (Rgb{40, 40, 40}));
  EXPECT_EQ(pixel(picture, 4, 12), (Rgb{10, 20, 30}));
  EXPECT_EQ(pixel(picture, 12, 12), (Rgb{50, 40, 30}));
  EXPECT_TRUE(renderer->messages().empty());
}

TEST(Render, ReportsRejectedProgramsAtTheAuthorsLineAndDrawsTheRest) {
  SceneBuilder builder;
  const std::uint32_t square = builder.square(1);
  const std::uint32_t broken = builder.flat_program();
  PackedStageT& stage = *builder.package.programs[broken]->targets[0]->stages[1];
  stage.text =
      "#version 330 core\n"
      "out vec4 castle_FragColor;\n"
      "void main() { castle_FragColor = missing; }\n";
  builder.package.sources = {"a.x3dv", "toon.fs"};
  stage.origins = {{0, 0}, {0, 0}, {1, 42}};
  stage.columns = {{3, 15, 5}};  // what stands behind `void main() {` begins at column 5 there
  builder.flat_shape(square, broken, {1, 0, 0, 1});
  builder.flat_shape(square, builder.flat_program(), {0, 1, 0, 1});
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  ASSERT_FALSE(renderer->messages().empty());
  EXPECT_EQ(renderer->messages()[0],
            "toon.fs:42:24: the driver rejects program `program 0`, fragment stage: error: `missing' undeclared");
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kGreen);
  EXPECT_EQ(renderer->statistics().draw_calls, 1U);
}

TEST(Render, ReportsWhatCannotBeLinkedWhereItIsDeclared) {
  SceneBuilder builder;
  const std::uint32_t square = builder.square(1);
  const std::uint32_t broken = builder.flat_program();
  const auto& stages = builder.package.programs[broken]->targets[0]->stages;
  stages[0]->text =
      "#version 330 core\n"
      "in vec4 castle_Vertex;\n"
      "out vec3 height;\n"
      "void main() { height = castle_Vertex.xyz; gl_Position = castle_Vertex; }\n";
  stages[0]->origins = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
  PackedStageT& stage = *stages[1];
  stage.text =
      "#version 330 core\n"
      "out vec4 castle_FragColor;\n"
      "in float height;\n"
      "void main() { castle_FragColor = vec4(height); }\n";
  builder.package.sources = {"a.x3dv", "toon.fs"};
  stage.origins = {{0, 0}, {0, 0}, {1, 7}, {1, 9}};
  builder.flat_shape(square, broken, {1, 0, 0, 1});
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  ASSERT_FALSE(renderer->messages().empty());
  EXPECT_THAT(renderer->messages()[0], testing::StartsWith("toon.fs:7:10: the driver cannot link program `program 0`: "));
}

TEST(Render, RefusesASceneThatIsNotThere) {
  const LoadedPackage loaded = SceneBuilder().pack();
  std::string error;
  const auto renderer = Renderer::make(test::quick_start(), error);
  ASSERT_NE(renderer, nullptr);
  EXPECT_TRUE(renderer->draw(small()).pixels.empty()) << "nothing is loaded";
  EXPECT_FALSE(renderer->load(*loaded.package, 1, error));
  EXPECT_EQ(error, "the package has no scene 1");
}

TEST(Render, LoadsOneSceneAfterAnother) {
  SceneBuilder first;
  first.flat_shape(first.square(1), first.flat_program(), {1, 0, 0, 1});
  SceneBuilder second;
  second.flat_shape(second.square(1), second.flat_program(), {0, 1, 0, 1});
  first.orthographic_view(1);
  second.orthographic_view(1);
  const LoadedPackage a = first.pack();
  const LoadedPackage b = second.pack();
  const auto renderer = make_renderer(a);
  EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kRed);
  std::string error;
  ASSERT_TRUE(renderer->load(*b.package, 0, error));
  EXPECT_EQ(pixel(renderer->draw(small(7, 3)), 3, 1), kGreen);
  EXPECT_TRUE(renderer->messages().empty());
}

TEST(Render, RunsInTwoThreadsAtOnce) {
  SceneBuilder builder;
  const std::uint32_t color_shape = builder.flat_shape(builder.square(1), builder.flat_program(), {1, 0, 0, 1});
  builder.orthographic_view(1);
  const std::uint32_t color = builder.shape(color_shape).bindings[1].a();
  const LoadedPackage loaded = builder.pack();
  std::array<int, 2> wrong = {-1, -1};
  const auto work = [&loaded, &wrong, color](std::size_t thread) {
    const auto renderer = make_renderer(loaded);
    wrong[thread] = 0;
    for (int frame = 0; frame < 20; ++frame) {
      const double value = thread == 0 ? 1.0 : 0.0;
      renderer->set_slot(color, {value, 1 - value, 0, 1});
      if (pixel(renderer->draw(small()), 8, 8) != (thread == 0 ? kRed : kGreen)) ++wrong[thread];
    }
  };
  std::thread other(work, std::size_t{1});
  work(0);
  other.join();
  EXPECT_EQ(wrong, (std::array<int, 2>{0, 0}));
}

TEST(Render, TakesTurnsBetweenRenderersOfOneThread) {
  SceneBuilder builder;
  builder.flat_shape(builder.square(1), builder.flat_program(), {1, 1, 1, 1});
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto stays = make_renderer(loaded);
  {
    const auto goes = make_renderer(loaded);
    EXPECT_EQ(pixel(goes->draw(small()), 8, 8), kWhite);
  }
  EXPECT_EQ(pixel(stays->draw(small()), 8, 8), kWhite);
  EXPECT_TRUE(stays->messages().empty());
}

}  // namespace
}  // namespace plugc
