#include "mesh/mesh_cache.h"

#include <gtest/gtest.h>

#include "tests/support/mesh_from_text.h"

namespace plugc {
namespace {

class MeshCacheTest : public testing::Test {
 protected:
  std::shared_ptr<const Mesh> share(const std::string& geometry) {
    return share_mesh(cache, mesh_from(geometry), Span{}, diagnostics);
  }

  SourceSet sources;
  Diagnostics diagnostics{sources};
  MeshCache cache;
};

TEST_F(MeshCacheTest, EqualMeshesAreOne) {
  const auto box = share("Box { }");
  EXPECT_EQ(share("Box { size 2 2 2 }"), box);
  EXPECT_NE(share("Box { size 2 2 1 }"), box);
  EXPECT_NE(share("Box { solid FALSE }"), box);  // the same triangles, drawn otherwise
}

TEST_F(MeshCacheTest, SaysOnceThatItIsFull) {
  const std::size_t of_a_box = mesh_from("Box { }").positions.size();
  cache.budget.left = 2 * of_a_box;
  const auto box = share("Box { }");
  EXPECT_EQ(share("Box { size 2 2 2 }"), box) << "takes nothing";
  EXPECT_NE(share("Box { size 3 3 3 }"), nullptr);
  EXPECT_EQ(share("Box { size 4 4 4 }"), nullptr);
  EXPECT_EQ(share("Box { size 5 5 5 }"), nullptr);
  EXPECT_EQ(share("Box { }"), box);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message,
            "the meshes of this scene have more than 64000000 vertices; what is more is left out, from here on");
}

}  // namespace
}  // namespace plugc
