// Code that grows in a compiler is found before one sees it.
#include "glsl/shader_size.h"

#include <gtest/gtest.h>

#include <string>

namespace plugc {
namespace {

std::string problem(const std::string& text) {
  const auto found = find_size_problem(text, tokenize(text, {}));
  return found ? std::to_string(found->begin) + ": " + found->message : "";
}

std::string bomb(const std::string& parameters, const std::string& use, int steps) {
  std::string text = "#define A0" + parameters + " 1.0 +\n";
  for (int i = 1; i <= steps; ++i) {
    const std::string before = "A" + std::to_string(i - 1) + use;
    text += "#define A" + std::to_string(i) + parameters + " " + before + " " + before + "\n";
  }
  return text;
}

constexpr std::string_view kTooMany = "macros make more than 200000 tokens of this part";

TEST(ShaderSize, TakesOrdinaryMacros) {
  EXPECT_EQ(problem("#define PI 3.14\n#define SQUARE(x) ((x) * (x))\nfloat a = SQUARE(SQUARE(PI + 1.0));\n"), "");
  EXPECT_EQ(problem("#define A A\n#define F(x) F(x) A\nfloat a = F(F(A));\n"), "");
}

TEST(ShaderSize, MeasuresWhatMacrosMakeOfEachOther) {
  const std::string small = bomb("", "", 10);
  EXPECT_EQ(problem(small + "float a = A10 1.0;\n"), "");
  const std::string large = bomb("", "", 40);
  EXPECT_EQ(problem(large), "");  // nothing uses it
  EXPECT_NE(problem(large + "float a = A40 1.0;\n").find(kTooMany), std::string::npos);
  EXPECT_NE(problem(large + "#if A40 1\n#endif\n").find(kTooMany), std::string::npos);
}

TEST(ShaderSize, MeasuresArguments) {
  const std::string large = bomb("(x)", "(x)", 40);
  EXPECT_NE(problem(large + "float a = A40(0) 1.0;\n").find(kTooMany), std::string::npos);
  std::string nested = "#define F(x) x x x x\nfloat a = ", end;
  for (int i = 0; i < 30; ++i) {
    nested += "F(";
    end += ")";
  }
  EXPECT_NE(problem(nested + "1" + end + ";\n").find(kTooMany), std::string::npos);
}

TEST(ShaderSize, SurvivesLongChainsOfMacros) {
  std::string chain = "#define A0 1.0\n";
  for (int i = 1; i < 20'000; ++i) chain += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + "\n";
  EXPECT_NE(problem(chain + "float a = A19999;\n"), "");
  EXPECT_EQ(problem(chain + "float a = A300;\n"), "");
}

TEST(ShaderSize, CountsTheOperatorsOfAnExpression) {
  const auto sum = [](std::size_t terms) {
    std::string text = "float a = 1.0";
    for (std::size_t i = 1; i < terms; ++i) text += "+1.0";
    return text + ";\n";
  };
  EXPECT_EQ(problem(sum(1'500)), "");
  EXPECT_EQ(problem(sum(60'000)), "8009: an expression has more than 2000 operators here");
  std::string table = "const float t[5000] = float[5000](0.5";
  for (int i = 1; i < 5'000; ++i) table += ", -0.5";
  EXPECT_EQ(problem(table + ");\n"), "");
}

}  // namespace
}  // namespace plugc
