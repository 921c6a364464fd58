// Programs that do less and mean the same, and the numbers of SPIR-V, as SPIRV-Cross reads them.

#include <gmock/gmock.h>

#include <map>
#include <spirv_cross/spirv_cross.hpp>

#include "tests/unit/validate/programs.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;
using testing::UnorderedElementsAre;

class Optimize : public testing::Test {
 protected:
  static void SetUpTestSuite() { validator_ = new Validator({}); }
  static void TearDownTestSuite() { delete std::exchange(validator_, nullptr); }
  static ValidationResult optimized(ProgramText program) {
    program.optimize = true;
    return validate_one(*validator_, program);
  }
  static ValidationResult validated(const ProgramText& program) { return validate_one(*validator_, program); }

 private:
  static inline Validator* validator_ = nullptr;
};

std::string text_of(const ValidationResult& result, std::size_t stage) {
  return std::string(result.program->stages().at(stage).text.text());
}

/// Locations of a stage's variables of a storage class, by name.
std::map<std::string, unsigned> locations(const std::vector<std::uint32_t>& words, spv::StorageClass storage) {
  const spirv_cross::Compiler module(words);
  std::map<std::string, unsigned> found;
  for (const auto id : module.get_active_interface_variables()) {
    if (module.get_storage_class(id) == storage && module.has_decoration(id, spv::DecorationLocation))
      found[module.get_name(id)] = module.get_decoration(id, spv::DecorationLocation);
  }
  return found;
}

constexpr std::string_view kMeetingVertex = R"(#version 330 core
uniform mat4 projection;
uniform float shared_by_both;
in vec3 castle_Normal;
in vec4 castle_Vertex;
in vec2 own_attribute;
out vec3 second;
out mat2 third;
out float first[2];
void main() {
  second = castle_Normal;
  third = mat2(own_attribute, own_attribute);
  first = float[2](shared_by_both, castle_Vertex.x);
  gl_Position = projection * castle_Vertex;
}
)";

constexpr std::string_view kMeetingFragment = R"(#version 330 core
in mat2 third;
in float first[2];
in vec3 second;
uniform sampler2D z_map, a_map;
uniform float weights[3];
uniform float shared_by_both;
out vec4 castle_FragColor;
void main() {
  castle_FragColor = vec4(second + texture(z_map, third[1]).rgb, first[1] * shared_by_both * weights[2]);
  castle_FragColor.a *= texture(a_map, third[0]).r;
}
)";

TEST_F(Optimize, GivesWhatMeetsOneNumberInAllStages) {
  const ValidationResult result = validated(program_of(kMeetingVertex, kMeetingFragment, Target::spirv));
  ASSERT_TRUE(result.program.has_value());
  const auto& spirv = result.program->spirv();
  EXPECT_THAT(locations(spirv[0], spv::StorageClassInput),
              UnorderedElementsAre(Pair("castle_Vertex", 0), Pair("castle_Normal", 1), Pair("own_attribute", 12)));
  const auto varyings = UnorderedElementsAre(Pair("first", 0), Pair("second", 2), Pair("third", 3));
  EXPECT_THAT(locations(spirv[0], spv::StorageClassOutput), varyings);
  EXPECT_THAT(locations(spirv[1], spv::StorageClassInput), varyings);
  EXPECT_THAT(locations(spirv[0], spv::StorageClassUniformConstant),
              UnorderedElementsAre(Pair("projection", 1), Pair("shared_by_both", 2)));
  EXPECT_THAT(locations(spirv[1], spv::StorageClassUniformConstant),
              UnorderedElementsAre(Pair("a_map", 0), Pair("shared_by_both", 2), Pair("weights", 3), Pair("z_map", 6)));
}

TEST_F(Optimize, TellsTheNumbersOfSpirv) {
  const ValidationResult result = validated(program_of(kMeetingVertex, kMeetingFragment, Target::spirv));
  ASSERT_TRUE(result.program.has_value());
  const ReflectedVariable& last = result.program->uniforms().back();
  EXPECT_EQ(last.name, "z_map");
  EXPECT_EQ(last.location, 6U);
  EXPECT_EQ(last.binding, 1U);
  EXPECT_EQ(result.program->attributes().front().location, 1U) << "castle_Normal";
}

TEST_F(Optimize, KeepsTheNumbersOfAuthors) {
  const ValidationResult result = validated(
      program_of("#version 330 core\nlayout(location = 5) in vec4 b;\nin vec4 castle_Normal, x;\n"
                 "void main() { gl_Position = b + castle_Normal + x; }\n",
                 "#version 330 core\nlayout(location = 1) out vec4 a;\nout vec4 c;\nvoid main() { a = vec4(1.0); c = a; }\n",
                 Target::spirv));
  ASSERT_TRUE(result.program.has_value());
  EXPECT_THAT(locations(result.program->spirv()[0], spv::StorageClassInput),
              UnorderedElementsAre(Pair("b", 5), Pair("castle_Normal", 1), Pair("x", 12)));
  EXPECT_THAT(locations(result.program->spirv()[1], spv::StorageClassOutput), UnorderedElementsAre(Pair("a", 1), Pair("c", 0)));
}

constexpr std::string_view kReadingBack = R"(#version 330 core
uniform mat4 camera, projection, dead;
in vec4 place, ignored;
out vec4 eye;
out vec3 list[2];
void main() {
  eye = camera * place;
  list[0] = (dead * ignored).xyz;
  list[1] = list[0] + eye.xyz;
  gl_Position = projection * eye;
}
)";

TEST_F(Optimize, DropsWhatTheNextStageDoesNotRead) {
  const ValidationResult result =
      optimized(program_of(kReadingBack, "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(0.5); }\n"));
  ASSERT_TRUE(result.program.has_value());
  EXPECT_EQ(result.not_optimized, "");
  EXPECT_THAT(shown(result.program->uniforms()), ElementsAre("mat4 camera", "mat4 projection"));
  EXPECT_THAT(shown(result.program->attributes()), ElementsAre("vec4 place"));
  EXPECT_THAT(text_of(result, 0), Not(HasSubstr("out ")));
  EXPECT_THAT(text_of(result, 0), HasSubstr("projection * (camera * place)"));
  EXPECT_EQ(result.program->cost()->varyings, 0U);
}

TEST_F(Optimize, KeepsWhatTheNextStageReads) {
  const ValidationResult result = optimized(program_of(
      kReadingBack, "#version 330 core\nin vec3 list[2];\nout vec4 color;\nvoid main() { color = vec4(list[1], 0.5); }\n"));
  ASSERT_TRUE(result.program.has_value());
  EXPECT_THAT(text_of(result, 0), HasSubstr("out vec3 list[2];"));
  EXPECT_THAT(text_of(result, 0), Not(HasSubstr("out vec4 eye")));
  EXPECT_EQ(result.program->attributes().size(), 2U);
  EXPECT_EQ(result.program->cost()->varyings, 2U);
}

TEST_F(Optimize, GoesThroughAGeometryStage) {
  const ValidationResult result =
      optimized(program_of({{ShaderStage::vertex,
                             "#version 330 core\nin vec4 place, dead, live;\nout vec4 lost, kept;\n"
                             "void main() { lost = dead; kept = live; gl_Position = place; }\n"},
                            {ShaderStage::geometry,
                             "#version 330 core\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\n"
                             "in vec4 lost[], kept[];\nout vec4 lost_too, kept_too;\nvoid main() {\n"
                             "lost_too = lost[0]; kept_too = kept[1]; gl_Position = gl_in[0].gl_Position; EmitVertex(); }\n"},
                            {ShaderStage::fragment,
                             "#version 330 core\nin vec4 lost_too, kept_too;\nout vec4 color;\n"
                             "void main() { vec4 c = lost_too; c = kept_too; color = c; }\n"}}));
  ASSERT_TRUE(result.program.has_value());
  EXPECT_EQ(result.not_optimized, "");
  EXPECT_THAT(shown(result.program->attributes()), ElementsAre("vec4 live", "vec4 place"));
  EXPECT_GT(result.program->cost()->geometry_instructions, 0U);
}

TEST_F(Optimize, CountsTextureReads) {
  const ValidationResult result = optimized(program_of(kMeetingVertex, kMeetingFragment));
  ASSERT_TRUE(result.program.has_value());
  EXPECT_EQ(result.program->cost()->texture_reads, 2U);
  EXPECT_EQ(result.program->cost()->varyings, 5U);
}

TEST_F(Optimize, WritesEssl) {
  const ValidationResult result = optimized(program_of(
      "#version 300 es\nin vec4 place;\nout vec3 unread;\nvoid main() { unread = place.xyz; gl_Position = place; }\n",
      "#version 300 es\nprecision highp float;\nuniform vec3 tint, dead;\nout vec4 color;\n"
      "void main() { vec3 c = dead; c = tint; color = vec4(c, 1.0); }\n",
      Target::essl300));
  ASSERT_TRUE(result.program.has_value());
  EXPECT_EQ(result.not_optimized, "");
  EXPECT_THAT(text_of(result, 0), testing::StartsWith("#version 300 es\n"));
  EXPECT_THAT(text_of(result, 0), Not(HasSubstr("unread")));
  EXPECT_THAT(shown(result.program->uniforms()), ElementsAre("vec3 tint"));
}

TEST_F(Optimize, OptimisesSpirvItself) {
  const ValidationResult result = optimized(program_of(kMeetingVertex, kMeetingFragment, Target::spirv));
  const ValidationResult plain = validated(program_of(kMeetingVertex, kMeetingFragment, Target::spirv));
  ASSERT_TRUE(result.program && plain.program);
  EXPECT_LT(result.program->spirv()[1].size(), plain.program->spirv()[1].size());
  EXPECT_EQ(text_of(result, 1), kMeetingFragment) << "the text stays readable";
}

TEST_F(Optimize, SaysMistakesInTheAuthorsText) {
  ProgramText program = plain_program("foo;");
  program.optimize = true;
  EXPECT_THAT(shown(validated(program), program), ElementsAre("fragment 4 <foo>: `foo`: undeclared identifier"));
}

}  // namespace
}  // namespace plugc
