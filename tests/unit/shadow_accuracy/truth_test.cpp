// Whether the laboratory itself can be trusted.

#include <cmath>

#include "judged_text.h"
#include "runtime/measure/floor.h"

namespace plugc {
namespace {

// The box casts a shadow, but behind the viewer.
constexpr const char* kGroundAlone = R"(#X3D V4.0 utf8
NavigationInfo { headlight FALSE }
Viewpoint { position 0 4 6 orientation 1 0 0 -0.6 }
DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE }
Shape { appearance Appearance { material Material { } } geometry Box { size 20 1 20 } }
Transform { translation 0 1 9 children Shape { appearance Appearance { material Material { } } geometry Box { size 1 1 1 } } }
)";

// Seen straight from above, 8 units high: a square of 2 by 2 units floats over the ground, and its shadow lies beside it.
constexpr const char* kFloatingSquare = R"(#X3D V4.0 utf8
NavigationInfo { headlight FALSE }
OrthoViewpoint { position 0 10 0 orientation 1 0 0 -1.5707963 fieldOfView [ -4 -4 4 4 ] }
DirectionalLight { direction -1 -1 0 shadows TRUE }
Shape { appearance Appearance { material Material { } } geometry Box { size 40 0.1 40 } }
Transform { translation 2.5 3.05 0 children Shape { appearance DEF Look Appearance { material Material { } TEXTURE } geometry Box { size 2 0.0001 2 } } }
)";

std::string floating_square(const std::string& texture) {
  std::string scene = kFloatingSquare;
  const std::string mark = "TEXTURE";
  return scene.replace(scene.find(mark), mark.size(), texture);
}

/// Square units of shadow in the picture of kFloatingSquare.
double shadow_area(const JudgedText& text) {
  const double unit = 360.0 / 8;  // pixels
  return text.view().truth.shadowed / (unit * unit);
}

TEST(ShadowTruth, AGroundThatNothingShadowsHasNoError) {
  const JudgedText text = judge_text(kGroundAlone);
  EXPECT_GT(text.view().truth.counted, 50'000U);
  EXPECT_EQ(text.view().truth.shadowed, 0U);
  const MeanErrors mean = errors_of(text, package_of(kGroundAlone), {}, 4);
  EXPECT_EQ(mean.errors.wrong(), 0);
  EXPECT_LT(mean.errors.mean_absolute, 1e-5);
}

TEST(ShadowTruth, AShadowHasTheAreaOfWhatCastsIt) {
  EXPECT_NEAR(shadow_area(judge_text(floating_square(""))), 4, 0.05);
}

TEST(ShadowTruth, LightFallsThroughTheHolesOfAnAlphaTest) {
  const std::string half = "texture PixelTexture { repeatS FALSE repeatT FALSE image 2 1 4 0xFFFFFFFF 0xFFFFFF00 }";
  EXPECT_NEAR(shadow_area(judge_text(floating_square(half))), 2, 0.1);
}

TEST(ShadowTruth, ThePictureOfTheTrueShadowHasNoError) {
  const JudgedText text = judge_text(boxes_in_the_sun());
  const JudgedView& view = text.view();
  EXPECT_GT(view.truth.shadowed, 1'000U);
  Shot shot = view.calibration.unshadowed;
  for (std::size_t i = 0; i < shot.colors.size(); ++i) {
    if (!view.truth.pixels[i].lit) shot.colors[i] = view.calibration.dark.colors[i];
  }
  const MapProjection map = projection_of(*text.scene, view.map);
  const ShadowErrors errors =
      compare(view.truth, measured_visibility(shot, view.calibration), map, *text.judged.tracer, view.light);
  EXPECT_EQ(errors.wrong(), 0);
  EXPECT_LT(errors.mean_absolute, 1e-5);
}

TEST(ShadowTruth, WithoutShadowsAllThatIsShadowedIsWrong) {
  const JudgedText text = judge_text(boxes_in_the_sun());
  const JudgedView& view = text.view();
  const std::vector<float> lit = measured_visibility(view.calibration.unshadowed, view.calibration);
  const ShadowErrors errors = compare(view.truth, lit, projection_of(*text.scene, 0), *text.judged.tracer, view.light);
  EXPECT_EQ(errors.false_shadow, 0);
  EXPECT_NEAR(errors.false_lit, double(view.truth.shadowed) / view.truth.counted, 1e-12);
}

TEST(ShadowTruth, ASceneFarFromItsOriginHasTheSameShadow) {
  const std::vector<std::uint8_t> package = package_of(boxes_in_the_sun());
  FrameOptions frame;
  frame.width = 640;
  frame.height = 360;
  std::vector<std::uint32_t> shadowed;
  for (const double distance : {0.0, 1e6}) {
    Settings settings;
    settings.scene_offset = glm::dvec3(distance, 0.5 * distance, -distance);
    const auto scene = load_measured_scene(process_studio(), package, settings);
    shadowed.push_back(judge_scene(process_studio(), *scene, {frame}).views.at(0).truth.shadowed);
  }
  EXPECT_NEAR(shadowed[0], shadowed[1], 2);
}

TEST(ShadowFloor, ATexelsCentreLiesAQuarterOfItAwayAlongAnAxisAndLessDiagonally) {
  EXPECT_DOUBLE_EQ(mean_distance_from_texel_centre({1, 0}), 0.25);
  EXPECT_NEAR(mean_distance_from_texel_centre({std::sqrt(0.5), std::sqrt(0.5)}), 0.2357, 1e-4);
  double sum = 0;
  constexpr int kSteps = 3600;
  for (int i = 0; i < kSteps; ++i) sum += mean_distance_from_texel_centre({std::cos(i * 1e-3), std::sin(i * 1e-3)});
  EXPECT_NEAR(sum / kSteps, 0.2435, 2e-3);
}

TEST(ShadowFloor, FallsWithTheMapsSize) {
  const JudgedText text = judge_text(boxes_in_the_sun());
  const std::vector<std::uint8_t> package = package_of(boxes_in_the_sun());
  Settings small, large;
  small.size = 512;
  large.size = 1024;
  EXPECT_NEAR(errors_of(text, package, small, 1).floor / errors_of(text, package, large, 1).floor, 2, 0.05);
}

}  // namespace
}  // namespace plugc
