#include "compose_fixture.h"

namespace plugc {
namespace {

class NamesTest : public ComposeTest {
 protected:
  std::string last_of(const std::vector<int>& effects, std::size_t lines, Target target = Target::glsl330) {
    return last_lines(fragment_text(unlit(effects), target), lines);
  }
};

TEST_F(NamesTest, KeepsNamesThatDoNotMeet) {
  EXPECT_EQ(last_of({fragment("uniform float a;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = a; }")}, 2),
            "uniform float a;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = a; }\n");
}

TEST_F(NamesTest, RenamesWhatASecondEffectDeclaresToo) {
  const std::string code =
      "uniform float a;\nfloat f(float x) { return a * x; }\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = f(a); }\n";
  EXPECT_EQ(last_of({fragment(code), fragment(code)}, 3),
            "uniform float a_2;\nfloat f_2(float x) { return a_2 * x; }\n"
            "void PLUG_fragment_modify_2(inout vec4 c) { c.r = f_2(a_2); }\n");
  ASSERT_EQ(program_.fields.size(), 2U);
  EXPECT_EQ(program_.fields[0].name + " " + std::to_string(program_.fields[0].owner), "a 0");
  EXPECT_EQ(program_.fields[1].name + " " + std::to_string(program_.fields[1].owner), "a_2 1");
}

TEST_F(NamesTest, AvoidsWordsThatTheAuthorUsesAlready) {
  const int first = fragment("uniform float a;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = a; }");
  const int second = fragment(
      "#define a_4 1.0\nuniform float a, a_2;\nvoid PLUG_fragment_modify(inout vec4 c) { float a_3 = a; c.r = a_2 * a_3; }");
  EXPECT_EQ(lines_with(last_of({first, second}, 5), "a_"),
            "#define a_4 1.0\nuniform float a_5, a_2;\nvoid PLUG_fragment_modify_2(inout vec4 c) { float a_3 = a_5; c.r = a_2 "
            "* a_3; }\n"
            "#undef a_4\n");
}

TEST_F(NamesTest, KeepsOutOfTheTemplatesNames) {
  EXPECT_EQ(last_of({fragment("float lighting(float x) { return x; }\nconst float main_texture_apply = 0.5;\n")}, 2),
            "float lighting_2(float x) { return x; }\nconst float main_texture_apply_2 = 0.5;\n");
}

TEST_F(NamesTest, LeavesMembersAndSwizzlesAlone) {
  const int first = fragment("uniform float a; uniform vec2 r;");
  const int second = fragment(
      "struct T { float a, b; vec2 r[2]; };\nuniform float a; uniform vec2 r;\nfloat f(T t) { return t.a * a + t . b + r.r; }");
  EXPECT_EQ(last_of({first, second}, 3),
            "struct T { float a, b; vec2 r[2]; };\nuniform float a_2; uniform vec2 r_2;\n"
            "float f(T t) { return t.a * a_2 + t . b + r_2.r; }\n");
}

TEST_F(NamesTest, RenamesInMacroBodies) {
  const std::string code = "uniform float define;\n#define TWICE (define * 2.0)\nfloat f() { return TWICE; }";
  EXPECT_EQ(last_of({fragment("uniform float define;"), fragment(code)}, 4),
            "uniform float define_2;\n#define TWICE (define_2 * 2.0)\nfloat f() { return TWICE; }\n#undef TWICE\n");
}

TEST_F(NamesTest, KeepsOneNameInBothStages) {
  const std::string vertex_code = "varying float h;\nvoid PLUG_vertex_eye_space(const in vec4 v, const in vec3 n) { h = v.y; }";
  const std::string fragment_code = "varying float h;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = h; }";
  const int first = effect({{PartStage::vertex, vertex_code}, {PartStage::fragment, fragment_code}});
  const int second = effect({{PartStage::vertex, vertex_code}, {PartStage::fragment, fragment_code}});
  EXPECT_EQ(last_of({first, second}, 2), "in float h_2;\nvoid PLUG_fragment_modify_2(inout vec4 c) { c.r = h_2; }\n");
  EXPECT_EQ(last_lines(stage(ShaderStage::vertex).text(), 2),
            "out float h_2;\nvoid PLUG_vertex_eye_space_2(const in vec4 v, const in vec3 n) { h_2 = v.y; }\n");
}

TEST_F(NamesTest, SharesVertexInputs) {
  const std::string code =
      "attribute vec3 wind;\nvoid PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) { v.xyz += wind; }";
  EXPECT_EQ(count(vertex_text(unlit({vertex(code), vertex(code)})), "in vec3 wind;"), 1U);
  EXPECT_EQ(count(stage(ShaderStage::vertex).text(), "v.xyz += wind;"), 2U);
}

TEST_F(NamesTest, SharesCastleNames) {
  const int bare = fragment("void PLUG_fragment_modify(inout vec4 c) { c.rg = castle_TexCoord0.st; }");
  const int declared =
      fragment("varying vec4 castle_TexCoord0;\nvoid PLUG_fragment_modify(inout vec4 c) { c.b = castle_TexCoord0.s; }");
  EXPECT_EQ(count(fragment_text(unlit({bare, declared})), "in vec4 castle_TexCoord0;"), 1U);
  EXPECT_EQ(lines_with(stage(ShaderStage::vertex).text(), "castle_TexCoord0 ="), "castle_TexCoord0 = tex_coord;\n");
}

TEST_F(NamesTest, NumbersALightsOwnNames) {
  LightRecipe light;
  light.effects = {
      fragment("uniform vec3 castle_LightSourceColor;\n"
               "void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) { s = castle_LightSourceColor.r; }")};
  EXPECT_EQ(last_lines(fragment_text(lit({}, {LightRecipe{}, light})), 1),
            "void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) { s = castle_LightSource1Color.r; }\n");
  EXPECT_EQ(count(stage(ShaderStage::fragment).text(), "uniform vec3 castle_LightSource1Color;"), 1U);
}

TEST_F(NamesTest, NumbersOneEffectOnTwoLights) {
  const int e =
      fragment("void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) { s = castle_LightSourceRadius; }");
  LightRecipe light;
  light.effects = {e};
  EXPECT_EQ(lines_with(fragment_text(lit({}, {light, light})), "Radius"),
            "uniform float castle_LightSource0Radius;\nuniform float castle_LightSource1Radius;\n"
            "void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) { s = castle_LightSource0Radius; }\n"
            "void PLUG_light_scale_2(inout float s, const in vec3 n, const in vec3 d) { s = castle_LightSource1Radius; }\n");
}

TEST_F(NamesTest, WritesVaryingsThatGouraudEffectsRead) {
  Recipe recipe = lit({fragment("void PLUG_fragment_modify(inout vec4 c) { c.rgb = castle_normal_eye; }")});
  recipe.gouraud = true;
  EXPECT_EQ(lines_with(vertex_text(recipe), "castle_normal_eye"),
            "out vec3 castle_normal_eye;\ncastle_normal_eye = normal_eye;\n");
}

TEST_F(NamesTest, WritesTheNormalOfAMeshThatHasNone) {
  EXPECT_EQ(lines_with(vertex_text(unlit({fragment("void PLUG_fragment_modify(inout vec4 c) { c.rgb = castle_normal_eye; }")})),
                       "normal_eye"),
            "out vec3 castle_normal_eye;\nvec3 normal_eye = vec3(0.0, 0.0, 1.0);\ncastle_normal_eye = normal_eye;\n");
}

TEST_F(NamesTest, RefusesACastleVaryingThatTheShapeLacks) {
  const int e = fragment("void PLUG_fragment_modify(inout vec4 c) { c = castle_Color; }");
  compose_all(unlit({e}));
  EXPECT_EQ(said(),
            "e0.0:1:47 varying-unwritten: nothing writes `castle_Color` in the vertex stage of this shape; it is there under "
            "`GOURAUD` shading only\n");
  EXPECT_EQ(program_.faulty_effects, std::vector<int>{e});
}

TEST_F(NamesTest, MergesEqualDeclarationsOfOneEffect) {
  const int e =
      effect({{PartStage::fragment, "uniform float a;\n// one\n"}, {PartStage::fragment, "uniform  float a;\n// two\n"}});
  EXPECT_EQ(last_of({e}, 4), "uniform float a;\n// one\n\n// two\n");
}

TEST_F(NamesTest, TakesTheNewHalfOfARepeatedDeclaration) {
  const int e = effect({{PartStage::fragment, "uniform float a;\n"}, {PartStage::fragment, "uniform float a, b = 2.0, c;\n"}});
  EXPECT_EQ(last_of({e}, 3), "uniform float a;\n\nuniform float b = 2.0, c;\n");
}

TEST_F(NamesTest, NamesBothPlacesOfUnequalDeclarations) {
  const int e = effect({{PartStage::fragment, "uniform float a;\n"}, {PartStage::fragment, "\nuniform float a[2];\n"}});
  compose_all(unlit({e}));
  EXPECT_EQ(said(), "e0.1:2:15 unequal-declarations: `a` is declared here as `float[2]`, and differently before\n");
  ASSERT_EQ(diagnostics_.all()[0].related.size(), 1U);
  EXPECT_EQ(sources_.name(diagnostics_.all()[0].related[0].span.source), "e0.0");
  EXPECT_EQ(program_.faulty_effects, std::vector<int>{e});
}

TEST_F(NamesTest, ComparesConstantsByTheirTokens) {
  const int e = effect({{PartStage::fragment, "const vec2 k = vec2(1.0, 2.0);\n"},
                        {PartStage::fragment, "const vec2 k = vec2( 1.0,2.0 ); // same\n"}});
  compose_all(unlit({e}));
  EXPECT_EQ(said(), "");
}

TEST_F(NamesTest, SharesEqualStructsBetweenEffects) {
  const int first = fragment("struct S { vec2 a; } one;\n"),
            second = fragment("struct S { /* x */ vec2 a ; } two;\nstruct { float z; } three;\n");
  EXPECT_EQ(last_of({first, second}, 4), "struct S { vec2 a; } one;\n\nS two;\nstruct { float z; } three;\n");
}

TEST_F(NamesTest, RenamesUnequalStructsAndSharesThoseTheirEquals) {
  const int first = fragment("struct S { vec2 a; };\n"), second = fragment("struct S { vec3 a; };\n"),
            third = fragment("struct S { vec3 a; };\nS s;\n");
  EXPECT_EQ(last_of({first, second, third}, 5), "struct S { vec2 a; };\n\nstruct S_2 { vec3 a; };\n\nS_2 s;\n");
}

TEST_F(NamesTest, EndsMacrosWithTheirPart) {
  const int e = effect(
      {{PartStage::fragment, "#define K 1.0\n#define F(x) (x)\nfloat a = F(K);\n"}, {PartStage::fragment, "#define K 2.0\n"}});
  EXPECT_EQ(last_of({e}, 10),
            "#define K 1.0\n#define F(x) (x)\nfloat a = F(K);\n\n#undef F\n#undef K\n\n#define K 2.0\n\n#undef K\n");
}

TEST_F(NamesTest, HoistsExtensionsOnceAndDropsVersions) {
  const std::string code =
      "#version 120\n#extension GL_ARB_shading_language_420pack : enable\nprecision mediump float;\nfloat q;\n";
  const std::string text = fragment_text(unlit({fragment(code), fragment(code)}));
  EXPECT_EQ(text.substr(0, text.find("//")), "#version 330 core\n#extension GL_ARB_shading_language_420pack : enable\n\n");
  EXPECT_EQ(count(text, "precision"), 0U);
}

TEST_F(NamesTest, HonoursAHigherVersion) {
  EXPECT_EQ(fragment_text(unlit({fragment("#version 400\nfloat q;\n")})).substr(0, 18), "#version 400 core\n");
  EXPECT_EQ(fragment_text(unlit({fragment("#version 400\nfloat q;\n")}), Target::essl300).substr(0, 16), "#version 300 es\n");
}

TEST_F(NamesTest, DropsInitialisersForEsslAlone) {
  const int e = fragment("uniform float a = 0.5, b;\nconst float k = 1.0;\n");
  EXPECT_EQ(last_of({e}, 2), "uniform float a = 0.5, b;\nconst float k = 1.0;\n");
  EXPECT_EQ(last_of({e}, 2, Target::essl300), "uniform float a , b;\nconst float k = 1.0;\n");
}

TEST_F(NamesTest, ReadsConditionsAsTheTargetDoes) {
  const std::string code =
      "#ifdef GL_ES\nprecision mediump float;\nvarying lowp vec4 castle_TexCoord0;\n#else\nuniform float a = 1.0;\n#endif\n";
  const int e = fragment(code);
  EXPECT_EQ(count(last_of({e}, 6), "uniform float a = 1.0;"), 1U);
  const std::string essl = last_of({e}, 5, Target::essl300);
  EXPECT_EQ(count(essl, "mediump") + count(essl, "varying"), 0U);
  EXPECT_EQ(count(essl, "in lowp vec4 castle_TexCoord0;"), 1U);
}

TEST_F(NamesTest, FindsADeclaredFunctionInAnotherEffect) {
  const int calls = fragment("float half_of(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of(c.g); }\n");
  const int other = fragment("float half_of(vec2 x) { return x.x; }\n"),
            meant = fragment("float half_of(float x) { return x * 0.5; }\n");
  EXPECT_EQ(lines_with(fragment_text(unlit({calls, other, meant})), "half_of"),
            "float half_of_2(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of_2(c.g); }\n"
            "float half_of(vec2 x) { return x.x; }\nfloat half_of_2(float x) { return x * 0.5; }\n");
}

TEST_F(NamesTest, ReportsAFunctionThatNothingDefines) {
  const int e = fragment("float half_of(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of(c.g); }\n");
  compose_all(unlit({e}));
  EXPECT_EQ(said(),
            "e0.0:1:7 shader-invalid: `half_of` is declared and called, but nothing defines it in the fragment stage of this "
            "shape\n");
}

TEST_F(NamesTest, ReportsTwoCandidatesForAFunction) {
  const int calls = fragment("float half_of(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of(c.g); }\n");
  const std::string definition = "float half_of(float x) { return x * 0.5; }\n";
  compose_all(unlit({calls, fragment(definition), fragment(definition)}));
  EXPECT_EQ(said(),
            "e0.0:1:7 ambiguous-function: `half_of` is declared here and defined by 2 other effects; define it in one, or in "
            "this one\n");
}

TEST_F(NamesTest, FindsAVaryingOfAnotherEffect) {
  const int writes = vertex("varying float h;\nvoid PLUG_vertex_eye_space(const in vec4 v, const in vec3 n) { h = v.y; }");
  const int reads = fragment("varying float h;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = h; }");
  EXPECT_EQ(last_of({writes, reads}, 2), "in float h;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = h; }\n");
}

TEST_F(NamesTest, MindsAnUnwrittenVaryingOnlyWhenItIsRead) {
  compose_all(unlit({fragment("varying float unread;\n")}));
  EXPECT_EQ(said(), "");
  compose_all(unlit({fragment("varying float h;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = h; }")}));
  EXPECT_EQ(said(),
            "e1.0:1:15 varying-unwritten: nothing writes `h`; declare it as `varying float h;` in a `VERTEX` part too and "
            "write it there\n");
}

TEST_F(NamesTest, DeclaresWhatAnOldComposedShaderReads) {
  Recipe recipe = unlit({});
  recipe.shader = shader("void main() { gl_Position = gl_Vertex; }\n", "void main() { gl_FragColor = gl_TexCoord[0]; }\n");
  EXPECT_EQ(vertex_text(recipe),
            "#version 330 core\nout vec4 castle_TexCoord0;\nin vec4 castle_Vertex;\n\n"
            "void main() { gl_Position = castle_Vertex; }\n");
}

TEST_F(NamesTest, CallsTheFirstDefinitionWhereAnAuthorCallsAPlugFunction) {
  const int first = fragment("void PLUG_fragment_modify(inout vec4 c) {}");
  const int second =
      fragment("void PLUG_fragment_modify(inout vec4 c) {}\nvoid PLUG_fragment_end(vec4 c) { PLUG_fragment_modify(c); }");
  EXPECT_EQ(last_of({first, second}, 2),
            "void PLUG_fragment_modify_2(inout vec4 c) {}\nvoid PLUG_fragment_end(vec4 c) { PLUG_fragment_modify_2(c); }\n");
}

}  // namespace
}  // namespace plugc
