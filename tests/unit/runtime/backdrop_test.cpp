#include "runtime/backdrop.h"

#include "test_scene.h"

namespace plugc {
namespace {

using test::kBlue;
using test::kGreen;
using test::kRed;
using test::make_renderer;
using test::pixel;
using test::SceneBuilder;

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], 1e-12);
}

TEST(Backdrop, IsSeenFromTheOrigin) {
  View camera = look_along({100, 200, 300}, {1, 0, 0}, {0, 1, 0});
  camera.projection = glm::dmat4(2.0);
  const View view = backdrop_view(camera);
  expect_near(glm::dvec3(view.eye_to_world[3]), {0, 0, 0});
  expect_near(glm::dvec3(view.world_to_eye * glm::dvec4(5, 0, 0, 1)), {0, 0, -5});
  EXPECT_EQ(view.projection, camera.projection);
}

TEST(Backdrop, AnOrthographicCameraSeesItInPerspective) {
  View camera = look_along({0, 0, 0}, {0, 0, -1}, {0, 1, 0});
  camera.projection = glm::dmat4(1.0);
  camera.projection[1][1] = 2;  // twice as wide as it is high
  const View view = backdrop_view(camera);
  const double edge = std::tan(std::numbers::pi / 8);
  const glm::dvec4 clip = view.projection * glm::dvec4(2 * edge, edge, -1, 1);
  expect_near(glm::dvec3(clip.x / clip.w, clip.y / clip.w, 0), {1, 1, 0});
}

/// A blue backdrop in front of the eye, a red square on the left and a green one on the right, near and far.
TEST(Backdrop, LiesBehindWhatIsNearAndWhatIsFar) {
  SceneBuilder builder;
  const std::uint32_t flat = builder.flat_program();
  const std::int32_t aside = builder.transform(-1, builder.vec3(500, 0, 0));
  builder.flat_shape(builder.square(1, -1), flat, {0, 0, 1, 1}, aside);
  builder.shape(0).layer = PackedLayer::backdrop;
  const auto half = [&](float left, float right, float z) {
    return builder.mesh({{left, -1, z}, {right, -1, z}, {right, 0, z}, {left, -1, z}, {right, 0, z}, {left, 0, z}});
  };
  builder.flat_shape(half(-1, 0, 9.999F), flat, {1, 0, 0, 1});
  builder.flat_shape(half(0, 1, -1e6F), flat, {0, 1, 0, 1});
  builder.orthographic_view(1);
  const LoadedPackage loaded = builder.pack();
  const auto renderer = make_renderer(loaded);
  FrameOptions options;
  options.width = options.height = 16;
  options.samples = 1;
  const Picture picture = renderer->draw(options);
  EXPECT_EQ(pixel(picture, 4, 4), kRed);
  EXPECT_EQ(pixel(picture, 12, 4), kGreen);
  EXPECT_EQ(pixel(picture, 4, 12), kBlue);
  EXPECT_EQ(pixel(picture, 12, 12), kBlue);
  EXPECT_EQ(renderer->statistics().draw_calls, 3U);
  EXPECT_EQ(renderer->statistics().programs_used, 1U);
  EXPECT_TRUE(renderer->messages().empty());
}

}  // namespace
}  // namespace plugc
