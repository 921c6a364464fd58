// What holds of every compilation.

#include <fstream>

#include <fmt/format.h>

#include "package/package_file.h"
#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kClassic = R"(#X3D V4.0 utf8
PointLight { location 1 2 5 }
Shape {
  appearance Appearance {
    material Material { diffuseColor 0.5 0.25 1 }
    effects Effect { language "GLSL"
      inputOutput SFFloat level 0.5
      parts [
        EffectPart { type "VERTEX" url "data:text/plain,
varying float height;
void PLUG_vertex_object_space(const in vec4 vertex, inout vec3 normal) { height = vertex.y; }
" }
        EffectPart { type "FRAGMENT" url "data:text/plain,
varying float height;
uniform float level;
void PLUG_fragment_modify(inout vec4 color) { color.r = level + 0.1 * height; }
" }
      ]
    }
  }
  geometry Sphere { }
}
)";

constexpr std::string_view kXml = R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version="4.0" profile="Interchange">
<Scene>
<PointLight location="1 2 5"/>
<Shape>
  <Appearance>
    <Material diffuseColor="0.5 0.25 1"/>
    <Effect containerField="effects" language="GLSL">
      <field accessType="inputOutput" type="SFFloat" name="level" value="0.5"/>
      <EffectPart containerField="parts" type="VERTEX"><![CDATA[
varying float height;
void PLUG_vertex_object_space(const in vec4 vertex, inout vec3 normal) { height = vertex.y; }
]]></EffectPart>
      <EffectPart containerField="parts" type="FRAGMENT"><![CDATA[
varying float height;
uniform float level;
void PLUG_fragment_modify(inout vec4 color) { color.r = level + 0.1 * height; }
]]></EffectPart>
    </Effect>
  </Appearance>
  <Sphere/>
</Shape>
</Scene>
</X3D>
)";

TEST(Laws, OneSceneInTwoEncodingsComposesToTheSameTexts) {
  const Compiled classic = compile_text(kClassic);
  const Compiled xml = compile_text(kXml, {}, "scene.x3d");
  EXPECT_THAT(classic.messages(), IsEmpty());
  EXPECT_THAT(xml.messages(), IsEmpty());
  EXPECT_EQ(program_texts(classic), program_texts(xml));
  EXPECT_EQ(draw_package(*classic.package).pixels, draw_package(*xml.package).pixels);
}

TEST(Laws, BuildingTwiceGivesTheSameBytes) {
  const SceneFolder folder;
  const auto scene = folder.write("scene.x3dv", kClassic);
  EXPECT_EQ(compile_file(scene).bytes, compile_file(scene).bytes);
}

TEST(Laws, AnEmptyEffectChangesNoProgram) {
  const std::string shape = "Shape { appearance Appearance { material Material { } ";
  const Compiled without = compile_text("#X3D V4.0 utf8\n" + shape + "} geometry Box { } }");
  const Compiled with = compile_text("#X3D V4.0 utf8\n" + shape + "effects Effect { language \"GLSL\" } } geometry Box { } }");
  EXPECT_EQ(program_texts(without), program_texts(with));
  EXPECT_FALSE(program_texts(with).empty());
}

std::string two_boxes(std::string_view first_effects, std::string_view second_effects) {
  std::string text = "#X3D V4.0 utf8\n";
  for (const std::string_view effects : {first_effects, second_effects}) {
    text += "Shape { appearance Appearance { material UnlitMaterial { emissiveColor 1 1 1 } " + std::string(effects) +
            " } geometry Box { } }\n";
  }
  return text;
}

constexpr std::string_view kRed =
    R"(effects Effect { inputOutput SFFloat level 0.5 parts EffectPart { type "FRAGMENT" url "data:text/plain,
uniform float level; void PLUG_fragment_modify(inout vec4 c) { c.r = level; }" } })";
constexpr std::string_view kPaleRed =
    R"(effects Effect { inputOutput SFFloat level 0.9 parts EffectPart { type "FRAGMENT" url "data:text/plain,
uniform float level; void PLUG_fragment_modify(inout vec4 c) { c.r = level; }" } })";
constexpr std::string_view kGreen = R"(effects Effect { parts EffectPart { type "FRAGMENT" url "data:text/plain,
void PLUG_fragment_modify(inout vec4 c) { c.g = 0.5; }" } })";

TEST(Laws, EffectsOfEqualCodeShareOneProgram) {
  const Compiled compiled = compile_text(two_boxes(kRed, kPaleRed));
  EXPECT_THAT(compiled.messages(), IsEmpty());
  EXPECT_EQ(compiled.package->programs()->size(), 1U);
  EXPECT_EQ(compiled.package->scenes()->Get(0)->shapes()->size(), 2U);
}

TEST(Laws, TheOrderOfEqualRecipesIsNoMatter) {
  const Compiled one = compile_text(two_boxes(kRed, kPaleRed));
  const Compiled other = compile_text(two_boxes(kPaleRed, kRed));
  EXPECT_EQ(program_texts(one), program_texts(other));
}

/// Two by two texels.
constexpr std::string_view kPng =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAAAAABX3VL4AAAADklEQVR42mP4P41h2n8ACYQDK1KsyeEAAAAASUVORK5CYII=";

TEST(Laws, AnEmptyEffectChangesNoProgramWhereverItStands) {
  const std::string effect = " effects Effect { language \"GLSL\" }";
  const auto scene = [](std::string_view light, std::string_view texture, std::string_view group) {
    return fmt::format(
        "#X3D V4.0 utf8\nSpotLight {{ location 0 0 5{} }}\nGroup {{ children [ {} Shape {{ appearance Appearance {{ "
        "material Material {{ }} texture ImageTexture {{ url \"data:image/png;base64,{}\"{} }} }} geometry Box {{ }} "
        "}} ] }}",
        light, group, kPng, texture);
  };
  const auto without = program_texts(compile_text(scene("", "", "")));
  EXPECT_EQ(program_texts(compile_text(scene(effect, "", ""))), without);
  EXPECT_EQ(program_texts(compile_text(scene("", effect, ""))), without);
  EXPECT_EQ(program_texts(compile_text(scene("", "", "Effect { language \"GLSL\" }"))), without);
  EXPECT_FALSE(without.empty());
}

/// As each form of a template is made once in a process, whoever was first must not be seen in what others get.
TEST(Laws, WhatWasCompiledBeforeIsNoMatter) {
  const SceneFolder folder;
  const auto scene = folder.write("scene.x3dv", kClassic);
  const auto alone = compile_file(scene).bytes;
  compile_text(two_boxes(kRed, kGreen));
  compile_text(kXml, {}, "scene.x3d");
  EXPECT_EQ(compile_file(scene).bytes, alone);
}

TEST(Laws, EffectsOfOtherCodeDoNot) {
  EXPECT_EQ(compile_text(two_boxes(kRed, kGreen)).package->programs()->size(), 2U);
}

TEST(Laws, EqualProgramsOfSeveralScenesAreStoredOnce) {
  const SceneFolder folder;
  const auto first = folder.write("first.x3dv", two_boxes(kRed, kGreen));
  const auto second = folder.write("second.x3dv", two_boxes(kGreen, kPaleRed));
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions options;
  options.root = folder.path();
  const Compilation made = compile({first, second}, options, process_validator(), sources, diagnostics);
  EXPECT_EQ(made.package.scenes.size(), 2U);
  EXPECT_EQ(made.package.programs.size(), 2U);
}

TEST(Laws, EveryLineOfAnAuthorLeadsBackToIt) {
  const Compiled compiled = compile_text(kClassic);
  const PackedStage& fragment = *compiled.package->programs()->Get(0)->targets()->Get(0)->stages()->Get(1);
  std::uint32_t line = 1;
  const std::string text = fragment.text()->str();
  const std::size_t at = text.find("void PLUG_fragment_modify(inout vec4 color) {");
  ASSERT_NE(at, std::string::npos);
  line += static_cast<std::uint32_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  EXPECT_EQ(fragment.origins()->Get(line - 1)->line(), 16U);
}

}  // namespace
}  // namespace plugc
