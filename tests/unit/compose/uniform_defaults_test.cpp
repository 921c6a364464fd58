#include "compose/uniform_defaults.h"

#include <gmock/gmock.h>

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::Optional;

/// The value of the last global of a fragment part.
std::optional<std::vector<double>> value_of(const std::string& code) {
  MappedText text;
  text.append_generated(code);
  const auto unit = make_code_unit(text, ShaderStage::fragment);
  return initial_value(*unit, unit->outline.globals.back());
}

TEST(UniformDefaults, AreTheNumbersOfTheInitialiser) {
  EXPECT_THAT(value_of("uniform float a = 0.5;"), Optional(ElementsAre(0.5)));
  EXPECT_THAT(value_of("uniform float a = -+-1.5e1f;"), Optional(ElementsAre(15)));
  EXPECT_THAT(value_of("uniform vec3 a = vec3(1, 2.0, 3.);"), Optional(ElementsAre(1, 2, 3)));
  EXPECT_THAT(value_of("uniform vec3 a = vec3(vec2(1.0, 2.0), 3.0) * 2.0 - 1.0;"), Optional(ElementsAre(1, 3, 5)));
  EXPECT_THAT(value_of("uniform vec2 a = vec2(0.5);"), Optional(ElementsAre(0.5, 0.5)));
  EXPECT_THAT(value_of("uniform mat3 a = mat3(2.0);"), Optional(ElementsAre(2, 0, 0, 0, 2, 0, 0, 0, 2)));
  EXPECT_THAT(value_of("uniform bool a = true;"), Optional(ElementsAre(1)));
  EXPECT_THAT(value_of("uniform vec2 a[2] = vec2[2](vec2(1.0), vec2(2.0, 3.0));"), Optional(ElementsAre(1, 1, 2, 3)));
}

TEST(UniformDefaults, DivideIntegersAsGlslDoes) {
  EXPECT_THAT(value_of("uniform int a = -7 / 2;"), Optional(ElementsAre(-3)));
  EXPECT_THAT(value_of("uniform float a = float(7 / 2);"), Optional(ElementsAre(3)));
  EXPECT_THAT(value_of("uniform float a = 7.0 / 2.0;"), Optional(ElementsAre(3.5)));
}

TEST(UniformDefaults, FollowConstantsAndMacrosOfThePart) {
  EXPECT_THAT(value_of("#define TWO 2.0\nconst float half = 1.0 / TWO;\nuniform float a = half + TWO;"),
              Optional(ElementsAre(2.5)));
  EXPECT_EQ(value_of("#define LOOP LOOP\nuniform float a = LOOP;"), std::nullopt);
  EXPECT_EQ(value_of("const float x = y;\nconst float y = x;\nuniform float a = x;"), std::nullopt);
}

TEST(UniformDefaults, GiveUpOnEverythingElse) {
  for (const std::string code :
       {"sqrt(2.0)", "1.0 / 0.0", "0x10", "017", "vec3(1.0, 2.0)", "vec2(1.0).x", "mat3(1.0) * mat3(2.0)", "unknown", "1.0 +",
        "(1.0", "vec3(1.0) + vec2(1.0)", "true ? 1.0 : 0.0", "float[2](vec2(1.0), 2.0)", "1.0 2.0"}) {
    EXPECT_EQ(value_of("uniform float a = " + code + ";"), std::nullopt) << code;
  }
  EXPECT_EQ(value_of("uniform float a;"), std::nullopt);
  EXPECT_EQ(value_of("uniform float a = " + std::string(5000, '(') + "1.0" + std::string(5000, ')') + ";"), std::nullopt);
}

}  // namespace
}  // namespace plugc
