#include "runtime/surfaces.h"

#include "runtime/live_meshes.h"
#include "test_scene.h"

namespace plugc {
namespace {

using test::SceneBuilder;

/// A square whose program tests the alpha of a texture; without texture coordinates, as nothing but a made-up package has it.
SceneBuilder tested_square() {
  SceneBuilder builder;
  const std::uint32_t program = builder.flat_program();
  builder.package.programs[program]->recipe = "unlit alpha_test";
  SceneBuilder::add_uniform(*builder.package.programs[program], {"picture", PackedUniformType::sampler2D});
  builder.package.images.push_back(std::make_unique<PackedImageT>());
  builder.package.images[0]->width = builder.package.images[0]->height = 1;
  builder.package.images[0]->channels = 4;
  builder.package.images[0]->pixels = {255, 255, 255, 0};
  builder.package.textures.push_back(std::make_unique<PackedTextureT>());
  const std::uint32_t shape = builder.flat_shape(builder.square(1), program, {1, 1, 1, 1});
  builder.shape(shape).bindings.emplace_back(2, 0, 0, 1.0F, PackedSource::texture);
  return builder;
}

std::vector<Surface> surfaces_of(const LoadedPackage& loaded) {
  const PackedScene& scene = *loaded.package->scenes()->Get(0);
  const Slots slots(scene);
  return read_surfaces(*loaded.package, scene, slots, place(*loaded.package, scene, slots),
                       make_live_meshes(*loaded.package, scene));
}

TEST(Surfaces, HaveNoHolesWhereNothingSaysWhereTheTextureLies) {
  const LoadedPackage loaded = tested_square().pack();
  const std::vector<Surface> surfaces = surfaces_of(loaded);
  ASSERT_EQ(surfaces.size(), 1U);
  EXPECT_EQ(surfaces[0].points.size(), 6U);
  EXPECT_FALSE(surfaces[0].alpha_test.has_value());
}

TEST(Surfaces, HaveTheHolesOfTheirTexture) {
  SceneBuilder builder = tested_square();
  PackedMeshT& mesh = *builder.package.meshes[0];
  mesh.streams.emplace_back(PackedSemantic::tex_coord, 0, 2, 0);  // the positions serve
  const LoadedPackage loaded = builder.pack();
  const std::vector<Surface> surfaces = surfaces_of(loaded);
  ASSERT_EQ(surfaces.size(), 1U);
  ASSERT_TRUE(surfaces[0].alpha_test.has_value());
  EXPECT_EQ(surfaces[0].tex_coords.size(), 6U);
  EXPECT_EQ(alpha_at(*surfaces[0].alpha_test, {0.5, 0.5}), 0);
}

}  // namespace
}  // namespace plugc
