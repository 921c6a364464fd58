// Which effects are left out when the composed program fails.
#include "validate/validate_recipes.h"
#include "compose_fixture.h"

namespace plugc {
namespace {

class ValidateRecipesTest : public ComposeTest {
 protected:
  ValidRecipe run(const Recipe& recipe, std::vector<Target> targets = {Target::glsl330}) {
    Validator validator({});
    return validate_recipes({recipe}, input(), {targets, false}, validator, diagnostics_, statistics_).front();
  }
  std::string left_out() const { return lines_with(said(), "effect-left-out"); }
  int good() { return fragment("uniform float a;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r *= a; }\n"); }
  int bad() { return fragment("void PLUG_fragment_modify(inout vec4 c) { c.r = missing; }\n"); }

  ValidationStatistics statistics_;
};

TEST_F(ValidateRecipesTest, SpendsNoRecheckOnAValidProgram) {
  const ValidRecipe valid = run(unlit({good(), good()}), {Target::glsl330, Target::essl300, Target::spirv});
  EXPECT_EQ(valid.targets.size(), 3U);
  EXPECT_EQ(statistics_.rechecks, 0U);
  EXPECT_EQ(said(), "");
}

TEST_F(ValidateRecipesTest, LeavesOutASingleCulprit) {
  const int first = good(), culprit = bad(), last = good();
  const ValidRecipe valid = run(unlit({first, culprit, last}));
  EXPECT_EQ(valid.used.effects, (std::vector<int>{first, last}));
  EXPECT_EQ(said(),
            "e1.0:1:49 shader-invalid: `missing`: undeclared identifier\n"
            "e1:1:1 effect-left-out: effect `e1` is left out: the program is not valid with it\n");
}

TEST_F(ValidateRecipesTest, LeavesOutSeveralCulpritsOneByOne) {
  const int kept = good();
  const ValidRecipe valid = run(unlit({bad(), kept, bad()}));
  EXPECT_EQ(valid.used.effects, std::vector<int>{kept});
  EXPECT_EQ(count(left_out(), "is not valid with it"), 2U);
}

TEST_F(ValidateRecipesTest, LeavesOutTheLatestOfAPairThatFailsTogether) {
  const int offers = fragment("void PLUG_fragment_modify(inout vec4 c) { float k; /* PLUG: level (k) */ c.r = k; }\n");
  const int between = good();
  const int fills = fragment("void PLUG_level(inout vec3 k) {}\n");
  const ValidRecipe valid = run(unlit({offers, between, fills}));
  EXPECT_EQ(valid.used.effects, (std::vector<int>{offers, between}));
  EXPECT_EQ(
      left_out(),
      "e2:1:1 effect-left-out: effect `e2` is left out: the effects `e0`, `e2` fail together, and it is the last of them\n");
}

TEST_F(ValidateRecipesTest, FindsTheCulpritAmongManyWithinItsLimit) {
  std::vector<int> effects;
  for (int i = 0; i < 150; ++i) effects.push_back(good());
  effects.insert(effects.begin() + 70, bad());
  EXPECT_EQ(run(unlit(effects)).used.effects.size(), 150U);
  EXPECT_LE(statistics_.rechecks, 20U);
}

TEST_F(ValidateRecipesTest, GivesUpWithinItsLimit) {
  std::vector<int> effects;
  for (int i = 0; i < 100; ++i) effects.push_back(bad());
  const ValidRecipe valid = run(unlit(effects));
  EXPECT_EQ(valid.targets.size(), 1U);
  EXPECT_TRUE(valid.used.effects.empty());
  EXPECT_LE(statistics_.rechecks, kMaxRechecks);
}

TEST_F(ValidateRecipesTest, PutsTheBaseShaderInPlaceOfAFaultyComposedShader) {
  const int kept = good();
  Recipe recipe = unlit({kept});
  recipe.shader = shader("void main() { gl_Position = gl_Vertex; }\n", "void main() { gl_FragColor = missing; }\n");
  const ValidRecipe valid = run(recipe);
  EXPECT_EQ(valid.used.shader, -1);
  EXPECT_EQ(valid.used.effects, std::vector<int>{kept});
  EXPECT_EQ(lines_with(said(), "shader-replaced"),
            "s0:1:1 shader-replaced: `s0` is not valid; the base shader is used instead\n");
}

TEST_F(ValidateRecipesTest, SaysNothingOfItsTrials) {
  const int calls = fragment("float half_of(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of(c.g); }\n");
  const int defines = fragment("float half_of(float x) { return x * 0.5; }\n");
  const ValidRecipe valid = run(unlit({calls, bad(), defines}));
  EXPECT_EQ(valid.used.effects, (std::vector<int>{calls, defines}));
  EXPECT_EQ(count(said(), "half_of"), 0U);
}

TEST_F(ValidateRecipesTest, ReportsConsequencesOfLeavingOut) {
  const int calls = fragment("float half_of(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of(c.g); }\n");
  const int defines = fragment("float half_of(float x) { return x * missing; }\n");
  EXPECT_TRUE(run(unlit({calls, defines})).used.effects.empty());
  EXPECT_EQ(lines_with(said(), "left out"),
            "e1:1:1 effect-left-out: effect `e1` is left out: the program is not valid with it\n"
            "e0:1:1 effect-left-out-too: effect `e0` is left out too: it needs the function `half_of` of `e1`\n");
  EXPECT_EQ(count(said(), "nothing defines it"), 0U);
}

TEST_F(ValidateRecipesTest, ConsequencesOfConsequencesNameTheirOwnCause) {
  const int first = fragment("float a(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = a(c.g); }\n");
  const int second = fragment("float b(float x);\nfloat a(float x) { return b(x); }\n");
  const int third = fragment("float b(float x) { return x * missing; }\n");
  const int kept = good();
  EXPECT_EQ(run(unlit({first, second, third, kept})).used.effects, std::vector<int>{kept});
  EXPECT_EQ(lines_with(said(), "too"),
            "e1:1:1 effect-left-out-too: effect `e1` is left out too: it needs the function `b` of `e2`\n"
            "e0:1:1 effect-left-out-too: effect `e0` is left out too: it needs the function `a` of `e1`\n");
}

TEST_F(ValidateRecipesTest, AnEffectIsNotBlamedForTheLibraryThatItNeeds) {
  const int defines = fragment("float half_of(float x) { return x * 0.5; }\n");
  const int calls = fragment("float half_of(float x);\nvoid PLUG_fragment_modify(inout vec4 c) { c.r = half_of(missing); }\n");
  const ValidRecipe valid = run(unlit({calls, defines}));
  EXPECT_EQ(valid.used.effects, std::vector<int>{defines});
  EXPECT_EQ(left_out(), "e1:1:1 effect-left-out: effect `e1` is left out: the program is not valid with it\n");
}

TEST_F(ValidateRecipesTest, NamesEveryMemberOfAMinimalFailingSet) {
  // only together are they longer than a stage may be
  const std::string long_comment = "/*" + std::string(1'500'000, '-') + "*/\n";
  const std::string code = "uniform float a;\nvoid PLUG_fragment_modify(inout vec4 c) { c.r *= a; }\n" + long_comment;
  const int first = fragment(code), small = good(), second = fragment(code), other = good(), third = fragment(code),
            last = good();
  const ValidRecipe valid = run(unlit({first, small, second, other, third, last}));
  EXPECT_EQ(valid.used.effects, (std::vector<int>{first, small, second, other, last}));
  EXPECT_EQ(
      left_out(),
      "e4:1:1 effect-left-out: effect `e4` is left out: the effects `e0`, `e2`, `e4` fail together, and it is the last of "
      "them\n");
}

TEST_F(ValidateRecipesTest, FindsIndependentFaultsAmongTwentyWithinItsLimit) {
  std::vector<int> effects, expected;
  for (int i = 0; i < 20; ++i) {
    const bool faulty = i == 3 || i == 11 || i == 19;
    effects.push_back(faulty ? bad() : good());
    if (!faulty) expected.push_back(effects.back());
  }
  EXPECT_EQ(run(unlit(effects)).used.effects, expected);
  EXPECT_EQ(count(left_out(), "is not valid with it"), 3U);
  EXPECT_LE(statistics_.rechecks, 12U);
}

TEST_F(ValidateRecipesTest, LeavesOutFaultsOfLightsTexturesAndShapesAlike) {
  const std::string scale = "void PLUG_light_scale(inout float s, const in vec3 n, const in vec3 d) { s *= ";
  const std::string color = "void PLUG_texture_color(inout vec4 t, const in sampler2D m, const in vec4 c) { t *= ";
  const int good_light = fragment(scale + "0.5; }\n"), bad_light = fragment(scale + "missing; }\n");
  const int good_texture = fragment(color + "0.5; }\n"), bad_texture = fragment(color + "missing; }\n");
  const int bad_shape = bad(), good_shape = good();
  Recipe recipe = lit({bad_shape, good_shape});
  recipe.lights.front().effects = {bad_light, good_light};
  recipe.textures.resize(1);
  recipe.textures.front().effects = {good_texture, bad_texture};
  const ValidRecipe valid = run(recipe);
  EXPECT_EQ(valid.used.lights.front().effects, std::vector<int>{good_light});
  EXPECT_EQ(valid.used.textures.front().effects, std::vector<int>{good_texture});
  EXPECT_EQ(valid.used.effects, std::vector<int>{good_shape});
}

TEST_F(ValidateRecipesTest, WhatNeedsAFaultyComposedShaderGoesWithIt) {
  const int kept = good();
  const int fills = fragment("void PLUG_tint(inout vec4 c) { c.g = 0.0; }\n");
  Recipe recipe = unlit({kept, fills});
  recipe.shader = shader("void main() { gl_Position = gl_Vertex; }\n",
                         "void main() { vec4 c = missing; /* PLUG: tint (c) */ gl_FragColor = c; }\n");
  const ValidRecipe valid = run(recipe);
  EXPECT_EQ(valid.used.shader, -1);
  EXPECT_EQ(valid.used.effects, std::vector<int>{kept});
  EXPECT_EQ(lines_with(said(), "too"),
            "e1:1:1 effect-left-out-too: effect `e1` is left out too: it needs the plug `tint` of `s0`\n");
}

TEST_F(ValidateRecipesTest, CodeWithoutItsLastBraceCostsNoRecheck) {
  const int first = good();
  const int open = fragment(
      "void PLUG_fragment_modify(inout vec4 c) { if (c.r > 0.5) { c.r = 0.5; }\nvoid PLUG_fragment_end(const in vec4 c) {}\n");
  const int last = good();
  EXPECT_EQ(run(unlit({first, open, last})).used.effects, (std::vector<int>{first, last}));
  EXPECT_EQ(statistics_.rechecks, 0U);
  EXPECT_EQ(said(),
            "e1.0:2:1 shader-syntax: `}` is missing in front of this function\n"
            "e1:1:1 effect-left-out: effect `e1` is left out: the program is not valid with it\n");
}

TEST_F(ValidateRecipesTest, IsValidForEveryTarget) {
  const std::string vertex_code =
      "varying float h;\nattribute vec3 wind;\nvoid PLUG_vertex_object_space_change(inout vec4 v, inout vec3 n) { h = v.y; "
      "v.xyz += wind; }\n";
  const std::string fragment_code =
      "#ifdef GL_ES\nprecision mediump float;\n#endif\nvarying float h; uniform float a = 0.5, b;\n"
      "uniform sampler2D texture;\nvoid PLUG_main_texture_apply(inout vec4 c, const in vec3 n) { c *= texture2D(texture, "
      "vec2(h)) * a * b; }\n";
  std::vector<int> effects;
  for (int i = 0; i < 3; ++i)
    effects.push_back(effect({{PartStage::vertex, vertex_code}, {PartStage::fragment, fragment_code}}));
  LightRecipe spot;
  spot.kind = LightKind::spot;
  spot.ambient = spot.attenuation = spot.radius = spot.beam_width = spot.shadow = spot.shadow_intensity = true;
  for (const bool gouraud : {false, true}) {
    Recipe recipe = lit(effects, {LightRecipe{}, spot});
    recipe.specular = recipe.ambient = recipe.emissive = recipe.two_sided = recipe.color_per_vertex = recipe.alpha_test =
        recipe.vertex_eye = true;
    recipe.gouraud = gouraud;
    if (gouraud) recipe.lights[1].shadow = false;
    recipe.textures.resize(2);
    EXPECT_EQ(run(recipe, {Target::glsl330, Target::essl300, Target::spirv}).targets.size(), 3U);
  }
  EXPECT_EQ(said(), "");
}

}  // namespace
}  // namespace plugc
