#include "runtime/live_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/render.h"
#include "tests/support/package_sample.h"

namespace plugc {
namespace {

class LiveMeshesTest : public testing::Test {
 protected:
  /// The version of the one live mesh, which follows kSampleColor, after the slot has got these numbers.
  std::uint32_t version_after(std::uint32_t slot, const std::vector<double>& numbers) {
    EXPECT_TRUE(slots.set(slot, numbers));
    update_live_meshes(meshes, slots);
    return meshes.list.at(0).version;
  }

  std::string error;
  LoadedPackage loaded = load_package(write_package(sample_package()), error);
  const PackedScene& scene = *loaded.package->scenes()->Get(0);
  Slots slots{scene};
  LiveMeshes meshes = make_live_meshes(*loaded.package, scene);
};

TEST_F(LiveMeshesTest, AreWrittenOnlyWhenTheirSlotsChange) {
  const std::uint32_t moved = version_after(kSampleColor, {1, 2, 3});
  EXPECT_EQ(version_after(kSampleColor, {1, 2, 3}), moved);
  EXPECT_EQ(version_after(kSampleScalar, {7}), moved) << "another slot";
  EXPECT_EQ(version_after(kSampleColor, {1, 2, 4}), moved + 1);
}

TEST_F(LiveMeshesTest, AreNotWrittenAgainForNumbersThatEqualNothing) {
  const std::uint32_t moved = version_after(kSampleColor, {std::nan(""), 0, 0});
  EXPECT_EQ(version_after(kSampleColor, {std::nan(""), 0, 0}), moved);
  EXPECT_EQ(version_after(kSampleScalar, {7}), moved) << "another slot";
}

TEST_F(LiveMeshesTest, FollowSlotsThatAreRestored) {
  version_after(kSampleColor, {1, 2, 3});
  const Box moved = meshes.list[0].bounds;
  slots.restore(scene);
  EXPECT_TRUE(update_live_meshes(meshes, slots));
  EXPECT_NE(meshes.list[0].bounds.max, moved.max);
}

}  // namespace
}  // namespace plugc
