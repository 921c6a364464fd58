#include "mesh/mesh_cache.h"

#include <gtest/gtest.h>

#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

TEST(MeshCache, EqualMeshesAreOne) {
  MeshCache cache;
  const auto box = share_mesh(cache, mesh_from("Box { }"));
  EXPECT_EQ(share_mesh(cache, mesh_from("Box { size 2 2 2 }")), box);
  EXPECT_NE(share_mesh(cache, mesh_from("Box { size 2 2 1 }")), box);
  EXPECT_NE(share_mesh(cache, mesh_from("Box { solid FALSE }")), box);  // the same triangles, drawn otherwise
}

}  // namespace
}  // namespace plugc
