#include "validate/verdict.h"

#include <gmock/gmock.h>

#include "tests/unit/validate/programs.h"
#include "validate/glslang_log.h"

namespace plugc {
namespace {

using testing::ElementsAre;

std::vector<std::string> shown(const std::vector<VerdictMessage>& messages) {
  std::vector<std::string> lines;
  for (const VerdictMessage& message : messages) {
    lines.push_back(fmt::format("{} {} <{}>: {}", to_text(message.stage), message.line, message.token, message.text));
  }
  return lines;
}

TEST(Verdict, SurvivesTheWay) {
  Verdict verdict;
  verdict.messages = {{ShaderStage::geometry, 12, "foo", "text"}};
  verdict.uniforms = {{"a", "vec3", 1}, {"b", "float", 4}};
  verdict.attributes = {{"position", "vec3", 1}};
  verdict.spirv = {{1, 2, 3}, {}};
  const std::optional<Verdict> read = decode_verdict(encode(verdict));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(encode(*read), encode(verdict));
  EXPECT_EQ(read->uniforms[1].count, 4u);
  EXPECT_EQ(read->spirv, verdict.spirv);
}

TEST(Verdict, IsNotReadFromPartsOrNoise) {
  Verdict verdict;
  verdict.messages = {{ShaderStage::geometry, 12, "foo", "text"}};
  verdict.spirv = {{1, 2, 3}};
  const std::string bytes = encode(verdict);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(decode_verdict(bytes.substr(0, size)).has_value()) << size;
  EXPECT_FALSE(decode_verdict(bytes + "x").has_value());
  EXPECT_FALSE(decode_verdict(std::string(64, '\xFF')).has_value());
  EXPECT_FALSE(decode_candidate(std::string(64, '\xFF')).has_value());
}

TEST(Verdict, ACandidateIsItsTargetAndTexts) {
  const std::optional<Candidate> candidate = decode_candidate(encode(good_program()));
  ASSERT_TRUE(candidate.has_value());
  EXPECT_EQ(candidate->stages[0].text, kVertex);
  EXPECT_EQ(encode(*candidate), encode(good_program()));
  EXPECT_NE(encode(program_of(kVertex, kFragment, Target::spirv)), encode(good_program()));
}

TEST(GlslangLog, GivesErrorsWithoutWarningsSummariesAndRepeats) {
  EXPECT_THAT(shown(read_glslang_log("WARNING: 0:3: 'x' : hm\n"
                                     "ERROR: 0:12: 'foo' : undeclared identifier \n"
                                     "ERROR: 0:12: 'foo' : undeclared identifier \n"
                                     "ERROR: 0:14: '' :  syntax error, unexpected SEMICOLON\n"
                                     "ERROR: 3 compilation errors.  No code generated.\n\n",
                                     ShaderStage::vertex)),
              ElementsAre("vertex 12 <foo>: `foo`: undeclared identifier", "vertex 14 <>: syntax error, unexpected SEMICOLON"));
}

TEST(GlslangLog, JoinsTheLinkersDetails) {
  EXPECT_THAT(
      shown(read_glslang_log("ERROR: Linking vertex and geometry stages: Types must match:\n"
                             "    vertex stage: \" vec3 n\"\n    geometry stage: \" vec2 n[3]\"\n"
                             "ERROR: Linking vertex stage: Recursion detected:\n    a( calling b(\n",
                             ShaderStage::fragment)),
      ElementsAre("geometry 0 <>: vertex and geometry stages: Types must match: vertex stage: \" vec3 n\" geometry stage: \" "
                  "vec2 n[3]\"",
                  "vertex 0 <a>: vertex stage: Recursion detected: a( calling b("));
}

TEST(GlslangLog, SaysSoWhenItLeavesErrorsOut) {
  std::string log;
  for (int i = 1; i <= 500; ++i) log += fmt::format("ERROR: 0:{}: 'x' : no\n", i);
  const std::vector<VerdictMessage> messages = read_glslang_log(log, ShaderStage::vertex);
  ASSERT_EQ(messages.size(), 101u);
  EXPECT_EQ(messages.back().text, "there are more than 100 errors; the rest is left out");
}

}  // namespace
}  // namespace plugc
