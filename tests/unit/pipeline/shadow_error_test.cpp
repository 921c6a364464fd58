// plugc build --shadow-error: pictures are small here, so that drawing and judging a scene takes a second.

#include <fmt/format.h>

#include "cli/choose_shadows.h"
#include "package/package_file.h"
#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

using testing::HasSubstr;

Studio& process_studio() {
  static const std::unique_ptr<Studio> studio = [] {
    std::string error;
    auto made = Studio::make(PLUGC_BINARY_DIR "/test_cache/mesa", error, true);
    EXPECT_NE(made, nullptr) << error;
    return made;
  }();
  return *studio;
}

std::string box_text(const glm::dvec3& at, const glm::dvec3& size) {
  return fmt::format(
      "Transform {{ translation {} {} {} rotation 0 1 0 0.3 children Shape {{ appearance Appearance {{ material Material {{ }} "
      "}} "
      "geometry Box {{ size {} {} {} }} }} }}\n",
      at.x, at.y, at.z, size.x, size.y, size.z);
}

/// Pillars on a floor, from two viewpoints. `light` is what casts their shadow.
std::string scene_text(std::string_view light) {
  std::string text = fmt::format(
      "#X3D V4.0 utf8\nNavigationInfo {{ headlight FALSE }}\n"
      "Viewpoint {{ position 0 5 7 orientation 1 0 0 -0.6 }}\nViewpoint {{ position 0 3 6 orientation 1 0 0 -0.4 }}\n{}\n",
      light);
  text += box_text({0, -0.5, 0}, {20, 1, 20});
  for (int x = -3; x <= 3; ++x) {
    for (int z = -3; z <= 2; ++z) text += box_text({1.3 * x, 0.6, 1.4 * z}, {0.4, 1.2, 0.3});
  }
  return text;
}

constexpr std::string_view kSun = "DEF Sun DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE }";

ShadowErrorRequest request_of(double budget) {
  return {budget, 320, 180, false};
}

struct Built {
  std::vector<ChosenShadow> chosen;
  Compiled compiled;
};

Built build_file(const std::filesystem::path& scene, const ShadowErrorRequest& request, CompileOptions options = {}) {
  Built built;
  built.chosen = choose_shadows(scene, options, request, process_validator(), process_studio());
  for (const ChosenShadow& one : built.chosen) options.shadow_choices[scene].push_back(one.choice);
  built.compiled = compile_file(scene, options);
  return built;
}

Built build(std::string_view light, const ShadowErrorRequest& request, const CompileOptions& options = {}) {
  const SceneFolder folder;
  return build_file(folder.write("scene.x3dv", scene_text(light)), request, options);
}

const PackedShadowMap& map_of(const Built& built, std::uint32_t index = 0) {
  return *built.compiled.package->scenes()->Get(0)->shadow_maps()->Get(index);
}

/// What is wrong in the pictures of a package, in the request's size.
double error_of(const Built& built, const ShadowErrorRequest& request) {
  const auto scene = load_measured_scene(process_studio(), built.compiled.bytes, {});
  const JudgedScene judged = read_judged_scene(*scene);
  double sum = 0;
  const auto frames = viewpoint_frames(*scene->loaded.packed, request.width, request.height, 1e9);
  for (const FrameOptions& frame : frames) {
    const JudgedView view = judge_view(process_studio(), *scene, judged, frame, 0);
    sum += count_errors(view.truth, measure_visibility(process_studio(), *scene, view, glm::dvec2(0))).wrong();
  }
  return sum / double(frames.size());
}

bool can_trace() {
  std::string error;
  return Tracer::make({}, error) != nullptr;
}

class ShadowErrorPromise : public testing::TestWithParam<double> {};

TEST_P(ShadowErrorPromise, IsKeptByThePackage) {
  if (!can_trace()) GTEST_SKIP() << "without Embree nobody knows the truth";
  for (const std::string_view light :
       {kSun, std::string_view("SpotLight { location 3 8 4 direction -0.36 -1 -0.44 cutOffAngle 0.7 shadows TRUE }"),
        std::string_view("PointLight { location 1 3 1 shadows TRUE }")}) {
    const ShadowErrorRequest request = request_of(GetParam());
    const Built built = build(light, request);
    EXPECT_THAT(built.compiled.messages(), testing::IsEmpty());
    ASSERT_NE(map_of(built).choice(), nullptr);
    EXPECT_LE(map_of(built).choice()->error(), GetParam());
    EXPECT_EQ(map_of(built).choice()->views(), 2U);
    EXPECT_DOUBLE_EQ(error_of(built, request), map_of(built).choice()->error());
    EXPECT_GT(built.chosen.at(0).shadowed_share, 0.01) << "the truth has a shadow";
    EXPECT_NE(map_of(built).method(), PackedShadowMethod::traced) << "a map can reach it";
  }
}

INSTANTIATE_TEST_SUITE_P(Budgets, ShadowErrorPromise, testing::Values(0.0025, 0.005, 0.01, 0.02));

TEST(ShadowError, AsksForLargerMapsWhereLessIsAllowed) {
  const Built loose = build(kSun, request_of(0.02));
  const Built tight = build(kSun, request_of(0.005));
  EXPECT_LT(loose.chosen.at(0).trials.back().cost, tight.chosen.at(0).trials.back().cost);
}

TEST(ShadowError, ChoosesTheSameEachTime) {
  const SceneFolder folder;
  const auto scene = folder.write("scene.x3dv", scene_text(kSun));
  EXPECT_EQ(build_file(scene, request_of(0.01)).compiled.bytes, build_file(scene, request_of(0.01)).compiled.bytes);
}

TEST(ShadowError, LeavesWhatTheSceneWrites) {
  const Built built = build(
      "DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE "
      "defaultShadowMap GeneratedShadowMap { update \"ALWAYS\" method \"PCF3\" scale 3 } }",
      request_of(0.01));
  EXPECT_EQ(map_of(built).method(), PackedShadowMethod::pcf3);
  EXPECT_EQ(built.chosen.at(0).choice.scale, 3);
  for (const ShadowTrial& trial : built.chosen.at(0).trials) EXPECT_EQ(trial.configuration.method, PackedShadowMethod::pcf3);
  const Built sized = build(
      "DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE "
      "defaultShadowMap GeneratedShadowMap { update \"ALWAYS\" size 700 } }",
      request_of(0.02));
  EXPECT_EQ(map_of(sized).size(), 700U);
}

TEST(ShadowError, LeavesTheMethodOfTheCommandLine) {
  CompileOptions options;
  options.shadows.method = ShadowMethod::poisson;
  ShadowErrorRequest request = request_of(0.01);
  request.method_given = true;
  const Built built = build(kSun, request, options);
  EXPECT_EQ(map_of(built).method(), PackedShadowMethod::poisson);
  EXPECT_LE(built.chosen.at(0).choice.error, 0.01);
}

TEST(ShadowError, SaysWhereItCannotBeKept) {
  const Built built = build(
      "DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE "
      "defaultShadowMap GeneratedShadowMap { update \"ALWAYS\" method \"HARD\" size 128 } }",
      request_of(0.001));
  ASSERT_EQ(built.compiled.messages().size(), 1U);
  EXPECT_THAT(built.compiled.messages().front(),
              HasSubstr("5:1 shadow-error-missed this light's shadow cannot be within 0.1 %"));
  EXPECT_THAT(built.compiled.messages().front(), HasSubstr("by `hard` with 128 texels"));
}

TEST(ShadowError, IsTracedWhereNoMapReachesIt) {
  if (!can_trace()) GTEST_SKIP() << "plugc cannot trace here";
  const Built built = build(kSun, request_of(1e-6));
  EXPECT_THAT(built.compiled.messages(), testing::IsEmpty());
  EXPECT_EQ(map_of(built).method(), PackedShadowMethod::traced);
  EXPECT_EQ(built.chosen.at(0).choice.error, 0);
}

TEST(ShadowError, IsOfEachLightAlone) {
  const Built built =
      build(std::string(kSun) + "\nDEF Lamp SpotLight { location 3 8 4 direction -0.36 -1 -0.44 cutOffAngle 0.7 shadows TRUE }",
            request_of(0.01));
  ASSERT_EQ(built.chosen.size(), 2U);
  EXPECT_EQ(built.chosen[0].light, "Sun");
  EXPECT_EQ(built.chosen[1].light, "Lamp");
  for (const ChosenShadow& one : built.chosen) {
    EXPECT_LE(one.choice.error, 0.01);
    EXPECT_EQ(map_of(built, one.choice.map).size(), one.choice.size);
    EXPECT_EQ(map_of(built, one.choice.map).method(), static_cast<PackedShadowMethod>(one.choice.method));
  }
}

TEST(ShadowError, CostsLeastWhereALightReachesNothing) {
  const Built built = build("SpotLight { location 0 5 0 direction 0 1 0 shadows TRUE }", request_of(0.01));
  for (const ChosenShadow& one : built.chosen) EXPECT_EQ(one.choice.size, kSmallestSize);
}

// A shadow half as dark is as true.
TEST(ShadowError, DoesNotDependOnHowDarkAShadowIs) {
  const Built full = build(kSun, request_of(0.01));
  const Built faint =
      build("DEF Sun DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE shadowIntensity 0.3 }", request_of(0.01));
  EXPECT_EQ(faint.chosen.at(0).choice.method, full.chosen.at(0).choice.method);
  EXPECT_EQ(faint.chosen.at(0).choice.size, full.chosen.at(0).choice.size);
}

// Where an effect may move what casts, or Embree is missing, the largest map stands for the truth.
TEST(ShadowError, IsMeasuredAgainstTheLargestMapWhereNothingCanBeTraced) {
  const std::string moving = R"(
Transform { translation 1 1 2 children Shape { appearance Appearance { material Material { }
  effects Effect { parts EffectPart { type "VERTEX" url "data:text/plain,
    void PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) { v.y += 0.2 * v.x; }" } } }
  geometry Box { } } })";
  const SceneFolder folder;
  const auto scene = folder.write("scene.x3dv", scene_text(kSun) + moving);
  const Built built = build_file(scene, request_of(0.01));
  const ChosenShadow& one = built.chosen.at(0);
  EXPECT_FALSE(one.choice.traced_truth);
  EXPECT_EQ(one.why_not_traced, "an effect may move what casts");
  EXPECT_LE(one.choice.error, 0.01);
}

TEST(ShadowError, TheLargestMapIsAsGoodAJudgeAsRays) {
  if (!can_trace()) GTEST_SKIP() << "there are no rays to compare with";
  const Compiled compiled = compile_text(scene_text(kSun));
  const auto scene = load_measured_scene(process_studio(), compiled.bytes, {});
  JudgedScene judged = read_judged_scene(*scene);
  const auto frames = viewpoint_frames(*scene->loaded.packed, 320, 180, 1e9);
  const ShadowConfiguration configuration{PackedShadowMethod::bilinear, 512, 2};
  const LightJudge rays = make_light_judge(process_studio(), *scene, judged, frames, 0);
  const double by_rays = measured_error(process_studio(), *scene, rays, configuration);
  judged.tracer.reset();
  const LightJudge map = make_light_judge(process_studio(), *scene, judged, frames, 0);
  const double by_map = measured_error(process_studio(), *scene, map, configuration);
  EXPECT_NEAR(map.floor_of_texel, rays.floor_of_texel, 0.05 * rays.floor_of_texel);
  EXPECT_GE(by_map, 0.9 * by_rays);
  EXPECT_LE(by_map, 1.3 * by_rays);
}

TEST(ShadowError, ReadsPercentages) {
  EXPECT_DOUBLE_EQ(read_percentage("0.5%").value(), 0.005);
  EXPECT_DOUBLE_EQ(read_percentage("2%").value(), 0.02);
  for (const std::string_view wrong : {"", "%", "0.5", "0%", "-1%", "100%", "nan%", "inf%", "1e-3%", "0.5 %", "0.5%%", "x%"})
    EXPECT_FALSE(read_percentage(wrong)) << wrong;
}

}  // namespace
}  // namespace plugc
