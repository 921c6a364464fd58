// What a package asks of the driver and does not get: it is said, and the picture is made without it.

#include <gmock/gmock.h>

#include "runtime/binding_readers.h"
#include "runtime/gl/context.h"
#include "runtime/resource_pool.h"
#include "runtime/shadow_map.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::SceneBuilder;
using testing::ElementsAre;
using testing::IsEmpty;

/// The pieces below a Renderer, on a context of their own.
class Limits : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    const RendererOptions options = test::quick_start();
    context = gl::make_current_context({options.single_picture, options.cache_folder}, functions, error);
    ASSERT_NE(context, nullptr) << error;
  }

  std::unique_ptr<gl::Context> context;
  gl::Functions functions;
  Messages messages;
};

void add_texture(PackageT& package, std::uint32_t width, std::uint32_t height, std::uint32_t depth) {
  package.images.push_back(std::make_unique<PackedImageT>());
  PackedImageT& image = *package.images.back();
  image.width = width;
  image.height = height;
  image.depth = depth;
  image.channels = 1;
  image.pixels.resize(std::size_t{width} * height * depth);
  package.textures.push_back(std::make_unique<PackedTextureT>());
  package.textures.back()->image = static_cast<std::uint32_t>(package.images.size() - 1);
}

TEST_F(Limits, TexturesThatTheDriverDoesNotTakeAreWhite) {
  const GLsizei largest = gl::max_texture_side(functions, GL_TEXTURE_3D);
  if (largest >= 16384) GTEST_SKIP() << "this driver takes all that a package holds";
  SceneBuilder builder;
  add_texture(builder.package, static_cast<std::uint32_t>(largest) + 1, 1, 1);
  add_texture(builder.package, static_cast<std::uint32_t>(largest), 1, 1);
  const LoadedPackage loaded = builder.pack();
  ResourcePool pool(functions, *loaded.package);
  EXPECT_TRUE(pool.texture(0, PackedUniformType::sampler3D, messages));
  EXPECT_TRUE(pool.texture(1, PackedUniformType::sampler3D, messages));
  EXPECT_THAT(messages.list(), ElementsAre("texture 0 has more texels along a side than the driver's " +
                                           std::to_string(largest) + ": it is white"));
  EXPECT_THAT(gl::take_errors(functions), IsEmpty());
}

TEST_F(Limits, TexturesShareTheirMemory) {
  SceneBuilder builder;
  for (int i = 0; i < 4; ++i) add_texture(builder.package, 30, 10, 1);  // 1600 bytes each, with its smaller copies
  const LoadedPackage loaded = builder.pack();
  ResourcePool pool(functions, *loaded.package, 3500);
  for (std::uint32_t i = 0; i < 2; ++i) pool.texture(i, PackedUniformType::sampler2D, messages);
  EXPECT_THAT(messages.list(), IsEmpty());
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_TRUE(pool.texture(i, PackedUniformType::sampler2D, messages));
  EXPECT_THAT(messages.list(), ElementsAre("the scene's textures need more memory than they get: the last are white"));
}

/// Two lights with a map each, which the one shape reads.
SceneBuilder two_maps() {
  SceneBuilder builder;
  const std::uint32_t square = builder.square(1), program = builder.shadow_program();
  for (const char* const name : {"Left", "Right"}) {
    const std::uint32_t map = builder.add_shadow_map(builder.add_light(PackedLightKind::directional, name), 64);
    builder.shadowed_shape(square, program, map);
  }
  return builder;
}

TEST_F(Limits, ShadowMapsShareTheirMemory) {
  const LoadedPackage loaded = two_maps().pack();
  const PackedScene& scene = *loaded.package->scenes()->Get(0);
  const auto made_with = [&](std::uint64_t bytes) {
    return make_shadow_maps(functions, scene, find_binding_readers(scene).of_map, messages, bytes);
  };
  constexpr std::uint64_t kBytes = 64 * 64 * 4;
  EXPECT_TRUE(made_with(2 * kBytes)[1].texture);
  EXPECT_THAT(messages.list(), IsEmpty());
  const std::vector<ShadowMap> maps = made_with(2 * kBytes - 1);
  EXPECT_TRUE(maps[0].texture);
  EXPECT_FALSE(maps[1].texture);
  EXPECT_TRUE(maps[1].only_projects) << "coordinates still come from its light";
  EXPECT_THAT(messages.list(),
              ElementsAre("the scene's shadow maps need more memory than they get: the shadows of the last are missing"));
}

TEST(Messages, AreFitForATerminal) {
  SceneBuilder builder;
  const std::uint32_t broken = builder.program("#version 330 core\nin vec3 castle_Vertex;\nvoid main() { nonsense(); }\n",
                                               "#version 330 core\nvoid main() {}\n", {});
  builder.package.programs[broken]->name = "\x1B]0;owned\x07";
  builder.flat_shape(builder.square(1), builder.flat_program(), {1, 0, 0, 1});
  builder.shape(0).program = broken;
  builder.shape(0).bindings.clear();
  const LoadedPackage loaded = builder.pack();
  const auto renderer = test::make_renderer(loaded);
  ASSERT_FALSE(renderer->messages().empty());
  EXPECT_THAT(renderer->messages()[0], testing::StartsWith("the driver rejects program `\\x1b]0;owned\\x07`, vertex stage"));
}

TEST(BindingReaders, AreFoundOnceEach) {
  SceneBuilder builder = two_maps();
  PackedShapeT& second = builder.shape(1);
  second.bindings.emplace_back(2, 0, 0, 1.0F, PackedSource::projector_matrix);  // of the first map, beside its own
  builder.add_off_program(1, {0, PackedSwitchKind::light}, second.program, second.bindings);
  const LoadedPackage loaded = builder.pack();
  const BindingReaders readers = find_binding_readers(*loaded.package->scenes()->Get(0));
  EXPECT_THAT(readers.of_map, ElementsAre(ElementsAre(MapReader{0, 0}, MapReader{1, 0}, MapReader{1, 1}),
                                          ElementsAre(MapReader{1, 0}, MapReader{1, 1})));
  EXPECT_THAT(readers.of_texture, IsEmpty());
}

TEST(BindingReaders, OfRenderedTexturesAreShapesAndTheScreen) {
  SceneBuilder builder;
  const std::uint32_t program = builder.flat_program();
  builder.package.programs[program]->uniforms.push_back(std::make_unique<PackedUniformT>());
  builder.package.programs[program]->uniforms.back()->name = "picture";
  builder.package.programs[program]->uniforms.back()->type = PackedUniformType::sampler2D;
  for (int i = 0; i < 2; ++i) {
    builder.scene().rendered_textures.push_back(std::make_unique<PackedRenderedTextureT>());
    builder.scene().rendered_textures.back()->width = builder.scene().rendered_textures.back()->height = 8;
    builder.flat_shape(builder.square(1), program, {1, 1, 1, 1});
  }
  builder.shape(1).bindings.emplace_back(2, 1, 0, 1.0F, PackedSource::rendered_texture);
  builder.scene().screen_effects.push_back(std::make_unique<PackedScreenEffectT>());
  builder.scene().screen_effects.back()->program = program;
  builder.scene().screen_effects.back()->bindings.emplace_back(2, 0, 0, 1.0F, PackedSource::rendered_texture);
  const LoadedPackage loaded = builder.pack();
  const BindingReaders readers = find_binding_readers(*loaded.package->scenes()->Get(0));
  EXPECT_THAT(readers.of_texture, ElementsAre(IsEmpty(), ElementsAre(1U)));
  EXPECT_THAT(readers.on_screen, ElementsAre(true, false));
}

}  // namespace
}  // namespace plugc
