#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/limits.h"
#include "glsl/outline.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

Outline outline_of(std::string_view text, Storage varying = Storage::in) {
  return outline(text, tokenize(text, {}), varying);
}

std::string_view at(std::string_view text, std::uint32_t begin, std::uint32_t end) {
  return text.substr(begin, end - begin);
}

// Each problem as `place: message`.
std::vector<std::string> problems(std::string_view text) {
  std::vector<std::string> result;
  for (const OutlineProblem& problem : outline_of(text).problems) {
    result.push_back(std::to_string(problem.begin) + "-" + std::to_string(problem.end) + ": " + problem.message);
  }
  return result;
}

TEST(Outline, ReadsAFunction) {
  const std::string_view text = "  highp vec4 f(const in vec4 a, inout float b[4])  { if (x) { y(); } }  ";
  const Outline outline = outline_of(text);
  ASSERT_THAT(outline.functions, SizeIs(1));
  const FunctionOutline& f = outline.functions[0];
  EXPECT_EQ(f.return_type, "vec4");
  EXPECT_EQ(f.name, "f");
  EXPECT_EQ(f.name_begin, 13U);
  EXPECT_EQ(at(text, f.parameters_begin, f.parameters_end), "const in vec4 a, inout float b[4]");
  EXPECT_EQ(at(text, f.begin, f.end), "highp vec4 f(const in vec4 a, inout float b[4])  { if (x) { y(); } }");
  EXPECT_EQ(at(text, f.body_begin, f.body_end), "{ if (x) { y(); } }");
  EXPECT_TRUE(f.is_definition());
  EXPECT_THAT(outline.problems, IsEmpty());
}

TEST(Outline, ReadsParameters) {
  const std::string_view text = "void f(const in vec4 a, inout highp float b[4], out sampler2D, vec3[2] c) {}";
  const auto parameters = outline_of(text).functions.at(0).parameters;
  ASSERT_THAT(parameters, SizeIs(4));
  EXPECT_TRUE(parameters[0].is_const);
  EXPECT_EQ(parameters[0].direction, Direction::in);
  EXPECT_EQ(parameters[0].type, "vec4");
  EXPECT_EQ(at(text, parameters[0].begin, parameters[0].end), "const in vec4 a");
  EXPECT_FALSE(parameters[1].is_const);
  EXPECT_EQ(parameters[1].direction, Direction::inout);
  EXPECT_EQ(parameters[1].type, "float");
  EXPECT_EQ(parameters[1].name, "b");
  EXPECT_EQ(parameters[1].array, "[4]");
  EXPECT_EQ(parameters[2].direction, Direction::out);
  EXPECT_EQ(parameters[2].name, "");
  EXPECT_EQ(parameters[3].array, "[2]");
  EXPECT_EQ(parameters[3].name, "c");
}

TEST(Outline, VoidMeansNoParameters) {
  EXPECT_THAT(outline_of("void main(void) {}").functions.at(0).parameters, IsEmpty());
  EXPECT_THAT(outline_of("void main() {}").functions.at(0).parameters, IsEmpty());
}

TEST(Outline, ReadsASignatureThatStandsAlone) {
  const auto parameters = parse_parameters("inout vec4 color, const in vec3 normal_eye");
  ASSERT_THAT(parameters, SizeIs(2));
  EXPECT_EQ(parameters[1].name, "normal_eye");
  EXPECT_EQ(parameters[1].begin, 18U);
  EXPECT_EQ(parameters[1].end, 42U);
  EXPECT_THAT(parse_parameters(" "), IsEmpty());
}

TEST(Outline, ReadsPrototypesAndOverloads) {
  const std::string_view text =
      "void PLUG_vertex_object_space(const in vec4 v, inout vec3 n);\n"
      "void PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) { }\n"
      "void PLUG_texture_color(inout vec4 c, sampler2D s, vec4 t) { c *= 2.0; }\n"
      "void PLUG_texture_color(inout vec4 c, samplerCube s, vec4 t) { }\n"
      "float[2] pair();";
  const auto functions = outline_of(text).functions;
  ASSERT_THAT(functions, SizeIs(5));
  EXPECT_FALSE(functions[0].is_definition());
  EXPECT_EQ(functions[0].body_begin, functions[0].body_end);
  EXPECT_EQ(functions[0].name, "PLUG_vertex_object_space");
  EXPECT_EQ(at(text, functions[0].begin, functions[0].end).back(), ';');
  EXPECT_EQ(functions[1].name, "PLUG_vertex_object_space_change");
  EXPECT_EQ(functions[2].parameters[1].type, "sampler2D");
  EXPECT_EQ(functions[3].parameters[1].type, "samplerCube");
  EXPECT_EQ(at(text, functions[3].body_begin, functions[3].body_end), "{ }");
  EXPECT_EQ(functions[4].return_type, "float[2]");
}

TEST(Outline, ReadsGlobals) {
  const std::string_view text = "uniform highp sampler2D map;\nconst float weights[2] = float[2](1.0, 2.0), b = (1, 2);";
  const auto globals = outline_of(text).globals;
  ASSERT_THAT(globals, SizeIs(3));
  EXPECT_EQ(globals[0].storage, Storage::uniform);
  EXPECT_EQ(globals[0].type, "sampler2D");
  EXPECT_EQ(globals[0].name, "map");
  EXPECT_EQ(globals[0].initializer_begin, globals[0].initializer_end);
  EXPECT_EQ(at(text, globals[0].begin, globals[0].end), "uniform highp sampler2D map;");
  EXPECT_EQ(globals[1].storage, Storage::constant);
  EXPECT_EQ(globals[1].array, "[2]");
  EXPECT_EQ(globals[1].declarator_count, 2U);
  EXPECT_EQ(globals[1].name_begin, 41U);
  EXPECT_EQ(at(text, globals[1].declarator_begin, globals[1].declarator_end), "weights[2] = float[2](1.0, 2.0)");
  EXPECT_EQ(at(text, globals[1].initializer_begin, globals[1].initializer_end), "float[2](1.0, 2.0)");
  EXPECT_EQ(at(text, globals[2].initializer_begin, globals[2].initializer_end), "(1, 2)");
  EXPECT_EQ(globals[2].array, "");
  EXPECT_EQ(globals[2].begin, globals[1].begin);
  EXPECT_EQ(globals[2].end, text.size());
}

TEST(Outline, ReadsQualifiers) {
  const auto globals =
      outline_of(
          "layout(location = 0) in vec4 a; flat centroid in vec3 b[]; attribute vec2 c; invariant varying vec3 d;"
          "in noperspective float e; vec3[4] f; buffer int g;",
          Storage::out)
          .globals;
  ASSERT_THAT(globals, SizeIs(7));
  EXPECT_EQ(globals[0].layout, "layout(location = 0)");
  EXPECT_EQ(globals[0].storage, Storage::in);
  EXPECT_EQ(globals[0].qualifiers, "");
  EXPECT_EQ(globals[1].qualifiers, "flat centroid");
  EXPECT_EQ(globals[1].array, "[]");
  EXPECT_EQ(globals[2].storage, Storage::in);
  EXPECT_EQ(globals[3].storage, Storage::out);
  EXPECT_EQ(globals[3].qualifiers, "invariant");
  EXPECT_EQ(globals[4].qualifiers, "noperspective");
  EXPECT_EQ(globals[5].storage, Storage::none);
  EXPECT_EQ(globals[5].array, "[4]");
  EXPECT_EQ(globals[6].storage, Storage::buffer);
}

TEST(Outline, SeesThroughMacrosThatStandForQualifiers) {
  const auto globals = outline_of(
                           "#define VARYING varying\n#define PRECISION\n#define N 3\n"
                           "VARYING PRECISION vec3 a;\nuniform PRECISION float b[N];",
                           Storage::out)
                           .globals;
  ASSERT_THAT(globals, SizeIs(2));
  EXPECT_EQ(globals[0].storage, Storage::out);
  EXPECT_EQ(globals[0].type, "vec3");
  EXPECT_EQ(globals[1].storage, Storage::uniform);
  EXPECT_EQ(globals[1].name, "b");
}

TEST(Outline, PassesOverMacrosThatDeclare) {
  const Outline outline = outline_of("#define NOISE(n) float noise##n() { return 0.0; }\nNOISE(2)\nfloat a;");
  EXPECT_THAT(outline.globals, SizeIs(1));
  EXPECT_THAT(outline.problems, IsEmpty());
}

TEST(Outline, ReadsStructs) {
  const std::string_view text =
      "struct Wave { vec2 at[2]; float b; };\nuniform struct S { int x; } s, t[2];\nconst struct { int y; } u;";
  const Outline outline = outline_of(text);
  ASSERT_THAT(outline.structs, SizeIs(3));
  EXPECT_EQ(outline.structs[0].name, "Wave");
  EXPECT_EQ(outline.structs[0].name_begin, 7U);
  EXPECT_EQ(at(text, outline.structs[0].begin, outline.structs[0].end), "struct Wave { vec2 at[2]; float b; };");
  EXPECT_EQ(at(text, outline.structs[1].begin, outline.structs[1].end), "struct S { int x; }");
  EXPECT_EQ(outline.structs[1].storage, Storage::none);
  EXPECT_EQ(outline.structs[2].name, "");
  ASSERT_THAT(outline.globals, SizeIs(3));
  EXPECT_EQ(outline.globals[0].type, "S");
  EXPECT_EQ(outline.globals[0].storage, Storage::uniform);
  EXPECT_EQ(outline.globals[1].array, "[2]");
  EXPECT_EQ(outline.globals[2].type, "struct { int y; }");
  EXPECT_THAT(outline.problems, IsEmpty());
}

TEST(Outline, ReadsBlocks) {
  const std::string_view text = "layout(std140) uniform Block { vec4 a; } block[2]; out gl_PerVertex { vec4 gl_Position; };";
  const Outline outline = outline_of(text);
  ASSERT_THAT(outline.structs, SizeIs(2));
  EXPECT_EQ(outline.structs[0].storage, Storage::uniform);
  EXPECT_EQ(outline.structs[0].name, "Block");
  EXPECT_EQ(outline.structs[0].instance, "block");
  EXPECT_EQ(outline.structs[0].instance_begin, 41U);
  EXPECT_EQ(at(text, outline.structs[0].begin, outline.structs[0].end), "layout(std140) uniform Block { vec4 a; } block[2];");
  EXPECT_EQ(outline.structs[1].storage, Storage::out);
  EXPECT_EQ(outline.structs[1].instance, "");
  EXPECT_THAT(outline.globals, IsEmpty());
}

TEST(Outline, CollectsStatementsAndDirectives) {
  const std::string_view text =
      "#version 300 es\r\n#extension GL_X : enable\r\nprecision mediump float;\r\nlayout(triangles) in;\r\n"
      "#define A 1\r\n#define F(x, y) x\r\n#define G (x)\r\n#undef A\r\n#pragma p\r\ninvariant gl_Position, b;\r\n;";
  const Outline outline = outline_of(text);
  EXPECT_EQ(outline.version.number, 300);
  EXPECT_EQ(outline.version.profile, "es");
  EXPECT_EQ(outline.version.end, 15U);
  ASSERT_THAT(outline.extensions, SizeIs(1));
  EXPECT_EQ(at(text, outline.extensions[0].begin, outline.extensions[0].end), "#extension GL_X : enable");
  ASSERT_THAT(outline.precisions, SizeIs(1));
  EXPECT_EQ(at(text, outline.precisions[0].begin, outline.precisions[0].end), "precision mediump float;");
  ASSERT_THAT(outline.layouts, SizeIs(1));
  EXPECT_EQ(at(text, outline.layouts[0].begin, outline.layouts[0].end), "layout(triangles) in;");
  ASSERT_THAT(outline.macros, SizeIs(3));
  EXPECT_EQ(outline.macros[0].name, "A");
  EXPECT_EQ(at(text, outline.macros[0].begin, outline.macros[0].end), "#define A 1");
  EXPECT_EQ(at(text, outline.macros[0].body_begin, outline.macros[0].end), " 1");
  EXPECT_EQ(at(text, outline.macros[1].body_begin, outline.macros[1].end), " x");
  EXPECT_EQ(at(text, outline.macros[2].body_begin, outline.macros[2].end), " (x)");
  ASSERT_THAT(outline.undefs, SizeIs(1));
  EXPECT_EQ(at(text, outline.undefs[0].begin, outline.undefs[0].end), "#undef A");
  EXPECT_THAT(outline.globals, IsEmpty());
  EXPECT_THAT(outline.problems, IsEmpty());
}

TEST(Outline, FindsMarkers) {
  const std::string_view text =
      "/* PLUG-DECLARATIONS */ float a;\nvoid f() { }\nvoid g() {\n  /* PLUG: vertex_eye (a, vec4(b, c(1))) */\n"
      "  /*PLUG:end(\n)*/ // /* PLUG: no (x) */\n}\n/*VARYING-PASSTHROUGH-GEOMETRY-SHADERS*/\nout float x;";
  const auto markers = outline_of(text).markers;
  ASSERT_THAT(markers, SizeIs(4));
  EXPECT_EQ(markers[0].kind, MarkerKind::declarations);
  EXPECT_EQ(markers[0].enclosing_function, UINT32_MAX);
  EXPECT_EQ(at(text, markers[0].begin, markers[0].end), "/* PLUG-DECLARATIONS */");
  EXPECT_EQ(markers[1].kind, MarkerKind::plug);
  EXPECT_EQ(markers[1].name, "vertex_eye");
  EXPECT_EQ(text.substr(markers[1].name_begin, 10), "vertex_eye");
  EXPECT_EQ(markers[1].arguments, "a, vec4(b, c(1))");
  EXPECT_EQ(markers[1].enclosing_function, 1U);
  EXPECT_EQ(markers[2].name, "end");
  EXPECT_EQ(markers[2].arguments, "\n");
  EXPECT_EQ(markers[2].enclosing_function, 1U);
  EXPECT_EQ(markers[3].kind, MarkerKind::varying_passthrough);
  EXPECT_EQ(markers[3].enclosing_function, UINT32_MAX);
}

TEST(Outline, MarkersMayStandInsideDeclarations) {
  const Outline outline = outline_of("float a /* PLUG-DECLARATIONS */\n#define X\n= 1.0, b;");
  EXPECT_THAT(outline.globals, SizeIs(2));
  EXPECT_THAT(outline.markers, SizeIs(1));
  EXPECT_THAT(outline.problems, IsEmpty());
}

TEST(Outline, DeadBranchesDeclareNothing) {
  const Outline outline = outline_of("#if 0\nfloat a; /* PLUG: p () */\n#define A\n#version 100\n#else\nfloat b;\n#endif");
  ASSERT_THAT(outline.globals, SizeIs(1));
  EXPECT_EQ(outline.globals[0].name, "b");
  EXPECT_THAT(outline.markers, IsEmpty());
  EXPECT_THAT(outline.macros, IsEmpty());
  EXPECT_EQ(outline.version.number, 0);
}

TEST(Outline, ReportsBrackets) {
  EXPECT_THAT(problems("void f() { a(; }\nfloat b;"), ElementsAre("13-14: `)` is missing in front of `;`"));
  EXPECT_THAT(problems("void f() { if (a) {\n}"), ElementsAre("21-21: `}` is missing at the end of the text"));
  EXPECT_THAT(problems("void f() { } }"), ElementsAre("13-14: `}` closes nothing"));
  EXPECT_THAT(problems("void f() { a)]; }"), ElementsAre("12-13: `)` closes nothing", "13-14: `]` closes nothing"));
}

TEST(Outline, GoesOnBehindAMissingBracket) {
  const Outline outline = outline_of("void f() { a(; }\nfloat b;\nvoid g() { c]; }");
  EXPECT_THAT(outline.functions, SizeIs(2));
  EXPECT_THAT(outline.globals, SizeIs(1));
}

TEST(Outline, ReportsWhatIsNoDeclaration) {
  EXPECT_THAT(problems("uniform float a\nuniform float b;"), ElementsAre("14-15: `;` is missing behind `a`"));
  EXPECT_THAT(problems("a = 1; float b;"), ElementsAre("2-3: `=` where a declaration was expected"));
  EXPECT_THAT(problems("float"), ElementsAre("0-5: the text ends behind `float`, inside a declaration"));
  EXPECT_THAT(problems("float a"), ElementsAre("6-7: `;` is missing behind `a`"));
  EXPECT_THAT(problems("void f()"), ElementsAre("7-8: `;` is missing behind `)`"));
  EXPECT_THAT(problems("struct A float b;"), ElementsAre("9-14: `float` where a declaration was expected"));
  EXPECT_THAT(problems("if (a) { } float b;"), ElementsAre("3-4: `(` where a declaration was expected"));
}

TEST(Outline, ReportsDirectivesAndStrayBytes) {
  EXPECT_THAT(problems("#if 1\n#ifdef A // c\n"), ElementsAre("20-20: `#endif` is missing at the end of the text",
                                                              "20-20: `#endif` is missing at the end of the text"));
  EXPECT_THAT(problems("#endif\n#else"), ElementsAre("0-6: `#endif` has no `#if`", "7-12: `#else` has no `#if`"));
  EXPECT_THAT(problems("#version x"), ElementsAre("0-10: `#version` has no number that can be read"));
  EXPECT_THAT(problems("#define 1"), ElementsAre("0-9: `#define` names no macro"));
  EXPECT_THAT(problems("float a; /* b"), ElementsAre("9-13: `/*` is never closed"));
  EXPECT_THAT(problems("@ \"x\" \x01"), ElementsAre("0-1: stray `@`", "2-5: GLSL has no strings", "6-7: stray byte 0x01"));
}

TEST(Outline, ReportsBrokenMarkers) {
  const std::string expected = ": a plug marker is written `/* PLUG: name (arguments) */`";
  EXPECT_THAT(problems("/* PLUG: a */"), ElementsAre("0-13" + expected));
  EXPECT_THAT(problems("/* PLUG: (a) */"), ElementsAre("0-15" + expected));
  EXPECT_THAT(problems("/* PLUG: a (b */"), ElementsAre("0-16" + expected));
  EXPECT_THAT(problems("/* PLUG: a (b) c */"), ElementsAre("0-19" + expected));
  EXPECT_THAT(outline_of("/* PLUG: a */").markers, IsEmpty());
}

TEST(Outline, ReportsLimits) {
  const std::string deep = "float a = " + std::string(100'000, '(');
  EXPECT_THAT(problems(deep),
              ElementsAre("209-210: `;` is missing behind `(`", "210-211: brackets are nested deeper than 200"));
  const Outline cut = outline_of(std::string(kMaxShaderTokens + 1, ';'));
  ASSERT_THAT(cut.problems, SizeIs(1));
  EXPECT_EQ(cut.problems[0].message, "the text has more than 200000 tokens");
}

TEST(Outline, ListsAFewProblemsOnly) {
  const auto listed = problems(std::string(1000, ')'));
  ASSERT_THAT(listed, SizeIs(20));
  EXPECT_EQ(listed.back(), "19-20: `)` closes nothing; further problems are not listed");
}

}  // namespace
}  // namespace plugc
