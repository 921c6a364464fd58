#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/limits.h"
#include "glsl/tokens.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The texts of all tokens; markers and directives too.
std::vector<std::string> words(std::string_view text, std::span<const MacroDefinition> predefined = {}) {
  std::vector<std::string> result;
  for (const Token& token : tokenize(text, predefined).tokens) result.emplace_back(token_text(text, token));
  return result;
}

std::vector<TokenKind> kinds(std::string_view text) {
  std::vector<TokenKind> result;
  for (const Token& token : tokenize(text, {}).tokens) result.push_back(token.kind);
  return result;
}

TEST(Tokens, AreLongestMatches) {
  EXPECT_THAT(words("a<<=b>>c<=d++ +e^^f!=g"),
              ElementsAre("a", "<<=", "b", ">>", "c", "<=", "d", "++", "+", "e", "^^", "f", "!=", "g"));
  EXPECT_THAT(words("x>>=1;y=-1;!z&&~w|=v"),
              ElementsAre("x", ">>=", "1", ";", "y", "=", "-", "1", ";", "!", "z", "&&", "~", "w", "|=", "v"));
}

TEST(Tokens, NumbersKeepTheirExponentsAndSuffixes) {
  EXPECT_THAT(words("1.5e-3f 0x1Fu .5 2. 3.lf 7u 1e5+0xe+2"),
              ElementsAre("1.5e-3f", "0x1Fu", ".5", "2.", "3.lf", "7u", "1e5", "+", "0xe", "+", "2"));
  EXPECT_THAT(words("1e+x"), ElementsAre("1", "e", "+", "x"));
  EXPECT_THAT(kinds("v.x .5"), ElementsAre(TokenKind::identifier, TokenKind::symbol, TokenKind::identifier, TokenKind::number));
}

TEST(Tokens, HaveExactPlaces) {
  const auto tokens = tokenize("  vec4 /* c */ a;", {}).tokens;
  ASSERT_EQ(tokens.size(), 3U);
  EXPECT_EQ(tokens[0].begin, 2U);
  EXPECT_EQ(tokens[0].end, 6U);
  EXPECT_EQ(tokens[1].begin, 15U);
  EXPECT_EQ(tokens[2].begin, 16U);
  EXPECT_EQ(tokens[2].end, 17U);
}

TEST(Tokens, CommentsYieldNone) {
  EXPECT_THAT(words("a // b /* c\nd /* e // f */ g"), ElementsAre("a", "d", "g"));
  EXPECT_THAT(words("a // one \\\n two\nb"), ElementsAre("a", "b"));
  EXPECT_THAT(words("a /* PLUGS: x */ // /* PLUG: x (y) */\nb"), ElementsAre("a", "b"));
}

TEST(Tokens, MarkersAreTokens) {
  EXPECT_THAT(words("a /* PLUG: p (b) */ c"), ElementsAre("a", "/* PLUG: p (b) */", "c"));
  EXPECT_THAT(kinds("/*PLUG-DECLARATIONS*/ /*\n VARYING-PASSTHROUGH-GEOMETRY-SHADERS\t*/"),
              ElementsAre(TokenKind::marker, TokenKind::marker));
  EXPECT_THAT(words("/* PLUG-DECLARATIONS here */"), IsEmpty());
}

TEST(Tokens, DirectivesAreWholeLines) {
  EXPECT_THAT(words("#define A 1 // one\nb"), ElementsAre("#define A 1 // one", "b"));
  EXPECT_THAT(words("#define A \\\n 1\r\nb"), ElementsAre("#define A \\\n 1", "b"));
  EXPECT_THAT(words("#define A /* two\nlines */ 1\nb"), ElementsAre("#define A /* two\nlines */ 1", "b"));
  EXPECT_THAT(words("/* c */ # /* d */ define A\nA"), ElementsAre("# /* d */ define A", "A"));
  EXPECT_THAT(words("#define A /* PLUG: p (b) */\nc"), ElementsAre("#define A /* PLUG: p (b) */", "c"));
}

TEST(Tokens, HashInsideALineIsInvalid) {
  EXPECT_THAT(kinds("a # b"), ElementsAre(TokenKind::identifier, TokenKind::invalid, TokenKind::identifier));
}

TEST(Tokens, InvalidBytesAreWholeCodePointsAndStrings) {
  EXPECT_THAT(words("a \xC3\xA9 @ \"b /* c\" d"), ElementsAre("a", "\xC3\xA9", "@", "\"b /* c\"", "d"));
  EXPECT_THAT(kinds("\"open\n;"), ElementsAre(TokenKind::invalid, TokenKind::symbol));
}

TEST(Tokens, UnclosedCommentIsInvalidToTheEnd) {
  EXPECT_THAT(words("a /* b\n c"), ElementsAre("a", "/* b\n c"));
  EXPECT_THAT(words("#define A /* b\n c"), ElementsAre("#define A ", "/* b\n c"));
  EXPECT_THAT(words("#if 0\n/* b\n#endif"), ElementsAre("#if 0", "/* b\n#endif"));
}

TEST(Tokens, DeadBranchesYieldNone) {
  EXPECT_THAT(words("#if 0\na\n#else\nb\n#endif\nc"), ElementsAre("#if 0", "#else", "b", "#endif", "c"));
  EXPECT_THAT(words("#ifdef A\na /* PLUG: p () */\n#endif"), ElementsAre("#ifdef A", "#endif"));
  EXPECT_THAT(words("#if 0\n#if 1\na\n#else\nb\n#endif\n#define C\n#endif\n#ifdef C\nc\n#endif"),
              ElementsAre("#if 0", "#endif", "#ifdef C", "#endif"));
}

TEST(Tokens, OnlyTheFirstTrueBranchLives) {
  EXPECT_THAT(words("#if 0\na\n#elif 1\nb\n#elif 1\nc\n#else\nd\n#endif"),
              ElementsAre("#if 0", "#elif 1", "b", "#elif 1", "#endif"));
}

TEST(Tokens, CommentsInDeadBranchesAreSeen) {
  EXPECT_THAT(words("#if 0\n/*\n#endif\n*/ a\n#endif\nb"), ElementsAre("#if 0", "#endif", "b"));
  EXPECT_THAT(words("#if 0\r\n// /*\r\n#endif\r\nb"), ElementsAre("#if 0", "#endif", "b"));
}

TEST(Tokens, DefinitionsSteerLaterBranches) {
  EXPECT_THAT(words("#define A\n#ifdef A\na\n#endif\n#undef A\n#ifdef A\nb\n#endif"),
              ElementsAre("#define A", "#ifdef A", "a", "#endif", "#undef A", "#ifdef A", "#endif"));
  const MacroDefinition predefined[] = {{"GL_ES", "1"}};
  EXPECT_THAT(words("#ifndef GL_ES\na\n#else\nb\n#endif", predefined), ElementsAre("#ifndef GL_ES", "#else", "b", "#endif"));
}

TEST(Tokens, UnreadableConditionCountsAsTrue) {
  EXPECT_THAT(words("#if (\na\n#else\nb\n#endif"), ElementsAre("#if (", "a", "#else", "#endif"));
  EXPECT_THAT(words("#ifdef\na\n#endif"), ElementsAre("#ifdef", "a", "#endif"));
}

TEST(Tokens, StrayBranchesAreKeptAndObeyNothing) {
  EXPECT_THAT(words("#endif\na\n#else\nb"), ElementsAre("#endif", "a", "#else", "b"));
}

TEST(Tokens, EveryLineEndCounts) {
  EXPECT_THAT(words("#if 0\ra\r#endif\rb"), ElementsAre("#if 0", "#endif", "b"));
  EXPECT_THAT(words("#if 0\r\na\r\n#endif\r\nb\r\n"), ElementsAre("#if 0", "#endif", "b"));
}

TEST(Tokens, AreCutAtTheCap) {
  const std::string many(kMaxShaderTokens + 5, ';');
  const TokenList list = tokenize(many, {});
  EXPECT_TRUE(list.too_many);
  EXPECT_EQ(list.tokens.size(), kMaxShaderTokens);
  EXPECT_FALSE(tokenize(std::string_view(many).substr(0, kMaxShaderTokens), {}).too_many);
}

TEST(Tokens, OfADirectiveLeaveCommentsOut) {
  const std::string_view text = "#define A(x) /* c */ \\\n x * 2 // d";
  std::vector<std::string> result;
  for (const Token& token : directive_tokens(text, tokenize(text, {}).tokens.at(0)))
    result.emplace_back(token_text(text, token));
  EXPECT_THAT(result, ElementsAre("#", "define", "A", "(", "x", ")", "x", "*", "2"));
}

TEST(Tokens, DeepConditionsDoNotRecurse) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "#if 1\n";
  EXPECT_EQ(tokenize(text + "a", {}).tokens.size(), 100'001U);
}

}  // namespace
}  // namespace plugc
