// An effect at which glslang crashes or never ends costs itself and one message; everything beside it is drawn. Both effects
// are short and legal as plugc reads them. A constant of nested structs has 64 times as many components as the one inside of
// it: the fourth needs more memory than a worker may have. To compare one of the third takes long, and each comparison is
// folded; that takes memory as well, but within the test's deadline not all that a worker may have.

#include <chrono>

#include <fmt/format.h>

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// `const S<levels> s<levels>`, of 16 * 64 ^ levels floats.
std::string nested_constants(int levels) {
  std::string code = "const mat4 s0 = mat4(1.0);\n";
  std::string inner = "mat4";
  for (int level = 1; level <= levels; ++level) {
    std::string members = fmt::format("s{}", level - 1);
    for (int i = 1; i < 64; ++i) members += fmt::format(",s{}", level - 1);
    code += fmt::format("struct S{0} {{ {1} a[64]; }};\nconst S{0} s{0} = S{0}({1}[64]({2}));\n", level, inner, members);
    inner = fmt::format("S{}", level);
  }
  return code;
}

std::string crashing_code() {
  return nested_constants(4) + "void PLUG_fragment_modify(inout vec4 c) { c.r = s4.a[0].a[0].a[0].a[0][0][0]; }";
}

std::string endless_code() {
  std::string code = nested_constants(3) + "void PLUG_fragment_modify(inout vec4 c) { ";
  for (int i = 0; i < 5000; ++i) code += "if (s3 == s3) c.r = 0.5; ";
  return code + "}";
}

std::string effect(std::string_view name, std::string_view code) {
  return fmt::format("DEF {} Effect {{ parts EffectPart {{ type \"FRAGMENT\" url \"data:text/plain,\n{}\" }} }}\n", name, code);
}

/// A white box in front of a white sphere; the box has the hostile effect between two others, the sphere has one of those.
std::string scene_with(std::string_view code) {
  const std::string shape =
      "Shape {{ appearance Appearance {{ material UnlitMaterial {{ emissiveColor 1 1 1 }} effects [\n{}] }} geometry {} }}\n";
  const std::string green = effect("Green", "void PLUG_fragment_modify(inout vec4 c) { c.g = 0.5; }");
  const std::string blue = effect("Blue", "void PLUG_fragment_modify(inout vec4 c) { c.b = 0.25; }");
  const std::string hostile = code.empty() ? "" : effect("Hostile", code);
  return "#X3D V4.0 utf8\n" + fmt::format(fmt::runtime(shape), green + hostile + blue, "Box { }") +
         "Transform { translation 3 0 0 children " + fmt::format(fmt::runtime(shape), "USE Green\n", "Sphere { }") + "}\n";
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kMemoryIsLimited = false;  // a sanitizer reserves terabytes
#else
constexpr bool kMemoryIsLimited = true;
#endif

/// What is said of the scene with this effect, and that its picture is the one without it.
void expect_one_death(const std::string& code, std::string_view reason, std::chrono::milliseconds timeout) {
  const SceneFolder folder;
  ValidatorOptions options;
  options.timeout = timeout;
  Validator validator(options);
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions compile_options;
  compile_options.root = folder.path();
  const Compilation made =
      compile({folder.write("scene.x3dv", scene_with(code))}, compile_options, validator, sources, diagnostics);
  std::vector<std::string> said;
  for (const Diagnostic& one : diagnostics.all()) said.push_back(message_line(one, sources, sources.name({0})));
  EXPECT_THAT(
      said,
      ElementsAre(fmt::format("5:13 validation-died the program `phong unlit; effects `Green` `Hostile` `Blue`` cannot be "
                              "validated: {}",
                              reason),
                  "5:13 effect-left-out effect `Hostile` is left out: the program is not valid with it"));
  const Compiled without = compile_text(scene_with(""));
  const std::vector<std::uint8_t> bytes = write_package(made.package);
  EXPECT_EQ(draw_package(*open_package(bytes).package).pixels, draw_package(*without.package).pixels);
}

TEST(WorkerDeaths, ACrashCostsOneEffectOneMessage) {
  if (!kMemoryIsLimited) GTEST_SKIP() << "it would take all the memory that there is";
  expect_one_death(crashing_code(), "glslang crashed on this program", std::chrono::seconds(60));
}

TEST(WorkerDeaths, AHangCostsOneEffectOneMessage) {
  expect_one_death(endless_code(), "glslang took longer than 300 ms on this program", std::chrono::milliseconds(300));
}

}  // namespace
}  // namespace plugc
