#include "runtime/measure/instrument.h"

#include <stdexcept>

#include "unit/runtime/test_scene.h"

namespace plugc {
namespace {

using test::SceneBuilder;

std::unique_ptr<PackageT> scaled(const SceneBuilder& builder) {
  Settings settings;
  settings.scene_scale = 2;
  const std::vector<std::uint8_t> bytes = with_settings(write_package(builder.package), settings);
  const PackageView view = open_package(bytes);
  EXPECT_EQ(view.error, "");
  return view.package == nullptr ? nullptr : std::unique_ptr<PackageT>(view.package->UnPack());
}

/// Transform 0 becomes 1, the world transform 0.
TEST(Instrument, PutsAllOfASceneUnderOneTransform) {
  SceneBuilder builder;
  PackedSceneT& scene = builder.scene();
  const std::int32_t place = builder.transform(-1, builder.vec3(1, 2, 3));
  const std::uint32_t flag = builder.slot(PackedValueType::bool_, {1});
  const std::uint32_t shape = builder.flat_shape(builder.square(1), builder.flat_program(), {1, 1, 1, 1}, place);
  builder.shape(shape).bindings[1] = PackedBinding(1, builder.number(9), 0, 1, PackedSource::fog_visibility_range);
  scene.billboards.emplace_back(place, builder.vec3(0, 1, 0));
  scene.lod_levels.emplace_back(place, builder.vec3(0, 0, 0), 0, 9);
  scene.clip_planes.emplace_back(place, builder.slot(PackedValueType::vec4, {0, 1, 0, 0}), flag);
  scene.fog_planes.emplace_back(place, builder.vec3(0, -1, 0), builder.number(0));
  scene.screen_effects.push_back(std::make_unique<PackedScreenEffectT>());
  scene.screen_effects[0]->transform = place;
  scene.screen_effects[0]->program = builder.flat_program();
  scene.event_nodes.push_back(std::make_unique<PackedEventNodeT>());
  scene.event_nodes[0]->kind = PackedEventKind::proximity_sensor;
  scene.event_nodes[0]->inputs = {flag, kNoSlot, builder.vec3(9, 9, 9)};
  scene.event_nodes[0]->outputs.assign(5, kNoSlot);
  scene.event_nodes[0]->subject = place;
  const auto moved = scaled(builder);
  ASSERT_NE(moved, nullptr);
  const PackedSceneT& under = *moved->scenes[0];
  EXPECT_EQ(under.transforms[0].parent(), -1);
  EXPECT_EQ(under.transforms[1].parent(), 0);
  EXPECT_EQ(under.shapes[0]->transform, 1);
  EXPECT_EQ(under.shapes[0]->bindings[1].b(), 1U);
  EXPECT_EQ(under.billboards[0].transform(), 1U);
  EXPECT_EQ(under.lod_levels[0].transform(), 1U);
  EXPECT_EQ(under.clip_planes[0].transform(), 1);
  EXPECT_EQ(under.fog_planes[0].transform(), 1);
  EXPECT_EQ(under.screen_effects[0]->transform, 1);
  EXPECT_EQ(under.event_nodes[0]->subject, 1);
}

TEST(Instrument, ThrowsWhereThePackageCannotBeOpened) {
  EXPECT_THROW(with_settings({1, 2, 3}, {}), std::runtime_error);
  EXPECT_THROW(make_measurable({1, 2, 3}, {}), std::runtime_error);
}

}  // namespace
}  // namespace plugc
