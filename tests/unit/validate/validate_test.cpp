#include "validate/validate.h"

#include <gmock/gmock.h>

#include "base/limits.h"
#include "tests/unit/validate/programs.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// One worker for all tests that leave it alive.
class Validate : public testing::Test {
 protected:
  static void SetUpTestSuite() { validator_ = new Validator({}); }
  static void TearDownTestSuite() { delete std::exchange(validator_, nullptr); }
  static Validator& validator() { return *validator_; }
  static std::vector<std::string> messages(const ProgramText& program) { return messages_of(*validator_, program); }

 private:
  static inline Validator* validator_ = nullptr;
};

TEST_F(Validate, AcceptsAProgramAndReflectsWhatIsActive) {
  const ValidationResult result = validate_one(validator(), good_program());
  ASSERT_TRUE(result.program.has_value()) << shown(result, good_program()).front();
  EXPECT_THAT(result.messages, IsEmpty());
  EXPECT_FALSE(result.died);
  EXPECT_EQ(result.program->target(), Target::glsl330);
  EXPECT_EQ(result.program->stages()[1].text.text(), kFragment);
  EXPECT_THAT(shown(result.program->uniforms()),
              ElementsAre("ivec2 lights[0].cell", "vec3 lights[1].color", "bool on", "mat4 projection",
                          "sampler2DShadow shadow_map", "mat3x2 shear", "float weights[4]"));
  EXPECT_THAT(shown(result.program->attributes()), ElementsAre("vec3 position", "vec2 tex_coord[2]"));
  EXPECT_THAT(result.program->spirv(), IsEmpty());
}

TEST_F(Validate, NamesLineAndTokenOfEveryError) {
  const ProgramText program = plain_program("  float a = foo;\n  bar(1);\n  vec2 v = vec3(1.0);\n  int i = 1; i += 2.5;");
  EXPECT_THAT(messages(program), ElementsAre("fragment 4 <foo>: `foo`: undeclared identifier",
                                             "fragment 5 <bar>: `bar`: no matching overloaded function found",
                                             "fragment 6 <=>: `=`: cannot convert from ' const 3-component vector of float' to "
                                             "' temp 2-component vector of float'",
                                             "fragment 7 <int i = 1; i += 2.5;>: `assign`: cannot convert from ' const float' "
                                             "to ' temp int'"));
}

TEST_F(Validate, MeansTheLineWhereTheTokenDoesNotStand) {
  EXPECT_THAT(messages(plain_program("  int i = 1; i += 2.5;  ")),
              ElementsAre("fragment 4 <int i = 1; i += 2.5;>: `assign`: cannot convert from ' const float' to ' temp int'"));
}

TEST_F(Validate, FindsATokenAsAWholeWord) {
  EXPECT_THAT(messages(plain_program("  float fools = 1.0; fools = foo;")),
              ElementsAre("fragment 4 <foo>: `foo`: undeclared identifier"));
}

TEST_F(Validate, RefusesExpressionsThatWouldEndADriversStack) {
  std::string chain = "  float a = 0.5; color.r = a";
  for (int i = 0; i < 5000; ++i) chain += "+a";
  EXPECT_THAT(messages(plain_program(chain + ";")),
              ElementsAre("fragment 0 <>: an expression nests more than 2000 deep, which crashes drivers"));
}

TEST_F(Validate, ReportsErrorsOfAllStages) {
  const ProgramText program = program_of("#version 330 core\nvoid main() { gl_Position = a; }\n", fragment_with("b;"));
  const std::vector<std::string> said = messages(program);
  ASSERT_GE(said.size(), 2u);
  EXPECT_EQ(said.front(), "vertex 2 <a>: `a`: undeclared identifier");
  EXPECT_EQ(said.back(), "fragment 4 <b>: `b`: undeclared identifier");
}

TEST_F(Validate, LeadsToTheAuthorsPlace) {
  SourceSet sources;
  const std::string author = "ecmascript:\n  float a = 1.0; a = typo;\n";
  const SourceId id = sources.add("effect.x3dv", author);
  ProgramText program = program_of(kPlainVertex, "#version 330 core\nout vec4 color;\nvoid main() {\n");
  MappedText& text = program.stages[1].text;
  text.append("  float a = 1.0; a = typo;\n", id, 12);
  text.append_generated("  generated;\n}\n");
  const ValidationResult result = validate_one(validator(), program);
  ASSERT_EQ(result.messages.size(), 2u);
  EXPECT_EQ(sources.text(result.messages[0].span), "typo");
  EXPECT_EQ(sources.position(id, result.messages[0].span.begin).line, 2u);
  EXPECT_EQ(sources.position(id, result.messages[0].span.begin).column, 22u);
  EXPECT_EQ(result.messages[1].line, 5u);
  EXPECT_FALSE(result.messages[1].span.valid());
}

TEST_F(Validate, ReportsWhatTheLinkerRejects) {
  const ProgramText mismatch =
      program_of("#version 330 core\nout vec3 v;\nvoid main() { v = vec3(1.0); gl_Position = vec4(v, 1.0); }\n",
                 "#version 330 core\nin vec2 v;\nout vec4 color;\nvoid main() { color = vec4(v, v); }\n");
  EXPECT_THAT(messages(mismatch), ElementsAre("fragment 0 <v>: vertex and fragment stages: Types must match: "
                                              "vertex stage: \" vec3 v\" fragment stage: \" vec2 v\""));
  const ProgramText bodiless = program_of(
      kPlainVertex, "#version 330 core\nfloat f(float x);\nout vec4 color;\nvoid main() { color = vec4(f(1.0)); }\n");
  EXPECT_THAT(messages(bodiless), ElementsAre("fragment 0 <f>: fragment stage: No function definition (body) found: f(f1;"));
}

TEST_F(Validate, RejectsAnInputThatNoStageWrites) {
  const ProgramText program = program_of(kPlainVertex,
                                         "#version 330 core\nin vec2 found;\nin vec2 unused;\nout vec4 color;\n"
                                         "void main() {\n  color = vec4(found, gl_FragCoord.xy);\n}\n");
  EXPECT_THAT(messages(program),
              ElementsAre("fragment 6 <found>: `found`: the fragment stage reads it, but the vertex stage has no such output"));
}

TEST_F(Validate, AcceptsInputsThroughAGeometryStageAndBlocks) {
  const std::string geometry =
      "#version 330 core\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
      "in Varyings { vec3 normal; } v_in[];\nout vec3 normal;\n"
      "void main() { normal = v_in[0].normal; gl_Position = gl_in[0].gl_Position; EmitVertex(); }\n";
  const ProgramText program =
      program_of({{ShaderStage::vertex,
                   "#version 330 core\nout Varyings { vec3 normal; } v;\nvoid main() { v.normal = vec3(1.0); gl_Position = "
                   "vec4(1.0); }\n"},
                  {ShaderStage::geometry, geometry},
                  {ShaderStage::fragment,
                   "#version 330 core\nin vec3 normal;\nout vec4 color;\nvoid main() { color = vec4(normal, 1.0); }\n"}});
  EXPECT_THAT(messages(program), IsEmpty());
}

TEST_F(Validate, KeepsLinesRightBehindALineDirective) {
  EXPECT_THAT(messages(plain_program("#line 100 7\n  foo;")), ElementsAre("fragment 5 <foo>: `foo`: undeclared identifier"));
}

TEST_F(Validate, HoldsATextToItsTarget) {
  const auto with_version = [](const std::string& version) {
    return program_of(kPlainVertex, version + "out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  };
  EXPECT_THAT(
      messages(with_version("// comment\n#version 450 core\n")),
      ElementsAre("fragment 2 <#version>: `#version 450 core` does not fit target glsl330, which needs `#version 140` to "
                  "`#version 330 core`"));
  EXPECT_THAT(messages(with_version("")),
              ElementsAre("fragment 0 <>: there is no `#version`; target glsl330 needs `#version 140` "
                          "to `#version 330 core`"));
  ProgramText embedded = with_version("#version 330 core\n");
  embedded.target = Target::essl300;
  EXPECT_THAT(messages(embedded),
              ElementsAre("vertex 1 <#version>: `#version 330 core` does not fit target essl300, which needs "
                          "`#version 300 es`",
                          "fragment 1 <#version>: `#version 330 core` does not fit target essl300, which "
                          "needs `#version 300 es`"));
}

TEST_F(Validate, RejectsWhatADriverWouldReadOtherwise) {
  ProgramText program = plain_program("");
  program.stages[1].text.append_generated(std::string("// a\0b", 6));
  EXPECT_THAT(messages(program), ElementsAre("fragment 7 <// a" + std::string(1, '\0') + "b>: the text holds a zero byte"));
}

TEST_F(Validate, RejectsAProgramOfNothingAndOneTooLarge) {
  EXPECT_THAT(messages(program_of({})), ElementsAre("vertex 0 <>: the program has no stage"));
  EXPECT_THAT(messages(plain_program(std::string(kMaxStageBytes, ' '))),
              ElementsAre("fragment 0 <>: the text has 4194374 bytes, plugc takes 4194304"));
}

TEST_F(Validate, JudgesEssl300) {
  const std::string vertex = "#version 300 es\nin vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n";
  const ProgramText good = program_of(vertex,
                                      "#version 300 es\nprecision highp float;\nuniform vec3 tint;\nout vec4 color;\nvoid "
                                      "main() { color = vec4(tint, 1.0); }\n",
                                      Target::essl300);
  const ValidationResult result = validate_one(validator(), good);
  ASSERT_TRUE(result.program.has_value());
  EXPECT_THAT(shown(result.program->uniforms()), ElementsAre("vec3 tint"));
  const ProgramText imprecise =
      program_of(vertex, "#version 300 es\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n", Target::essl300);
  EXPECT_THAT(messages(imprecise), ElementsAre("fragment 2 <out vec4 color;>: `float`: type requires declaration of default "
                                               "precision qualifier"));
}

TEST_F(Validate, MakesSpirv) {
  const ValidationResult result = validate_one(validator(), program_of(kVertex, kFragment, Target::spirv));
  ASSERT_TRUE(result.program.has_value()) << shown(result, good_program()).front();
  ASSERT_EQ(result.program->spirv().size(), 2u);
  for (const std::vector<std::uint32_t>& words : result.program->spirv()) EXPECT_EQ(words.front(), 0x07230203u);
  EXPECT_THAT(shown(result.program->attributes()), ElementsAre("vec3 position", "vec2 tex_coord[2]"));
}

TEST_F(Validate, AnswersInOrderAndJudgesEqualTextsAlike) {
  std::vector<ProgramText> programs;
  for (const char* lines : {"a;", "", "b;", "a;"}) programs.push_back(plain_program(lines));
  const std::vector<ProgramText> asked = programs;
  const std::vector<ValidationResult> results = validator().validate(std::move(programs));
  ASSERT_EQ(results.size(), 4u);
  EXPECT_THAT(shown(results[0], asked[0]), ElementsAre("fragment 4 <a>: `a`: undeclared identifier"));
  EXPECT_TRUE(results[1].program.has_value());
  EXPECT_THAT(shown(results[2], asked[2]), ElementsAre("fragment 4 <b>: `b`: undeclared identifier"));
  EXPECT_EQ(shown(results[3], asked[3]), shown(results[0], asked[0]));
}

}  // namespace
}  // namespace plugc
