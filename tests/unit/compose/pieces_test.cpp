// The small pieces: templates cut and numbered, the plug table, castle_ names, fields against uniforms, docs/plugs.md.
#include <fstream>
#include <iterator>
#include <set>

#include "compose/castle_names.h"
#include "compose/plug_signature.h"
#include "compose/plug_table.h"
#include "compose_fixture.h"
#include "glsl/marker.h"
#include "stdlib_plugs/stdlib_plugs.h"

namespace plugc {
namespace {

class TemplatesTest : public ComposeTest {
 protected:
  std::string cut(const std::string& text, const Features& features) {
    return std::string(cut_template(sources_, sources_.add("t", text), features).text());
  }
  std::string number(const std::string& text, int value) {
    const SourceId id = sources_.add("t", text);
    return std::string(number_names(MappedText(sources_, {id, 0, static_cast<std::uint32_t>(text.size())}), value).text());
  }
};

TEST_F(TemplatesTest, KeepsTheBranchesOfItsFeatures) {
  const std::string text = "a\n#ifdef X\nb\n#ifndef Y\nc\n#else\nd\n#endif\n#else\ne\n#endif\nf\n";
  EXPECT_EQ(cut(text, {}), "a\ne\nf\n");
  EXPECT_EQ(cut(text, {"X"}), "a\nb\nc\nf\n");
  EXPECT_EQ(cut(text, {"X", "Y"}), "a\nb\nd\nf\n");
}

TEST_F(TemplatesTest, NumbersNamesInCodeAndMarkers) {
  EXPECT_EQ(number("uniform vec3 castle_LightSourceNColor; void light_source_N() {}\n", 3),
            "uniform vec3 castle_LightSource3Color; void light_source_3() {}\n");
  EXPECT_EQ(number("/* PLUG: texture_color (texture_color, castle_texture_N, castle_TexCoordN) */\n", 12),
            "/* PLUG: texture_color (texture_color, castle_texture_12, castle_TexCoord12) */\n");
}

TEST_F(TemplatesTest, LeavesOtherCapitalsAlone) {
  EXPECT_EQ(number("castle_Normal castle_NormalMatrix NORMALS N _N\n", 1), "castle_Normal castle_NormalMatrix NORMALS N _N\n");
}

TEST_F(TemplatesTest, AreMadeOnceForEachForm) {
  const auto one = templates_.get("light.glsl", {"SPOT"}, 0);
  EXPECT_EQ(templates_.get("light.glsl", {"SPOT"}, 0), one);
  EXPECT_NE(templates_.get("light.glsl", {"SPOT"}, 1), one);
  EXPECT_NE(templates_.get("light.glsl", {}, 0), one);
}

TEST(PlugTable, ReadsParameters) {
  const PlugInfo* plug = find_plug("texture_color");
  ASSERT_NE(plug, nullptr);
  EXPECT_EQ(plug->stage, PlugStage::fragment);
  ASSERT_EQ(plug->parameters.size(), 3U);
  EXPECT_TRUE(plug->parameters[1].is_const);
  EXPECT_EQ(plug->parameters[1].direction, "in");
  EXPECT_EQ(plug->parameters[1].type, "samplerT");
  EXPECT_EQ(plug->parameters[0].direction, "inout");
  EXPECT_EQ(find_plug("texture_apply")->replaced_by, "main_texture_apply");
  EXPECT_TRUE(find_plug("geometry_vertex_zero")->parameters.empty());
  EXPECT_EQ(find_plug("no_plug"), nullptr);
}

/// Markers of the templates: name -> the numbers of arguments that they pass.
std::map<std::string, std::set<std::size_t>> template_markers() {
  std::map<std::string, std::set<std::size_t>> markers;
  for (const std::string_view name : {"phong.vert", "phong.frag", "gouraud.vert", "gouraud.frag", "depth.vert", "light.glsl",
                                      "texture.frag", "tangent.vert"}) {
    SourceSet sources;
    const std::string text(stdlib_text("templates/" + std::string(name)));
    const SourceId id = sources.add("t", text);
    for (std::size_t at = text.find("/* PLUG:"); at != std::string::npos; at = text.find("/* PLUG:", at + 1)) {
      const std::size_t open = text.find('(', at), close = text.find(") */", at);
      const std::string plug = text.substr(at + 9, open - at - 10);
      markers[plug].insert(split_arguments(std::string_view(text).substr(open + 1, close - open - 1)).size());
    }
    EXPECT_TRUE(id.valid());
  }
  return markers;
}

TEST(PlugTable, AgreesWithTheTemplatesMarkers) {
  const std::set<std::string_view> not_called = {"geometry_vertex_set", "geometry_vertex_zero", "geometry_vertex_add"};
  const auto markers = template_markers();
  for (const auto& [name, counts] : markers) {
    const PlugInfo* plug = find_plug(name);
    ASSERT_NE(plug, nullptr) << name;
    std::set<std::size_t> expected = {plug->parameters.size()};
    if (name == "texture_color") expected.insert(plug->parameters.size() - 1);  // a ShaderTexture has no sampler
    if (name == "add_light") expected.insert(plug->parameters.size() + 1);      // `view` for physical materials
    EXPECT_EQ(counts, expected) << name;
  }
  for (const PlugInfo& plug : plug_table()) {
    EXPECT_EQ(markers.contains(std::string(plug.name)), !not_called.contains(plug.name)) << plug.name;
  }
}

TEST(PlugTable, StandsInTheDocumentation) {
  std::ifstream file(std::string(PLUGC_SOURCE_DIR) + "/docs/plugs.md");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const PlugInfo& plug : plug_table()) {
    const std::string signature = plug.signature.empty() ? "none" : "`" + std::string(plug.signature) + "`";
    const std::string row = "| `" + std::string(plug.name) + "` |";
    const std::size_t at = text.find(row);
    ASSERT_NE(at, std::string::npos) << plug.name;
    EXPECT_NE(text.substr(at, text.find('\n', at) - at).find(signature), std::string::npos) << plug.name;
  }
}

TEST(PlugSignature, SplitsArgumentsAtOuterCommas) {
  EXPECT_EQ(split_arguments("  "), std::vector<std::string_view>{});
  EXPECT_EQ(split_arguments("a, f(b, c)[d,e] ,g"), (std::vector<std::string_view>{"a", "f(b, c)[d,e]", "g"}));
}

TEST(CastleNames, KnowNumbersAndKinds) {
  EXPECT_EQ(find_castle_name("castle_LightSource12SpotCosCutoff")->number, 12);
  EXPECT_EQ(find_castle_name("castle_LightSource12SpotCosCutoff")->type, "float");
  EXPECT_EQ(find_castle_name("castle_TexCoord0")->kind, CastleKind::varying);
  EXPECT_EQ(find_castle_name("castle_Normal")->kind, CastleKind::attribute);
  EXPECT_EQ(find_castle_name("castle_NormalMatrix")->number, -1);
}

TEST(CastleNames, RefuseWhatIsNotFed) {
  for (const std::string_view name : {"castle_", "castle_TexCoord", "castle_TexCoord1234", "castle_LightSourceColor",
                                      "castle_LightSource1Colour", "gl_Vertex"}) {
    EXPECT_FALSE(find_castle_name(name).has_value()) << name;
  }
}

TEST(CastleNames, NumberALightsOwn) {
  EXPECT_EQ(number_own_light("castle_LightSourceColor", 7), "castle_LightSource7Color");
  EXPECT_EQ(number_own_light("castle_LightSource", 7), "");
  EXPECT_EQ(number_own_light("castle_LightSource0Color", 7), "");
}

class FieldsTest : public ComposeTest {
 protected:
  void check(const std::string& code, const std::vector<std::pair<std::string_view, FieldType>>& fields) {
    const int e = fragment(code);
    SceneEffect& effect = scene_.effects[static_cast<std::size_t>(e)];
    for (const auto& [name, type] : fields) {
      ShaderField field;
      field.name = name;
      field.type = type;
      field.span = {sources_.add("field", std::string(name)), 0, 1};
      effect.fields.push_back(field);
    }
    check_fields(Scene(), effect, effects_[static_cast<std::size_t>(e)], diagnostics_);
  }
};

TEST_F(FieldsTest, AcceptsPairsThatFit) {
  check("uniform float a, b; uniform vec3 c[2]; uniform vec4 r; uniform sampler2D t; uniform mat3 m; uniform float set = 1.0;",
        {{"a", FieldType::SFTime},
         {"b", FieldType::SFFloat},
         {"c", FieldType::MFColor},
         {"r", FieldType::SFRotation},
         {"t", FieldType::SFNode},
         {"m", FieldType::SFMatrix3d}});
  EXPECT_EQ(said(), "");
}

TEST_F(FieldsTest, ReportsWhatDoesNotFit) {
  check("uniform float size;", {{"size", FieldType::SFVec3f}, {"colour", FieldType::SFColor}});
  EXPECT_EQ(said(),
            "field:1:1 uniform-type: field `size` is `SFVec3f`, but its uniform is `float`\n"
            "field:1:1 field-without-uniform: no part of `e0` declares a uniform `colour`\n");
}

TEST_F(FieldsTest, SuggestsTheFieldThatIsMeant) {
  check("uniform float speeed;", {{"speed", FieldType::SFFloat}});
  EXPECT_EQ(said().substr(0, said().find('\n')),
            "e0.0:1:15 uniform-without-field: no field `speeed` of `e0` feeds this `uniform float`; did you mean `speed`?");
}

TEST_F(FieldsTest, KnowsAnAuthorsNameThatIsAKeywordNow) {
  check("uniform sampler2D sample; vec4 f(vec2 p) { return texture2D(sample, p); }", {{"sample", FieldType::SFNode}});
  EXPECT_EQ(said(), "");
}

TEST_F(FieldsTest, CountsUniformsThatOnlyEsslSees) {
  check("#ifdef GL_ES\nuniform float a;\n#endif\n", {{"a", FieldType::SFFloat}});
  EXPECT_EQ(said(), "");
}

}  // namespace
}  // namespace plugc
