#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>

#include "base/limits.h"
#include "glsl/condition.h"

namespace plugc {
namespace {

std::optional<std::int64_t> evaluate(std::string_view expression) {
  return MacroTable({}).evaluate(expression);
}

TEST(Condition, FollowsThePrecedenceOfOperators) {
  EXPECT_EQ(evaluate("1 + 2 * 3"), 7);
  EXPECT_EQ(evaluate("(1 + 2) * 3"), 9);
  EXPECT_EQ(evaluate("10 - 4 - 3"), 3);
  EXPECT_EQ(evaluate("1 << 2 + 1"), 8);
  EXPECT_EQ(evaluate("1 | 6 & 4 ^ 1"), 5);
  EXPECT_EQ(evaluate("1 == 1 && 2 > 3 || 4 <= 4"), 1);
  EXPECT_EQ(evaluate("!0 + -1 + ~0 + +2"), 1);
  EXPECT_EQ(evaluate("7 % 4 / 2"), 1);
  EXPECT_EQ(evaluate("1 != 2 && 2 >= 2 && 1 < 2 && 16 >> 2 == 4"), 1);
}

TEST(Condition, ReadsNumbersOfEveryBase) {
  EXPECT_EQ(evaluate("0x1F"), 31);
  EXPECT_EQ(evaluate("017"), 15);
  EXPECT_EQ(evaluate("0"), 0);
  EXPECT_EQ(evaluate("12u"), 12);
}

TEST(Condition, HasNoValueWhenItCannotBeRead) {
  for (const char* expression : {"",
                                 "1 +",
                                 "(1",
                                 "1)",
                                 "1 2",
                                 "1.5",
                                 "1 / 0",
                                 "1 % 0",
                                 "1 << 40",
                                 "1 << -1",
                                 "a(1)",
                                 "08",
                                 "0x",
                                 "defined",
                                 "defined(",
                                 "defined(A",
                                 "defined 1",
                                 "@",
                                 "99999999999999999999",
                                 "1 ? 2 : 3"}) {
    EXPECT_EQ(evaluate(expression), std::nullopt) << expression;
  }
}

TEST(Condition, UnknownNamesAreZero) {
  EXPECT_EQ(evaluate("SOMETHING"), 0);
  EXPECT_EQ(evaluate("SOMETHING == 0"), 1);
}

TEST(Condition, VersionIs330UnlessPredefined) {
  EXPECT_EQ(evaluate("__VERSION__"), 330);
  const MacroDefinition predefined[] = {{"__VERSION__", "300"}};
  EXPECT_EQ(MacroTable(predefined).evaluate("__VERSION__"), 300);
}

TEST(Condition, DefinedTakesAnUnexpandedName) {
  MacroTable macros({});
  macros.define("A", " B", false);
  EXPECT_EQ(macros.evaluate("defined A"), 1);
  EXPECT_EQ(macros.evaluate("defined(B) || !defined ( A )"), 0);
  macros.undefine("A");
  EXPECT_EQ(macros.evaluate("defined(A)"), 0);
}

TEST(Condition, ExpandsMacrosAsTokens) {
  MacroTable macros({});
  macros.define("SUM", " ONE + /* one more */ ONE", false);
  macros.define("ONE", " 1 // one", false);
  EXPECT_EQ(macros.evaluate("SUM * 2"), 3);
  EXPECT_EQ(macros.evaluate("(SUM) * 2"), 4);
}

TEST(Condition, MacroIsNotExpandedInsideItself) {
  MacroTable macros({});
  macros.define("A", " B + 1", false);
  macros.define("B", " A + 2", false);
  EXPECT_EQ(macros.evaluate("A"), 3);
}

TEST(Condition, MacroWithParametersHasNoValue) {
  MacroTable macros({});
  macros.define("A", "(x) x", true);
  EXPECT_EQ(macros.evaluate("A(1)"), std::nullopt);
  EXPECT_EQ(macros.evaluate("defined(A)"), 1);
}

TEST(Condition, ExpansionIsBounded) {
  std::vector<std::string> names;
  std::vector<std::string> values;
  for (int i = 0; i < 30; ++i) names.push_back(fmt::format("M{}", i));
  for (int i = 0; i < 30; ++i) values.push_back(i == 0 ? "1" : fmt::format("M{0} + M{0}", i - 1));
  MacroTable macros({});
  for (int i = 0; i < 30; ++i) macros.define(names[i], values[i], false);
  EXPECT_EQ(macros.evaluate("M10"), 1024);
  EXPECT_EQ(macros.evaluate("M29"), std::nullopt);
  EXPECT_EQ(macros.evaluate("1"), std::nullopt) << "the budget is one for all conditions of a text";
}

TEST(Condition, NestingIsBounded) {
  const std::size_t fits = kMaxExpressionNesting - 1;
  EXPECT_EQ(evaluate(std::string(fits, '(') + "1" + std::string(fits, ')')), 1);
  EXPECT_EQ(evaluate(std::string(100'000, '(') + "1" + std::string(100'000, ')')), std::nullopt);
  EXPECT_EQ(evaluate(std::string(100'000, '!') + "1"), std::nullopt);
}

TEST(Condition, OverflowWrapsAround) {
  EXPECT_EQ(evaluate("9223372036854775807 + 1 < 0"), 1);
  EXPECT_EQ(evaluate("(-9223372036854775807 - 1) / -1 < 0"), 1);
  EXPECT_EQ(evaluate("(-9223372036854775807 - 1) % -1"), 0);
}

}  // namespace
}  // namespace plugc
