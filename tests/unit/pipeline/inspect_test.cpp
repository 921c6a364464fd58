// What `plugc inspect` finds out by compiling more than once: costs of effects, and orders that matter.

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/compile_text.h"

namespace plugc {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// What plugc prints about this scene; it must end well.
std::string inspected(std::string_view scene, std::string_view arguments) {
  const SceneFolder folder;
  folder.write("scene.x3dv", scene);
  const std::string command = fmt::format("cd {} && PLUGC_CACHE_DIR=cache {} inspect scene.x3dv {} >out.txt 2>err.txt",
                                          folder.path().string(), PLUGC_CLI, arguments);
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream stream(folder.path() / "out.txt");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A sphere with these effects on its appearance; each is a fragment part behind its fields.
std::string sphere_with(std::initializer_list<std::array<std::string_view, 3>> effects) {
  std::string list;
  for (const auto& [name, fields, code] : effects) {
    list += fmt::format(
        "DEF {} Effect {{ language \"GLSL\" {} parts EffectPart {{ type \"FRAGMENT\" url \"data:text/plain,\n{}\" }} }}\n",
        name, fields, code);
  }
  return fmt::format(
      "#X3D V4.0 utf8\nViewpoint {{ position 0 0 4 }}\nShape {{ appearance Appearance {{ material Material {{ }} effects "
      "[\n{}] }} "
      "geometry Sphere {{ }} }}\n",
      list);
}

constexpr std::array<std::string_view, 3> kHalve = {
    "Halve", "inputOutput SFFloat amount 0.5",
    "uniform float amount; void PLUG_fragment_modify(inout vec4 c) { c.rgb *= amount; }"};
constexpr std::array<std::string_view, 3> kTint = {
    "Tint", "inputOutput SFColor tint 1 0.5 0.25",
    "uniform vec3 tint; void PLUG_fragment_modify(inout vec4 c) { c.rgb *= tint; }"};
constexpr std::array<std::string_view, 3> kLift = {
    "Lift", "inputOutput SFFloat amount 0.2",
    "uniform float amount; void PLUG_fragment_modify(inout vec4 c) { c.rgb += amount; }"};

TEST(InspectOrders, TwoMultiplicationsCommute) {
  EXPECT_EQ(inspected(sphere_with({kHalve, kTint}), "--orders"),
            "1 pairs of effects meet at a plug\n`Halve`, `Tint` at fragment_modify: commute\n");
}

TEST(InspectOrders, AMultiplicationAndAnAdditionDoNot) {
  EXPECT_THAT(inspected(sphere_with({kHalve, kLift}), "--orders"),
              ContainsRegex("`Halve`, `Lift` at fragment_modify: differ by up to [0-9]+ of 255 at [0-9]+ of 4096 pixels"));
}

TEST(InspectOrders, OtherFieldValuesShowWhatTheScenesOwnHide) {
  std::array<std::string_view, 3> nothing_added = kLift;
  nothing_added[1] = "inputOutput SFFloat amount 0";
  EXPECT_THAT(inspected(sphere_with({kHalve, nothing_added}), "--orders"),
              ContainsRegex("`Lift` at fragment_modify: differ by up to .* other field values"));
}

TEST(InspectOrders, EachPairIsJudgedBesideTheOthers) {
  const std::string said = inspected(sphere_with({kHalve, kTint, kLift}), "--orders");
  EXPECT_THAT(said, HasSubstr("3 pairs"));
  EXPECT_THAT(said, HasSubstr("`Halve`, `Tint` at fragment_modify: commute\n"));
  EXPECT_THAT(said, HasSubstr("`Halve`, `Lift` at fragment_modify: differ"));
  EXPECT_THAT(said, HasSubstr("`Tint`, `Lift` at fragment_modify: differ"));
}

TEST(InspectOrders, AnInvisiblePairIsNotSaidToCommute) {
  const std::array<std::string_view, 3> first = {"First", "", "void PLUG_fragment_modify(inout vec4 c) { c.r *= 1.0; }"};
  const std::array<std::string_view, 3> second = {"Second", "", "void PLUG_fragment_modify(inout vec4 c) { c.g += 0.0; }"};
  EXPECT_THAT(inspected(sphere_with({first, second}), "--orders"),
              HasSubstr("`First`, `Second` at fragment_modify: cannot be told: the picture shows neither\n"));
}

TEST(InspectOrders, EffectsOfDifferentPlugsMakeNoPair) {
  const std::array<std::string_view, 3> other = {
      "Other", "", "void PLUG_lighting_apply(inout vec4 c, const vec4 v, const vec3 n) { c.r = 1.0; }"};
  EXPECT_EQ(inspected(sphere_with({kHalve, other}), "--orders"), "0 pairs of effects meet at a plug\n");
}

TEST(InspectProgram, TellsWhatEachEffectCosts) {
  const std::array<std::string_view, 3> paint = {"Paint", "", "void PLUG_fragment_modify(inout vec4 c) { c = vec4(0.5); }"};
  const std::string said = inspected(sphere_with({kHalve, paint}), "--program 0");
  EXPECT_THAT(said, ContainsRegex("cost, optimised +vertex +geometry +fragment +texture reads +varyings"));
  EXPECT_THAT(said, ContainsRegex("`Halve` +\\+0 +\\+0 +\\+0 +\\+0 +\\+0\n")) << "what another effect overwrites costs nothing";
  EXPECT_THAT(said, ContainsRegex("`Paint` +-[0-9]+ +\\+0 +-[0-9]+ +\\+0 +-[0-9]+\n")) << "it makes the lighting dead";
}

TEST(InspectProgram, SaysWhichEffectsOthersNeed) {
  const std::array<std::string_view, 3> library = {"Library", "", "float half_of(float x) { return 0.5 * x; }"};
  const std::array<std::string_view, 3> user = {
      "User", "", "float half_of(float x); void PLUG_fragment_modify(inout vec4 c) { c.r = half_of(c.r); }"};
  const std::string said = inspected(sphere_with({library, user}), "--program 0");
  EXPECT_THAT(said, ContainsRegex("`Library` +others need it"));
  EXPECT_THAT(said, Not(ContainsRegex("`User` +others need it")));
}

TEST(InspectProgram, WritesJson) {
  const auto json = nlohmann::json::parse(inspected(sphere_with({kHalve}), "--program 0 --format json"));
  EXPECT_EQ(json["shapes"], nlohmann::json::array({"Sphere"}));
  EXPECT_EQ(json["plugs_filled"], nlohmann::json::array({"fragment_modify"}));
  EXPECT_EQ(json["cost"]["effects"][0]["effect"], "Halve");
  EXPECT_GT(json["cost"]["whole"]["fragment_instructions"], json["cost"]["effects"][0]["without"]["fragment_instructions"]);
  EXPECT_EQ(json["uniforms"][0]["name"], "amount");
  EXPECT_THAT(json["uniforms"][0]["source"].get<std::string>(), HasSubstr("`Halve.amount`"));
  EXPECT_EQ(json["targets"][0]["stages"][0]["stage"], "vertex");
  EXPECT_THAT(nlohmann::json::parse(inspected(sphere_with({kHalve}), "--dump programs --format json")), testing::SizeIs(1));
}

}  // namespace
}  // namespace plugc
