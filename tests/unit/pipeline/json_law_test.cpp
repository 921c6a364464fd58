// The JSON encoding says what the others say: the same scene in all three gives the same programs and the same picture.

#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

using testing::IsEmpty;

constexpr std::string_view kClassic = R"(#X3D V4.0 utf8
PROTO Lamp [ inputOutput SFFloat strength 0.25 ] {
  PointLight { location 1 2 5 intensity IS strength }
}
Lamp { strength 0.75 }
DEF Ball Shape {
  appearance Appearance {
    material Material { diffuseColor 0.5 0.25 1 }
    effects Effect { language "GLSL"
      inputOutput SFFloat level 0.5
      inputOutput SFBool tinted TRUE
      parts [
        EffectPart { type "VERTEX" url "data:text/plain,
varying float height;
void PLUG_vertex_object_space(const in vec4 vertex, inout vec3 normal) { height = vertex.y; }
" }
        EffectPart { type "FRAGMENT" url "data:text/plain,
varying float height;
uniform float level;
uniform bool tinted;
void PLUG_fragment_modify(inout vec4 color) { if (tinted) color.r = level + 0.1 * height; }
" }
      ]
    }
  }
  geometry Sphere { }
}
Transform { translation 2 0 0 children USE Ball }
)";

constexpr std::string_view kXml = R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version="4.0" profile="Interchange">
<Scene>
<ProtoDeclare name="Lamp">
  <ProtoInterface><field accessType="inputOutput" type="SFFloat" name="strength" value="0.25"/></ProtoInterface>
  <ProtoBody><PointLight location="1 2 5"><IS><connect nodeField="intensity" protoField="strength"/></IS></PointLight></ProtoBody>
</ProtoDeclare>
<ProtoInstance name="Lamp"><fieldValue name="strength" value="0.75"/></ProtoInstance>
<Shape DEF="Ball">
  <Appearance>
    <Material diffuseColor="0.5 0.25 1"/>
    <Effect containerField="effects" language="GLSL">
      <field accessType="inputOutput" type="SFFloat" name="level" value="0.5"/>
      <field accessType="inputOutput" type="SFBool" name="tinted" value="true"/>
      <EffectPart containerField="parts" type="VERTEX"><![CDATA[
varying float height;
void PLUG_vertex_object_space(const in vec4 vertex, inout vec3 normal) { height = vertex.y; }
]]></EffectPart>
      <EffectPart containerField="parts" type="FRAGMENT"><![CDATA[
varying float height;
uniform float level;
uniform bool tinted;
void PLUG_fragment_modify(inout vec4 color) { if (tinted) color.r = level + 0.1 * height; }
]]></EffectPart>
    </Effect>
  </Appearance>
  <Sphere/>
</Shape>
<Transform translation="2 0 0"><Shape USE="Ball"/></Transform>
</Scene>
</X3D>
)";

constexpr std::string_view kJson = R"({ "X3D": {
  "encoding": "UTF-8", "@profile": "Interchange", "@version": "4.0",
  "Scene": { "-children": [
    { "ProtoDeclare": {
        "@name": "Lamp",
        "ProtoInterface": { "field": [
          { "@accessType": "inputOutput", "@type": "SFFloat", "@name": "strength", "@value": 0.25 } ] },
        "ProtoBody": { "-children": [
          { "PointLight": { "@location": [1, 2, 5],
              "IS": { "connect": [ { "@nodeField": "intensity", "@protoField": "strength" } ] } } } ] } } },
    { "ProtoInstance": { "@name": "Lamp", "fieldValue": [ { "@name": "strength", "@value": "0.75" } ] } },
    { "#comment": "the ball" },
    { "Shape": {
        "@DEF": "Ball",
        "-appearance": { "Appearance": {
          "-material": { "Material": { "@diffuseColor": [0.5, 0.25, 1.0] } },
          "-effects": [ { "Effect": {
            "@language": "GLSL",
            "field": [
              { "@name": "level", "@type": "SFFloat", "@accessType": "inputOutput", "@value": 0.5 },
              { "@name": "tinted", "@type": "SFBool", "@accessType": "inputOutput", "@value": true } ],
            "-parts": [
              { "EffectPart": { "@type": "VERTEX", "@url": [
"data:text/plain,\nvarying float height;\nvoid PLUG_vertex_object_space(const in vec4 vertex, inout vec3 normal) { height = vertex.y; }\n"
              ] } },
              { "EffectPart": { "@type": "FRAGMENT", "#sourceCode": [
                "",
                "varying float height;",
                "uniform float level;",
                "uniform bool tinted;",
                "void PLUG_fragment_modify(inout vec4 color) { if (tinted) color.r = level + 0.1 * height; }",
                "" ] } } ] } } ] } },
        "-geometry": { "Sphere": { } } } },
    { "Transform": { "@translation": [2, 0, 0], "-children": [ { "Shape": { "@USE": "Ball" } } ] } }
  ] } } }
)";

TEST(JsonLaw, OneSceneInThreeEncodingsComposesToTheSameTexts) {
  const Compiled classic = compile_text(kClassic);
  const Compiled xml = compile_text(kXml, {}, "scene.x3d");
  const Compiled json = compile_text(kJson, {}, "scene.x3dj");
  EXPECT_THAT(json.messages(), IsEmpty());
  EXPECT_THAT(program_texts(json), testing::SizeIs(2));
  EXPECT_EQ(program_texts(json), program_texts(classic));
  EXPECT_EQ(program_texts(json), program_texts(xml));
  EXPECT_EQ(draw_package(*json.package).pixels, draw_package(*classic.package).pixels);
}

TEST(JsonLaw, AMistakeInALineOfCodeStandsAtThatLine) {
  std::string faulty(kJson);
  const std::string_view right = "PLUG_fragment_modify(inout vec4 color)";
  faulty.replace(faulty.find(right), right.size(), "PLUG_fragment_modfy(inout vec4 color)");
  EXPECT_THAT(compile_text(faulty, {}, "scene.x3dj").messages(),
              testing::Contains(
                  "31:23 effect-unknown-plug no plug `fragment_modfy` in a fragment stage; did you mean `fragment_modify`?"));
}

TEST(JsonLaw, AnInlinedJsonFileIsReadByItsContent) {
  const SceneFolder folder;
  folder.write("ball.json", kJson);
  const auto scene = folder.write("scene.x3dv", "#X3D V4.0 utf8\nInline { url \"ball.json\" }\n");
  const Compiled compiled = compile_file(scene);
  EXPECT_THAT(compiled.messages(), IsEmpty());
  EXPECT_EQ(program_texts(compiled), program_texts(compile_text(kClassic)));
}

}  // namespace
}  // namespace plugc
