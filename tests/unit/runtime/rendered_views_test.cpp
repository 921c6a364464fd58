// Views that are drawn beside the picture: textures that the scene draws for itself, and screen effects.

#include "test_scene.h"

namespace plugc {
namespace {

using test::kGreen;
using test::kWhite;
using test::make_renderer;
using test::pixel;
using test::SceneBuilder;

FrameOptions small() {
  FrameOptions frame;
  frame.width = frame.height = 16;
  return frame;
}

/// Neither scene has a viewpoint, and the texture's own is a hundred times smaller than the one that shows it.
TEST(RenderedTexture, ShowsTheWholeOfItsOwnSceneHoweverLargeTheWorldIs) {
  SceneBuilder builder;
  const std::uint32_t texture = builder.own_scene_texture(16);
  const std::uint32_t green = builder.flat_shape(builder.square(1), builder.flat_program(), {0, 1, 0, 1});
  builder.shape(green).own_scene_of = static_cast<std::int32_t>(texture);
  const std::uint32_t screen = builder.program(
      "#version 330 core\n"
      "in vec3 castle_Vertex;\n"
      "uniform mat4 to_clip;\n"
      "void main() { gl_Position = to_clip * vec4(castle_Vertex, 1.0); }\n",
      "#version 330 core\n"
      "uniform sampler2D picture;\n"
      "out vec4 castle_FragColor;\n"
      "void main() { castle_FragColor = texture(picture, vec2(0.5)); }\n",
      {{"to_clip", PackedUniformType::mat4}, {"picture", PackedUniformType::sampler2D}});
  const std::uint32_t shown = builder.flat_shape(builder.square(100), screen, {0, 0, 0, 1});
  builder.shape(shown).bindings[1] = PackedBinding(1, texture, 0, 1, PackedSource::rendered_texture);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  for (int frame = 0; frame < 2; ++frame) EXPECT_EQ(pixel(renderer->draw(small()), 8, 8), kGreen);
  EXPECT_TRUE(renderer->messages().empty());
}

TEST(ScreenEffect, IsToldTheSizeOfThePicture) {
  SceneBuilder builder;
  auto effect = std::make_unique<PackedScreenEffectT>();
  effect->program = builder.program(
      "#version 330 core\n"
      "void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0.0, 1.0); }\n",
      "#version 330 core\n"
      "uniform vec2 size;\n"
      "uniform float width, height;\n"
      "out vec4 castle_FragColor;\n"
      "void main() { castle_FragColor = vec4(size == vec2(24.0, 16.0), width == 24.0, height == 16.0, 1.0); }\n",
      {{"size", PackedUniformType::vec2}, {"width", PackedUniformType::float_}, {"height", PackedUniformType::float_}});
  effect->bindings = {PackedBinding(0, 0, 0, 1, PackedSource::target_size),
                      PackedBinding(1, 0, 0, 1, PackedSource::screen_width),
                      PackedBinding(2, 0, 0, 1, PackedSource::screen_height)};
  builder.scene().screen_effects.push_back(std::move(effect));
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  FrameOptions frame = small();
  frame.width = 24;
  EXPECT_EQ(pixel(renderer->draw(frame), 8, 8), kWhite);
  EXPECT_TRUE(renderer->messages().empty());
}

}  // namespace
}  // namespace plugc
