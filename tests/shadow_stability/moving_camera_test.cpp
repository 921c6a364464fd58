// A camera that moves over a still scene: shadows keep their edges, and maps are drawn anew only now and then.

#include <gtest/gtest.h>

#include <cmath>

#include "boxes_scene.h"
#include "runtime/shadow_map.h"
#include "stage.h"

namespace plugc {
namespace {

/// A relief that casts on itself everywhere, so that the map can only follow the view.
std::string relief_scene(int map_size) {
  std::string heights;
  for (int i = 0; i < 41 * 41; ++i) heights += i * 7919 % 5 == 0 ? "3 " : i % 3 == 0 ? "0.5 " : "0 ";
  return "#X3D V4.0 utf8\nPROFILE Full\nNavigationInfo { headlight FALSE }\n"
         "DirectionalLight { direction -0.9 -0.6 -0.5 intensity 0.8 shadows TRUE defaultShadowMap GeneratedShadowMap "
         "{ update \"ALWAYS\" size " +
         std::to_string(map_size) +
         " } }\nDEF Eye OrthoViewpoint { position 0 20 0 orientation 1 0 0 -1.5707963267948966 fieldOfView [-4 -4 4 4] }\n"
         "DEF Walker Viewpoint { position 0 3 0 orientation 1 0 0 -0.5 }\n"
         "Transform { translation -40 0 -40 children Shape { appearance Appearance { material Material { ambientIntensity 0 } "
         "} "
         "geometry ElevationGrid { solid FALSE creaseAngle 0 xDimension 41 zDimension 41 xSpacing 2 zSpacing 2 height [" +
         heights + "] } } }\n";
}

TEST(ShadowStability, NoPixelChangesWhenTheCameraMovesByPartsOfATexel) {
  // 128 pixels on 8 units: a step of one pixel is at most a fifth of a texel, and moves the picture by just one column.
  constexpr std::uint32_t kSide = 128;
  constexpr double kPixel = 8.0 / kSide;
  Stage stage(relief_scene(32), {"Eye.position"}, kSide);
  std::vector<float> last;
  std::uint32_t passes = 0;
  std::size_t shadowed = 0;
  for (int step = 0; step < 48; ++step) {
    stage.set("Eye.position", {step * kPixel, 20, 0});
    std::vector<float> now = stage.draw().values;
    passes += stage.statistics().shadow_passes;
    std::size_t changed = 0;
    for (std::uint32_t y = 0; y < kSide && step > 0; ++y) {
      for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
        const float before = last[(std::size_t{y} * kSide + x + 1) * 4];
        changed += std::abs(now[(std::size_t{y} * kSide + x) * 4] - before) > 0.02F ? 1 : 0;
        shadowed += before < 0.05F ? 1 : 0;
      }
    }
    EXPECT_EQ(changed, 0U) << step;
    last = std::move(now);
  }
  EXPECT_GT(shadowed, 1000U);
  EXPECT_LE(passes, 24U);
}

TEST(ShadowStability, AWalkNeedsAMapNowAndThen) {
  Stage stage(relief_scene(512), {"Walker.position"}, 64);
  stage.look_through("Walker");
  std::uint32_t passes = 0;
  for (int step = 0; step < 200; ++step) {
    stage.set("Walker.position", {0, 3, -0.02 * step});
    stage.draw();
    passes += stage.statistics().shadow_passes;
  }
  EXPECT_GE(passes, 2U) << "the view moved on by four units";
  EXPECT_LE(passes, 40U);
}

TEST(ShadowStability, ErrorStaysSmallWhileTheCameraGoesAround) {
  for (const char* const light : {kSun, kSpot}) {
    Stage stage(boxes_scene(light), {"Near.position", "Near.orientation"});
    for (int i = 0; i < 12; ++i) {
      const double angle = i * 0.5236;
      stage.set("Near.position", {10 * std::sin(angle), 5, 10 * std::cos(angle)});
      stage.set("Near.orientation", {0, 1, 0, angle});
      EXPECT_LE(stage.judge().error(), 0.6) << light << i;
    }
  }
}

/// Square root of how many texels lie on a unit of area of the ground y = 0, at a point there; 0 outside of the map.
double texels_per_length(const View& light, double map_size, const glm::dvec3& point) {
  const glm::dmat4 to_texture = world_to_texture(light);
  const auto texel = [&](const glm::dvec3& at) {
    const glm::dvec4 projected = to_texture * glm::dvec4(at, 1);
    return glm::dvec2(projected) / projected.w * map_size;
  };
  constexpr double kStep = 1e-4;
  const glm::dvec2 here = texel(point);
  if (!(here.x > 0 && here.y > 0 && here.x < map_size && here.y < map_size)) return 0;
  const glm::dvec2 x = (texel(point + glm::dvec3(kStep, 0, 0)) - here) / kStep;
  const glm::dvec2 z = (texel(point + glm::dvec3(0, 0, kStep)) - here) / kStep;
  return std::sqrt(std::abs(x.x * z.y - x.y * z.x));
}

TightFit fit_of(const Stage& stage) {
  const World world = stage.world();
  const View camera = stage.camera();
  Messages ignored;
  FitInput input = fit_input(stage.scene(), world, 0);
  input.camera = &camera;
  FitMemory memory;
  return fit_tightly(light_frame(stage.scene(), *stage.scene().shadow_maps()->Get(0), stage.slots(), world, ignored), input,
                     memory);
}

TEST(ShadowStability, FitsAtLeastAsManyTexelsAsWereSetByHand) {
  const std::filesystem::path folder = PLUGC_SOURCE_DIR "/../shared/corpus/scenes/shadow_maps/explicit_projection_parameters";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the corpus is not here";
  Stage by_hand(compile_file(folder / "spot_params_explicit.x3dv"));
  Stage automatic(compile_file(folder / "spot_params_auto.x3dv"));
  const View hand = fit_of(by_hand).view;
  const TightFit fitted = fit_of(automatic);
  ASSERT_TRUE(fitted.needed);
  const Truth truth = automatic.trace();
  std::size_t shadowed = 0;
  for (double x = -4; x < 4; x += 0.1) {
    for (double z = -8; z < 2; z += 0.1) {
      const double wanted = texels_per_length(hand, 1024, {x, 0, z});
      const double found = texels_per_length(fitted.view, 1024, {x, 0, z});
      if (found == 0) continue;  // nothing casts there
      ++shadowed;
      EXPECT_GE(found, 0.95 * wanted) << x << ' ' << z;
    }
  }
  EXPECT_GT(shadowed, 500U);
  EXPECT_LE(automatic.judge(truth).error(), by_hand.judge(truth).error() + 0.05);
  EXPECT_LE(automatic.judge(truth).error(), 0.5) << "so no shadow lies outside of the map";
}

}  // namespace
}  // namespace plugc
