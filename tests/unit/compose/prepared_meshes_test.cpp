// What a scene's meshes may have together counts for all that is made of vertices.

#include <gtest/gtest.h>

#include <algorithm>

#include "document/read_document.h"
#include "prepare_scene.h"

namespace plugc {
namespace {

class PreparedMeshes : public testing::Test {
 protected:
  /// The scene's meshes by shape, where all of them may have so many vertices.
  std::vector<std::shared_ptr<const Mesh>> prepare(const std::string& text, std::size_t vertices) {
    const SourceId source = sources.add("scene.x3dv", "#X3D V4.0 utf8\n" + text);
    const NodeGraph graph = build_graph(read_document(source, sources, diagnostics), "scene.x3dv", sources, files, diagnostics);
    MeshCache meshes;
    meshes.budget.left = vertices;
    const PreparedScene prepared = prepare_scene(graph, build_scene(graph, sources, files, {}, diagnostics),
                                                 PreparedFor::checking, files, diagnostics, meshes);
    std::vector<std::shared_ptr<const Mesh>> made;
    for (const ShapePlan& plan : prepared.parts.shapes) made.push_back(plan.mesh);
    return made;
  }

  /// How often it was said that they are too many.
  std::ptrdiff_t times_said() const {
    return std::ranges::count(diagnostics.all(), DiagnosticId::geometry_limit, &Diagnostic::id);
  }

  SourceSet sources;
  Diagnostics diagnostics{sources};
  MemoryFiles files;
};

constexpr std::size_t kOfABox = 24;
const std::string kBumpyBox =
    "Shape { appearance Appearance { material Material { normalTexture PixelTexture { image 1 1 3 0x8080FF } } } "
    "geometry Box { } }\n";

TEST_F(PreparedMeshes, WithTangentsAreMeshesOfTheirOwn) {
  EXPECT_FALSE(prepare(kBumpyBox, 2 * kOfABox).at(0)->tangents.empty());
  EXPECT_EQ(times_said(), 0);
  EXPECT_TRUE(prepare(kBumpyBox, 2 * kOfABox - 1).at(0)->tangents.empty()) << "it is drawn without";
  EXPECT_EQ(times_said(), 1);
}

TEST_F(PreparedMeshes, OfBackgroundsCountToo) {
  const std::string sky = "Background { skyColor [ 1 0 0, 0 0 1 ] skyAngle 1 }\n";
  const auto shapes = prepare("Shape { geometry Box { } }\n" + sky, kOfABox + 1);
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_NE(shapes[0], nullptr);
  EXPECT_EQ(shapes[1], nullptr);
  EXPECT_EQ(times_said(), 1);
}

}  // namespace
}  // namespace plugc
