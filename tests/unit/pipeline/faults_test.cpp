// A faulty effect costs its own picture only.

#include <chrono>

#include <fmt/format.h>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string box_with(std::string_view appearance) {
  return fmt::format(
      "#X3D V4.0 utf8\nShape {{ appearance Appearance {{ material Material {{ specularColor 0.5 0.5 0.5 }}\n{} }} geometry Box "
      "{{ }} }}\n",
      appearance);
}

/// A FRAGMENT effect whose code stands on a line of its own, at column 1.
std::string effect(std::string_view name, std::string_view code) {
  return fmt::format("DEF {} Effect {{ parts EffectPart {{ type \"FRAGMENT\" url \"data:text/plain,\n{}\" }} }}\n", name, code);
}

const std::string kRed = effect("Red", "void PLUG_fragment_modify(inout vec4 c) { c.r = 1.0 - c.r; }");
const std::string kBlue = effect("Blue", "void PLUG_fragment_modify(inout vec4 c) { c.b = 0.25 * c.g; }");

std::vector<std::uint8_t> pixels_of(const Compiled& compiled) {
  return draw_package(*compiled.package).pixels;
}

TEST(Faults, OneOfThreeEffectsIsLeftOutAlone) {
  const std::string faulty = effect("Faulty", "void PLUG_fragment_modify(inout vec4 c) { c.g = missing(c.r); }");
  const Compiled healthy = compile_text(box_with("effects [\n" + kRed + kBlue + "]"));
  EXPECT_THAT(healthy.messages(), IsEmpty());
  const std::vector<std::uint8_t> picture = pixels_of(healthy);
  for (const std::string& order : {faulty + kRed + kBlue, kRed + faulty + kBlue, kRed + kBlue + faulty}) {
    const Compiled compiled = compile_text(box_with("effects [\n" + order + "]"));
    EXPECT_THAT(compiled.messages(), testing::Contains(HasSubstr("effect-left-out effect `Faulty` is left out")));
    EXPECT_THAT(compiled.messages(), testing::Not(testing::Contains(HasSubstr("effect `Red`"))));
    EXPECT_EQ(pixels_of(compiled), picture);
  }
}

TEST(Faults, OfTwoThatFailOnlyTogetherTheLaterIsLeftOut) {
  const std::string shade_vector =
      effect("First", "vec3 shade(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.g = 0.5; }");
  const std::string shade_float = effect("Second", "float shade(float x) { return x; }");
  EXPECT_THAT(compile_text(box_with("effects [\n" + shade_vector + kBlue + "]")).messages(), IsEmpty());
  EXPECT_THAT(compile_text(box_with("effects [\n" + shade_float + kBlue + "]")).messages(), IsEmpty());

  const Compiled both = compile_text(box_with("effects [\n" + shade_vector + kBlue + shade_float + "]"));
  EXPECT_THAT(both.messages(),
              testing::Contains(HasSubstr(
                  "effect `Second` is left out: the effects `First`, `Second` fail together, and it is the last of them")));
  EXPECT_EQ(pixels_of(both), pixels_of(compile_text(box_with("effects [\n" + shade_vector + kBlue + "]"))));
}

TEST(Faults, AComposedShaderThatFailsGivesWayToTheBaseShader) {
  constexpr std::string_view kShader = R"(shaders ComposedShader { language "GLSL" parts [
    ShaderPart { type "VERTEX" url "data:text/plain, attribute vec4 castle_Vertex; void main() { gl_Position = castle_Vertex; }" }
    ShaderPart { type "FRAGMENT" url "data:text/plain, void main() { gl_FragColor = vec3(1.0); }" } ] }
  )";
  const Compiled compiled = compile_text(box_with(std::string(kShader) + "effects [\n" + kRed + "]"));
  EXPECT_THAT(compiled.messages(), testing::Contains(HasSubstr("shader-replaced")));
  EXPECT_THAT(compiled.messages(), testing::Not(testing::Contains(HasSubstr("effect-left-out"))));
  EXPECT_EQ(pixels_of(compiled), pixels_of(compile_text(box_with("effects [\n" + kRed + "]"))));
}

TEST(Faults, OfOneShapeLeaveOthersAlone) {
  const std::string scene =
      "#X3D V4.0 utf8\nShape { appearance Appearance { material UnlitMaterial { emissiveColor 1 1 1 } effects\n" +
      effect("Faulty", "void PLUG_fragment_modify(inout vec4 c) { c = 1; }") + "} geometry Box { } }\n" +
      "Shape { appearance Appearance { material UnlitMaterial { emissiveColor 1 0 0 } effects\n" + kBlue +
      "} geometry Sphere { radius 2 } }\n";
  const Compiled compiled = compile_text(scene);
  EXPECT_EQ(compiled.package->scenes()->Get(0)->shapes()->size(), 2U);
  EXPECT_THAT(color_at(draw_package(*compiled.package), 32, 32), IsColor(Color{255, 0, 0}));
}

TEST(Faults, APartOfTooManyTokensIsReportedAndLeftOut) {
  std::string code = "void PLUG_fragment_modify(inout vec4 c) { c.r = 0.0";
  while (code.size() < 500'000) code += "+1";
  const Compiled compiled = compile_text(box_with("effects\n" + effect("Large", code + "; }")));
  EXPECT_THAT(compiled.messages(), ElementsAre(HasSubstr("effect-left-out effect `Large` is left out"),
                                               HasSubstr("shader-limit this part has more than 200000 tokens")));
  EXPECT_EQ(pixels_of(compiled), pixels_of(compile_text(box_with(""))));
}

/// The effect is at fault, and the two beside it draw; with the parent's and the worker's work that takes no time to speak of.
void expect_one_fault(const std::string& code) {
  const auto start = std::chrono::steady_clock::now();
  const Compiled compiled = compile_text(box_with("effects [\n" + kRed + effect("Hostile", code) + kBlue + "]"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << code.substr(0, 60);
  EXPECT_THAT(compiled.messages(), testing::Contains(HasSubstr("effect-left-out effect `Hostile` is left out")))
      << code.substr(0, 60);
  EXPECT_LE(compiled.messages().size(), 3U) << code.substr(0, 60);
  const std::string program = compiled.package->programs()->Get(0)->recipe()->str();
  EXPECT_THAT(program, testing::AllOf(HasSubstr("`Red`"), HasSubstr("`Blue`"), testing::Not(HasSubstr("`Hostile`"))));
}

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

TEST(Faults, HostileCodeCostsItsEffectOnly) {
  const std::string begin = "void PLUG_fragment_modify(inout vec4 c) { ", end = " }\n";
  expect_one_fault(begin + "c.r = 1.0" + repeated("+1.0", 60'000) + ";" + end);
  expect_one_fault(begin + "c.r = " + repeated("-", 100'001) + "1.0;" + end);
  expect_one_fault(begin + "c.r = " + repeated("(", 50'000) + "1.0" + repeated(")", 50'000) + ";" + end);
  expect_one_fault(begin + repeated("{", 30'000) + repeated("}", 30'000) + end);
  expect_one_fault(begin + repeated("if (c.r > 0.5) c.g = 0.0; else ", 20'000) + ";" + end);
  expect_one_fault(begin + "float a[2147483647]; c.r = a[int(c.g)] + missing;" + end);
  expect_one_fault(begin + repeated("c.r = 1.0;", 200'000) + end);
  std::string bomb = "#define A0(x) x + x +\n";
  for (int i = 1; i <= 30; ++i)
    bomb += "#define A" + std::to_string(i) + "(x) A" + std::to_string(i - 1) + "(x) A" + std::to_string(i - 1) + "(x)\n";
  expect_one_fault(bomb + begin + "c.r = A30(1.0) 1.0;" + end);
}

}  // namespace
}  // namespace plugc
