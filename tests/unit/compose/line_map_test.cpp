// Every byte of author's code leads back to itself; what plugc adds leads to nothing, to the plug function or to a template.
#include "compose_fixture.h"

namespace plugc {
namespace {

class LineMapTest : public ComposeTest {
 protected:
  /// `name:line` of each line of the stage, by its first byte that is no blank.
  std::string origin_of(std::string_view line_text) const {
    const MappedText& text = stage(ShaderStage::fragment);
    const std::size_t at = text.text().find(line_text);
    if (at == std::string::npos) return "absent";
    const Span span = text.locate(static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + line_text.size()));
    if (!span.valid()) return "generated";
    return std::string(sources_.name(span.source)) + ":" + std::to_string(sources_.position(span.source, span.begin).line);
  }
};

TEST_F(LineMapTest, LeadsFromEveryLineOfCodeToItsOwn) {
  const std::string code =
      "#version 120\nuniform float a; // one\n\n#define K a\nvoid PLUG_fragment_modify(inout vec4 c)\n{\n  /* PLUG: level "
      "(c.r) */\n  c.r = K;\n}\n";
  const int first = fragment(code), second = fragment(code);
  const std::string text = fragment_text(unlit({first, second, fragment("void PLUG_level(inout float k) {}")}));
  std::string lines;  // of the second effect, with the line that each leads to
  for (std::size_t begin = text.find("uniform float a_2");
       begin < text.size() && text.compare(begin, 4, "void PLUG_level(inout float k)") != 0;) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    if (origin_of(line).starts_with("e1.0:")) lines += origin_of(line).substr(5) + " " + line + "\n";
    begin = end + 1;
  }
  EXPECT_EQ(lines_with(lines, "a_2"), "2 uniform float a_2; // one\n4 #define K a_2\n");
  EXPECT_EQ(lines_with(lines, "_2(inout"), "5 void PLUG_fragment_modify_2(inout vec4 c)\n");
  EXPECT_EQ(origin_of("uniform float a_2;"), "e1.0:2");
  EXPECT_EQ(origin_of("#define K a_2"), "e1.0:4");
  EXPECT_EQ(origin_of("void PLUG_fragment_modify_2(inout vec4 c)"), "e1.0:5");
  EXPECT_EQ(origin_of("#undef K"), "generated");
}

TEST_F(LineMapTest, LeadsFromCallsAndPrototypesToThePlugFunction) {
  compose_all(unlit({fragment("\n\nvoid PLUG_fragment_modify(inout vec4 c) {}\n")}));
  EXPECT_EQ(origin_of("PLUG_fragment_modify(fragment_color);"), "e0.0:3");
  EXPECT_EQ(origin_of("void PLUG_fragment_modify(inout vec4);"), "e0.0:3");
}

TEST_F(LineMapTest, LeadsFromTemplateLinesToTheTemplate) {
  compose_all(unlit({}));
  EXPECT_EQ(origin_of("// Phong shading"), "plugc:/templates/phong.frag:1");
  EXPECT_EQ(origin_of("#version"), "generated");
}

TEST_F(LineMapTest, LeadsFromHoistedLinesToTheirAuthor) {
  compose_all(unlit({fragment("float q;\n#extension GL_ARB_gpu_shader5 : enable\n"), fragment("\n#version 400\n")}));
  EXPECT_EQ(origin_of("#extension GL_ARB"), "e0.0:2");
  EXPECT_EQ(origin_of("#version 400"), "e1.0:2");
}

TEST_F(LineMapTest, LeadsFromARewrittenDeclarationToItsPlace) {
  compose_all(unlit({effect({{PartStage::fragment, "uniform float a;\n"}, {PartStage::fragment, "\nuniform float a, b;\n"}})}));
  EXPECT_EQ(origin_of("uniform float b;"), "e0.1:2");
}

}  // namespace
}  // namespace plugc
