// A light whose shadow can be seen nowhere costs what it costs without shadows: the same programs to the byte, so the same
// SPIR-V instructions, and frames of the same passes and draw calls.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "boxes_scene.h"
#include "stage.h"

namespace plugc {
namespace {

const std::string kGround =
    "Shape { appearance DEF Grey Appearance { material Material { } } geometry IndexedFaceSet { coordIndex [0 1 2 3 -1] "
    "coord Coordinate { point [-30 0 30, 30 0 30, 30 0 -30, -30 0 -30] } } }\n";
const std::string kBoxes = box("Tower", "translation 0 0.5 0", "1 1 1") + box("Stone", "translation 4 0.5 0", "1 1 1");

/// `fields` go into the light, `shapes` behind it. Everything stands still.
std::string still_scene(std::string_view light, std::string_view fields, const std::string& shapes) {
  return fmt::format(
      "#X3D V4.0 utf8\nPROFILE Full\nNavigationInfo {{ headlight FALSE }}\n"
      "Viewpoint {{ position 5 5 9 orientation -0.73 0.65 0.2 0.68 }}\n{} {} }}\n{}",
      light, fields, shapes);
}

std::uint32_t instructions(const Compiled& compiled) {
  std::uint32_t sum = 0;
  for (const ProgramCosts& costs : compiled.costs) {
    EXPECT_TRUE(costs.whole.has_value());
    if (costs.whole)
      sum += costs.whole->vertex_instructions + costs.whole->geometry_instructions + costs.whole->fragment_instructions;
  }
  return sum;
}

/// What a scene comes to: its programs, and its first frame.
struct Cost {
  std::vector<std::string> texts;
  std::uint32_t instructions = 0;
  FrameStatistics frame;
};

Cost cost_of(const std::string& scene) {
  CompileOptions options;
  options.measure = true;
  Compiled compiled = compile_text(scene, options);
  Cost cost{program_texts(compiled), instructions(compiled), {}};
  Stage stage(std::move(compiled));
  stage.draw();
  cost.frame = stage.statistics();
  return cost;
}

void expect_free(std::string_view light, std::string_view fields, const std::string& shapes) {
  const std::string lit_only = fmt::format("{} shadows FALSE", fields);
  const std::string shadowing = fmt::format("{} shadows TRUE", fields);
  const Cost without = cost_of(still_scene(light, lit_only, shapes));
  const Cost with = cost_of(still_scene(light, shadowing, shapes));
  EXPECT_GT(without.instructions, 0U);
  EXPECT_EQ(with.instructions, without.instructions);
  EXPECT_EQ(with.texts, without.texts);
  EXPECT_EQ(with.frame.draw_calls, without.frame.draw_calls);
  EXPECT_EQ(with.frame.programs_used, without.frame.programs_used);
  EXPECT_EQ(with.frame.shadow_passes + with.frame.shadow_draw_calls + with.frame.shadow_filter_passes, 0U);
}

struct Kind {
  const char* name;
  const char* light;  ///< Without its closing bracket. Straight above the boxes: neither stands before the other.
  ShadowMethod other_method;
};
constexpr Kind kKinds[] = {
    {"Sun", "DEF Lamp DirectionalLight { direction 0 -1 0", ShadowMethod::evsm},
    {"Spot", "DEF Lamp SpotLight { location 2 9 0 direction 0 -1 0 radius 100", ShadowMethod::msm},
    {"Point", "DEF Lamp PointLight { location 2 9 0 radius 100", ShadowMethod::pcf3},
};

class NoCost : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(ShadowStability, NoCost, testing::ValuesIn(kKinds), [](const auto& one) { return one.param.name; });

TEST_P(NoCost, OfShadowsThatAreSeenIsMeasured) {
  const Cost without = cost_of(still_scene(GetParam().light, "", kGround + kBoxes));
  const Cost with = cost_of(still_scene(GetParam().light, "shadows TRUE", kGround + kBoxes));
  EXPECT_GT(with.instructions, without.instructions);
  EXPECT_GT(with.frame.shadow_passes, 0U);
}

TEST_P(NoCost, WhereNoCasterIsBetween) {
  expect_free(GetParam().light, "", kGround);
}

TEST_P(NoCost, OfBlendedCasters) {
  const std::string glass =
      "Transform { translation 0 2 0 children Shape { appearance Appearance { material Material { transparency 0.5 } } "
      "geometry Box { } } }\n";
  expect_free(GetParam().light, "", kGround + glass);
}

TEST_P(NoCost, WithShadowIntensityZero) {
  expect_free(GetParam().light, "shadowIntensity 0", kGround + kBoxes);
}

TEST_P(NoCost, WhereEverythingIsUnlit) {
  const std::string unlit =
      "Shape { appearance DEF Grey Appearance { material UnlitMaterial { } } geometry IndexedFaceSet { coordIndex [0 1 2 3 -1] "
      "coord Coordinate { point [-30 0 30, 30 0 30, 30 0 -30, -30 0 -30] } } }\n";
  expect_free(GetParam().light, "", unlit + kBoxes);
}

TEST(ShadowStability, ALightThatReachesNoReceiverCostsNothing) {
  expect_free("DEF Lamp SpotLight { location 2 9 0 direction 0 -1 0 radius 3", "", kGround + kBoxes);
  expect_free("DEF Lamp PointLight { location 2 9 0 radius 3", "", kGround + kBoxes);
}

/// Fields of `light` that may change, each at a value at which its shadow cannot be seen.
std::vector<std::pair<const char*, double>> dark_values() {
  return {{"Lamp.on", 0}, {"Lamp.intensity", 0}, {"Lamp.shadowIntensity", 0}};
}

TEST_P(NoCost, OfAFrameWhileALightThatMayChangeHasNoShadow) {
  for (const ShadowMethod method : {ShadowMethod::bilinear, GetParam().other_method}) {
    CompileOptions options;
    options.dynamic = {"Lamp.on", "Lamp.intensity", "Lamp.shadowIntensity"};
    options.shadows.method = method;
    Stage stage(compile_text(still_scene(GetParam().light, "shadows TRUE", kGround + kBoxes), options));
    for (const auto& [field, dark] : dark_values()) {
      stage.set(field, {dark});
      stage.draw();
      EXPECT_EQ(stage.statistics().shadow_passes + stage.statistics().shadow_filter_passes, 0U)
          << field << ", " << to_text(method);
      stage.set(field, {1});
      const FloatPicture again = stage.draw();
      EXPECT_NE(again.values, stage.draw(false).values) << field << ": the shadow is back";
    }
  }
}

/// Passes of the first frame of a black light.
std::uint32_t passes_when_black(std::string_view light_fields, const std::string& shapes) {
  CompileOptions options;
  options.dynamic = {"Lamp.intensity"};
  Stage stage(compile_text(still_scene(kKinds[0].light, fmt::format("shadows TRUE {}", light_fields), shapes), options));
  stage.set("Lamp.intensity", {0});
  stage.draw();
  return stage.statistics().shadow_passes;
}

TEST(ShadowStability, ABlackLightKeepsItsMapWhereItsShadowCanBeSeen) {
  EXPECT_EQ(passes_when_black("", kGround + kBoxes), 0U);
  EXPECT_EQ(passes_when_black("ambientIntensity 0.5", kGround + kBoxes), 1U) << "its ambient term is left";
  const std::string glow =
      "effects Effect { parts EffectPart { type \"LIGHT\" url \"data:text/plain,void PLUG_material_light_diffuse(inout vec4 "
      "diffuse, const in vec4 vertex_eye, const in vec3 normal_eye) { diffuse.r += 0.5; }\" } }";
  EXPECT_EQ(passes_when_black(glow, kGround + kBoxes), 1U) << "an effect adds light, which the shadow takes away";
  const std::string sees =
      "Shape { appearance Appearance { material UnlitMaterial { } texture GeneratedShadowMap { light USE Lamp update "
      "\"ALWAYS\" } } geometry Box { size 9 9 9 } }\n";
  EXPECT_EQ(passes_when_black("", kGround + kBoxes + sees), 1U) << "a texture shows the map";
}

}  // namespace
}  // namespace plugc
