#include "compose_fixture.h"

namespace plugc {
namespace {

class ResolveTest : public ComposeTest {};

constexpr const char* kModify = "void PLUG_fragment_modify(inout vec4 c) { c.r = 0.5; }";

TEST_F(ResolveTest, ComposesAWholeStage) {
  const int e = fragment("void PLUG_fragment_end(const in vec4 c) { if (c.a < 0.1) discard; }\n");
  EXPECT_EQ(fragment_text(unlit({e})),
            "#version 330 core\n"
            "\n"
            "// Phong shading, fragment stage: the material, the sum of the lights, then what effects do to the result.\n"
            "out vec4 castle_FragColor;\n"
            "\n"
            "uniform vec4 castle_UnlitColor;\n"
            "\n"
            "void PLUG_fragment_end(const in vec4);\n"
            "\n"
            "// Everything that textures and effects do to the colour that enters the lighting (or, unlit, is the result).\n"
            "void main_texture_apply(inout vec4 fragment_color, const in vec3 normal_eye)\n"
            "{\n"
            "}\n"
            "\n"
            "\n"
            "vec4 lighting(const in vec4 vertex_eye, const in vec3 normal_eye)\n"
            "{\n"
            "  vec4 result = castle_UnlitColor;\n"
            "  main_texture_apply(result, normal_eye);\n"
            "  return result;\n"
            "}\n"
            "\n"
            "void main()\n"
            "{\n"
            "  vec4 vertex_eye = vec4(0.0, 0.0, 0.0, 1.0);\n"
            "  vec3 normal_eye = vec3(0.0, 0.0, 1.0);\n"
            "  vec4 fragment_color = lighting(vertex_eye, normal_eye);\n"
            "  castle_FragColor = fragment_color;\n"
            "  PLUG_fragment_end(castle_FragColor);\n"
            "}\n"
            "\n"
            "void PLUG_fragment_end(const in vec4 c) { if (c.a < 0.1) discard; }\n");
  EXPECT_EQ(said(), "");
}

TEST_F(ResolveTest, CallsPlugsInListOrder) {
  const int first = fragment(kModify), second = fragment(kModify);
  EXPECT_EQ(lines_with(fragment_text(unlit({second, first})), "(fragment_color);"),
            "PLUG_fragment_modify(fragment_color);\nPLUG_fragment_modify_2(fragment_color);\n");
  EXPECT_EQ(program_.plugs_filled, std::vector<std::string>{"fragment_modify"});
}

TEST_F(ResolveTest, CallsSeveralDefinitionsOfOnePartInTextOrder) {
  const int e = fragment(
      "void PLUG_fragment_modify(inout vec4 c) { c.r = 0.1; }\nvoid PLUG_fragment_modify(inout vec4 d) { d.r = 0.2; }\n");
  EXPECT_EQ(
      last_lines(fragment_text(unlit({e})), 2),
      "void PLUG_fragment_modify(inout vec4 c) { c.r = 0.1; }\nvoid PLUG_fragment_modify_2(inout vec4 d) { d.r = 0.2; }\n");
}

TEST_F(ResolveTest, KeepsPlugNamesApartThatStartAlike) {
  const int e = vertex(
      "void PLUG_vertex_object_space(const in vec4 v, inout vec3 n) {}\n"
      "void PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) {}\n");
  EXPECT_EQ(lines_with(vertex_text(unlit({e})), "(vertex_object, normal_object);"),
            "PLUG_vertex_object_space_change(vertex_object, normal_object);\nPLUG_vertex_object_space(vertex_object, "
            "normal_object);\n");
}

TEST_F(ResolveTest, ScalesOneLightByItsOwnEffectAndAllByTheShapes) {
  const std::string scale = "void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) { s = 0.5; }";
  const int own = fragment(scale), all = fragment(scale);
  LightRecipe with_effect;
  with_effect.effects = {own};
  const std::string text = fragment_text(lit({all}, {LightRecipe{}, with_effect}));
  EXPECT_EQ(lines_with(text, "(light_scale, "),
            "PLUG_light_scale_2(light_scale, normal_eye, light_dir);\n"
            "PLUG_light_scale(light_scale, normal_eye, light_dir);\n"
            "PLUG_light_scale_2(light_scale, normal_eye, light_dir);\n");
}

TEST_F(ResolveTest, CallsALightsEffectBeforeItsShadow) {
  LightRecipe light;
  light.shadow = true;
  light.effects = {fragment("void PLUG_light_scale(inout float own, vec3 n, vec3 d) { own = 0.5; }")};
  const std::string text = fragment_text(lit({}, {light}));
  EXPECT_EQ(count(text, "PLUG_light_scale(light_scale"), 1U);
  EXPECT_LT(text.find("PLUG_light_scale(light_scale"), text.find("PLUG_light_scale_2(light_scale"));
  EXPECT_NE(text.find("void PLUG_light_scale(inout float own"), std::string::npos);
}

TEST_F(ResolveTest, LooksInTheShapeForWhatALightLacks) {
  LightRecipe light;
  light.effects = {fragment(kModify)};
  EXPECT_EQ(count(fragment_text(lit({}, {light})), "PLUG_fragment_modify(fragment_color);"), 1U);
}

TEST_F(ResolveTest, ShowsATextureToItsOwnEffectAlone) {
  const std::string grey = "void PLUG_texture_color(inout vec4 c, const in sampler2D t, const in vec4 p) { c = c.rrra; }";
  Recipe recipe = unlit({});
  recipe.textures.resize(2);
  recipe.textures[1].effects = {fragment(grey)};
  EXPECT_EQ(lines_with(fragment_text(recipe), "PLUG_texture_color(texture"),
            "PLUG_texture_color(texture_color, castle_texture_1, tex_coord);\n");
}

TEST_F(ResolveTest, ChoosesOverloadsByTheSampler) {
  const int e = fragment(
      "void PLUG_texture_color(inout vec4 c, const in samplerCube t, const in vec4 p) {}\n"
      "void PLUG_texture_color(inout vec4 c, const in sampler2D t, const in vec4 p) {}\n");
  Recipe recipe = unlit({e});
  recipe.textures.resize(1);
  EXPECT_EQ(lines_with(fragment_text(recipe), "(texture_color, "),
            "PLUG_texture_color_2(texture_color, castle_texture_0, tex_coord);\n");
  EXPECT_EQ(said(), "");
}

TEST_F(ResolveTest, NotesATextureOfAnotherKind) {
  const int e = fragment("void PLUG_texture_color(inout vec4 c, const in samplerCube t, const in vec4 p) {}\n");
  Recipe recipe = unlit({e});
  recipe.textures.resize(1);
  EXPECT_EQ(count(fragment_text(recipe), "PLUG_texture_color("), 1U);
  EXPECT_EQ(
      said(),
      "e0.0:1:6 effect-plug-absent: plug `texture_color` is not called for every shape that uses this effect (it is called "
      "per texture, after sampling; a ShaderTexture has no sampler parameter)\n");
}

TEST_F(ResolveTest, ServesLaterEffectsWithAMarkerOfAnEarlierOne) {
  const int offers = fragment("void PLUG_fragment_modify(inout vec4 c) { float k = 1.0; /* PLUG: level (k) */ c.r = k; }\n");
  const int fills = fragment("void PLUG_level(inout float k) { k = 0.5; }\n");
  EXPECT_EQ(
      last_lines(fragment_text(unlit({offers, fills})), 4),
      "void PLUG_level(inout float);\nvoid PLUG_fragment_modify(inout vec4 c) { float k = 1.0; PLUG_level(k); c.r = k; }\n\n"
      "void PLUG_level(inout float k) { k = 0.5; }\n");
}

TEST_F(ResolveTest, TellsAPlugThatIsOfferedOnlyLater) {
  const int fills = fragment("void PLUG_level(inout float k) { k = 0.5; }\n");
  const int offers = fragment("void PLUG_fragment_modify(inout vec4 c) { /* PLUG: level (c.r) */ }\n");
  compose_all(unlit({fills, offers}));
  EXPECT_EQ(said(),
            "e0.0:1:6 effect-unknown-plug: plug `level` is offered only behind this function; a plug of an effect serves what "
            "comes later\n");
}

TEST_F(ResolveTest, ServesLaterPartsOfTheSameEffect) {
  const int e = effect({{PartStage::fragment, "void PLUG_fragment_modify(inout vec4 c) { /* PLUG: level (c.r) */ }"},
                        {PartStage::fragment, "void PLUG_level(inout float k) { k = 0.5; }"}});
  EXPECT_EQ(count(fragment_text(unlit({e})), "{ PLUG_level(c.r); }"), 1U);
}

TEST_F(ResolveTest, ServesAllPartsWithAMarkerOfAComposedShader) {
  Recipe recipe = unlit({fragment("void PLUG_level(inout float k) { k = 0.5; }")});
  recipe.shader = shader("void main() { gl_Position = vec4(0.0); }",
                         "void PLUG_level(inout float own) { own = 0.25; }\nvoid main() { float k = 1.0; /* PLUG: level (k) */ "
                         "gl_FragColor = vec4(k); }");
  EXPECT_EQ(lines_with(fragment_text(recipe), "void main"), "void main() { float k = 1.0; PLUG_level(k);\n");
  EXPECT_EQ(count(program_.stages[1].text.text(), "PLUG_level_2(k);"), 1U);
}

TEST_F(ResolveTest, KeepsTwoCallsOneStatement) {
  const int offers = fragment(
      "void PLUG_fragment_modify(inout vec4 c) { for (int i = 0; i < 3; i++) /* PLUG: step (c) */\n c.g = 1.0;\n"
      "if (c.r > 0.5) /* PLUG: never (c) */\n c.b = 1.0; }\n");
  const int fills = fragment("void PLUG_step(inout vec4 c) {}\nvoid PLUG_step(inout vec4 d) {}\n");
  const std::string text = fragment_text(unlit({offers, fills}));
  EXPECT_EQ(lines_with(text, "for ("),
            "void PLUG_fragment_modify(inout vec4 c) { for (int i = 0; i < 3; i++) { PLUG_step(c);\n");
  EXPECT_EQ(lines_with(text, "PLUG_step_2(c)"), "PLUG_step_2(c); }\n");
  EXPECT_EQ(lines_with(text, "if (c.r"), "if (c.r > 0.5) {}\n");
}

TEST_F(ResolveTest, TakesNoMarkerOutsideOfFunctions) {
  const int offers = fragment("/* PLUG: level (k) */\nvoid PLUG_fragment_modify(inout vec4 c) {}\n");
  const int fills = fragment("void PLUG_level(inout float k) {}\n");
  compose_all(unlit({offers, fills}));
  EXPECT_EQ(said(), "e1.0:1:6 effect-unknown-plug: no plug `level` in a fragment stage\n");
}

TEST_F(ResolveTest, AcceptsWeakenedQualifiers) {
  const int e = effect({{PartStage::fragment,
                         "void PLUG_fragment_end(vec4 c) {}\nvoid PLUG_fragment_modify(out vec4 c) { c = vec4(1.0); }\n"
                         "void PLUG_fog_apply(const in vec4 c, vec3 n) {}"},
                        {PartStage::vertex, "void PLUG_vertex_eye_space(in vec4 v, vec3 n) {}"}});
  const std::string text = fragment_text(unlit({e}));
  EXPECT_EQ(lines_with(text, "void PLUG_fragment_modify(out vec4)"), "void PLUG_fragment_modify(out vec4);\n");
  EXPECT_EQ(said(), "");
}

TEST_F(ResolveTest, TakesBothFormsOfALightsSpecularColour) {
  Recipe recipe = lit({fragment("void PLUG_material_light_specular(inout vec3 s) {}"),
                       fragment("void PLUG_material_light_specular(inout vec4 s) {}")});
  recipe.specular = true;
  EXPECT_EQ(lines_with(fragment_text(recipe), "(specular"),
            "PLUG_material_light_specular(specular.rgb);\nPLUG_material_light_specular_2(specular);\n");
}

struct Mistake {
  const char* code;
  const char* said;
  bool faulty;
};

class MistakeTest : public ComposeTest, public testing::WithParamInterface<Mistake> {};

TEST_P(MistakeTest, IsReportedAtTheFunction) {
  const int e = fragment(GetParam().code);
  compose_all(unlit({e}));
  EXPECT_EQ(said(), std::string("e0.0:1:") + GetParam().said + "\n");
  EXPECT_EQ(program_.faulty_effects, GetParam().faulty ? std::vector<int>{e} : std::vector<int>{});
}

INSTANTIATE_TEST_SUITE_P(
    Each, MistakeTest,
    testing::Values(
        Mistake{"float PLUG_fragment_modify(inout vec4 c) { return 1.0; }",
                "7 effect-plug-not-void: `PLUG_fragment_modify` returns `float`; a plug function returns `void`", true},
        Mistake{"void PLUG_fragment_modify(inout vec3 c) {}",
                "27 effect-wrong-signature: `PLUG_fragment_modify` does not fit its plug; declare `void "
                "PLUG_fragment_modify(inout vec4 "
                "fragment_color)`",
                true},
        Mistake{
            "void PLUG_fragment_end(inout vec4 c) {}",
            "24 effect-wrong-signature: `PLUG_fragment_end` does not fit its plug; declare `void PLUG_fragment_end(const in "
            "vec4 "
            "fragment_color)`",
            true},
        Mistake{"void PLUG_fragment_modif(inout vec4 c) {}",
                "6 effect-unknown-plug: no plug `fragment_modif` in a fragment stage; did you mean `fragment_modify`?", false},
        Mistake{"void PLUG_vertex_eye_space(const in vec4 v, const in vec3 n) {}",
                "6 effect-wrong-stage: plug `vertex_eye_space` is not called in a fragment stage; put it into a part of type "
                "`VERTEX`",
                false},
        Mistake{"void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) {}",
                "6 effect-plug-absent: plug `light_scale` is not called for every shape that uses this effect (it is called "
                "per light; "
                "light_dir is normalised, in eye space, towards the light)",
                false},
        Mistake{"void PLUG_texture_apply(inout vec4 c, const in vec3 n) {}",
                "6 effect-deprecated-plug: plug `texture_apply` is an old name; use `main_texture_apply` (or `fragment_modify` "
                "for the "
                "final colour)",
                false}));

TEST_F(ResolveTest, ReportsWrongArgumentsOfACustomPlug) {
  const int offers = fragment("void PLUG_fragment_modify(inout vec4 c) { /* PLUG: level (c.r, c.g) */ }\n");
  const int fills = fragment("void PLUG_level(inout float k) {}\n");
  compose_all(unlit({offers, fills}));
  EXPECT_EQ(said(), "e1.0:1:6 effect-wrong-signature: `PLUG_level` takes 1 arguments, but its plug passes 2\n");
  EXPECT_EQ(program_.faulty_effects, std::vector<int>{fills});
}

TEST_F(ResolveTest, ChoosesOverloadsOfACustomPlugByDeclaredTypes) {
  const int offers = fragment("void PLUG_fragment_modify(inout vec4 c) { vec3 v = c.rgb; /* PLUG: tint (v) */ }\n");
  const int fills = fragment("void PLUG_tint(inout float k) {}\nvoid PLUG_tint(inout vec3 v) {}\n");
  EXPECT_EQ(lines_with(fragment_text(unlit({offers, fills})), "(v);"),
            "void PLUG_fragment_modify(inout vec4 c) { vec3 v = c.rgb; PLUG_tint_2(v); }\n");
  EXPECT_EQ(said(), "");
}

TEST_F(ResolveTest, LeavesAComposedShaderWithoutPlugsAsWritten) {
  Recipe recipe = lit({});
  recipe.textures.resize(1);
  recipe.shader = shader("void main() { gl_Position = vec4(0.0); }\n", "void main() { gl_FragColor = vec4(1.0); }\n");
  EXPECT_EQ(fragment_text(recipe),
            "#version 330 core\nout vec4 castle_FragColor;\n\nvoid main() { castle_FragColor = vec4(1.0); }\n");
  EXPECT_EQ(vertex_text(recipe), "#version 330 core\n\nvoid main() { gl_Position = vec4(0.0); }\n");
}

TEST_F(ResolveTest, StopsWhenCallsOutgrowAStage) {
  std::string markers = "void PLUG_fragment_modify(inout vec4 c) {", functions;
  for (int i = 0; i < 2000; ++i) markers += "/* PLUG: foo (c) */\n";
  for (int i = 0; i < 2000; ++i) functions += "void PLUG_foo(inout vec4 c) {}\n";
  const int offers = fragment(markers + "}"), fills = fragment(functions);
  compose_all(unlit({offers, fills}));
  EXPECT_EQ(diagnostics_.all().size(), 1U);
  EXPECT_EQ(diagnostics_.all().front().id, DiagnosticId::shader_limit);
  EXPECT_EQ(program_.faulty_effects, std::vector<int>{fills});
}

}  // namespace
}  // namespace plugc
