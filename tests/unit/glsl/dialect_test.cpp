#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "glsl/dialect.h"

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class DialectTest : public testing::Test {
 protected:
  UpgradedText upgrade_text(std::string text, ShaderStage stage = ShaderStage::fragment) {
    const SourceId id = sources_.add("part.glsl", std::move(text));
    part_ = MappedText(sources_, {id, 0, static_cast<std::uint32_t>(sources_.text(id).size())});
    return upgrade(part_, stage, {});
  }
  std::string upgraded(std::string text, ShaderStage stage = ShaderStage::fragment) {
    return std::string(upgrade_text(std::move(text), stage).text.text());
  }
  std::string vertex(std::string text) { return upgraded(std::move(text), ShaderStage::vertex); }
  std::vector<std::string> used(std::string text, ShaderStage stage = ShaderStage::fragment) {
    return upgrade_text(std::move(text), stage).used_names;
  }

  SourceSet sources_;
  MappedText part_;
};

TEST_F(DialectTest, NewTextStaysAsItIs) {
  const std::string text =
      "#version 330\nin vec3 n;\nuniform sampler2D s;\nout vec4 o;\nvoid main() { o = texture(s, n.xy); }\n";
  EXPECT_EQ(upgraded(text), text);
  EXPECT_THAT(used(text), IsEmpty());
}

TEST_F(DialectTest, VaryingAndAttributeBecomeInAndOut) {
  const std::string text = "attribute vec3 a; invariant varying vec3 b;";
  EXPECT_EQ(upgraded(text, ShaderStage::vertex), "in vec3 a; invariant out vec3 b;");
  EXPECT_EQ(upgraded(text, ShaderStage::fragment), "attribute vec3 a; invariant in vec3 b;");
  EXPECT_EQ(upgraded(text, ShaderStage::geometry), text);
  EXPECT_EQ(vertex("#define V varying\nV vec3 a;"), "#define V out\nV vec3 a;");
}

TEST_F(DialectTest, TextureCallsLoseTheirDimension) {
  EXPECT_EQ(upgraded("a = texture1D(s, x) + texture2D (s, x) + texture3D(s, x) + textureCube(s, x) + texture2DRect(s, x);"),
            "a = texture(s, x) + texture (s, x) + texture(s, x) + texture(s, x) + texture(s, x);");
  EXPECT_EQ(upgraded("texture2DProj(s, x); texture2DLod(s, x, 0.0); texture2DProjLod(s, x, 0.0); textureCubeLod(s, x, 0.0);"),
            "textureProj(s, x); textureLod(s, x, 0.0); textureProjLod(s, x, 0.0); textureLod(s, x, 0.0);");
  EXPECT_EQ(upgraded("texture2DGradARB(s, x, y, z); texture2DLodEXT(s, x, 0.0); textureRectProj(s, x); texture2DArray(s, x);"),
            "textureGrad(s, x, y, z); textureLod(s, x, 0.0); textureProj(s, x); texture(s, x);");
  EXPECT_EQ(upgraded("texture(s, x); textureProj(s, x); texture2DSpecial(s); mytexture2D(s);"),
            "texture(s, x); textureProj(s, x); texture2DSpecial(s); mytexture2D(s);");
}

TEST_F(DialectTest, ShadowCallsStayVectors) {
  EXPECT_EQ(upgraded("float f = shadow2DProj(map, g(c)).r * shadow2D(map, (c)).x;"),
            "float f = vec4(textureProj(map, g(c))).r * vec4(texture(map, (c))).x;");
  EXPECT_EQ(upgraded("vec4 f = shadow2D(map, vec3(shadow1D(other, c).xyz));"),
            "vec4 f = vec4(texture(map, vec3(vec4(texture(other, c)).xyz)));");
  EXPECT_EQ(upgraded("#define S(c) shadow2D(map, c)\n"), "#define S(c) vec4(texture(map, c))\n");
  EXPECT_EQ(upgraded("float f = shadow2DEXT(map, c);"), "float f = texture(map, c);");
}

TEST_F(DialectTest, OutputsBecomeOneName) {
  EXPECT_EQ(upgraded("gl_FragColor = a; gl_FragData[0] = b; gl_FragData[ 0 ].r = c; gl_FragData[1] = d;"),
            "castle_FragColor = a; castle_FragColor = b; castle_FragColor.r = c; gl_FragData[1] = d;");
  EXPECT_THAT(used("gl_FragColor = a; gl_FragData[0] = b;"), ElementsAre("castle_FragColor"));
}

TEST_F(DialectTest, FixedFunctionNamesBecomeCastleNames) {
  EXPECT_EQ(vertex("gl_FrontColor = gl_Color; p = gl_NormalMatrix * gl_Normal; q = gl_ModelViewMatrix * gl_Vertex;"),
            "castle_Color = castle_ColorPerVertex; p = castle_NormalMatrix * castle_Normal; q = castle_ModelViewMatrix * "
            "castle_Vertex;");
  EXPECT_EQ(vertex("gl_TexCoord[1] = gl_TextureMatrix[1] * gl_MultiTexCoord1;"),
            "castle_TexCoord1 = castle_TextureMatrix1 * castle_MultiTexCoord1;");
  EXPECT_EQ(upgraded("a = gl_Color * gl_TexCoord[0].s * gl_TexCoord[i] + gl_FragCoord.x;"),
            "a = castle_Color * castle_TexCoord0.s * gl_TexCoord[i] + gl_FragCoord.x;");
}

TEST_F(DialectTest, ProductsOfMatricesAreWrittenOut) {
  const UpgradedText product = upgrade_text("gl_Position = gl_ModelViewProjectionMatrix * v;", ShaderStage::vertex);
  EXPECT_EQ(product.text.text(), "gl_Position = (castle_ProjectionMatrix * castle_ModelViewMatrix) * v;");
  EXPECT_THAT(product.used_names, ElementsAre("castle_ProjectionMatrix", "castle_ModelViewMatrix"));
  const UpgradedText transform = upgrade_text("gl_Position = ftransform ( );", ShaderStage::vertex);
  EXPECT_EQ(transform.text.text(), "gl_Position = (castle_ProjectionMatrix * (castle_ModelViewMatrix * castle_Vertex));");
  EXPECT_THAT(transform.used_names, ElementsAre("castle_ProjectionMatrix", "castle_ModelViewMatrix", "castle_Vertex"));
}

TEST_F(DialectTest, SizesOfBuiltInArraysGo) {
  EXPECT_EQ(vertex("varying vec4 gl_TexCoord[2];\nvoid main() { gl_TexCoord[0] = a; }"),
            "\nvoid main() { castle_TexCoord0 = a; }");
}

TEST_F(DialectTest, NamesTheAuthorsCastleNamesOnce) {
  EXPECT_THAT(used("uniform mat4 castle_ModelViewMatrix;\n#define N castle_NormalMatrix\n"
                   "void main() { a = castle_ModelViewMatrix * gl_Vertex + b.castle_x; /* PLUG: p (castle_vertex_eye) */ }"),
              ElementsAre("castle_ModelViewMatrix", "castle_Vertex", "castle_NormalMatrix", "castle_vertex_eye"));
}

TEST_F(DialectTest, MembersCommentsAndDeadBranchesStay) {
  const std::string text =
      "a.gl_Color = b.varying; // gl_Color texture2D(s)\n/* gl_Vertex */\n#if 0\ngl_FragColor = a;\n#endif\n";
  EXPECT_EQ(upgraded(text), text);
}

TEST_F(DialectTest, MacrosAndMarkersAreUpgraded) {
  EXPECT_EQ(upgraded("#define LOOK texture2D\n#define C(x) (gl_Color * texture2D(s, x)) // gl_Color\n"),
            "#define LOOK texture\n#define C(x) (castle_Color * texture(s, x)) // gl_Color\n");
  EXPECT_EQ(upgraded("void main() { /* PLUG: gl_Color (gl_FragColor, texture2D(s, x)) */ }"),
            "void main() { /* PLUG: gl_Color (castle_FragColor, texture(s, x)) */ }");
}

TEST_F(DialectTest, FunctionsOfTheAuthorsStay) {
  const std::string text =
      "vec4 texture2D(vec2 c) { return vec4(c, c); }\n#define textureCube(s, c) f(s, c)\n"
      "void main() { a = texture2D(b) + textureCube(s, c); }";
  EXPECT_EQ(upgraded(text), text);
}

TEST_F(DialectTest, VariableNamedTextureMakesRoomForTheCall) {
  const UpgradedText result = upgrade_text(
      "void PLUG_texture_color(inout vec4 color, const in sampler2D texture, const in vec4 at)\n"
      "{ color = texture2D(texture, at.st); /* PLUG: again (texture) */ }");
  EXPECT_EQ(result.text.text(),
            "void PLUG_texture_color(inout vec4 color, const in sampler2D texture_, const in vec4 at)\n"
            "{ color = texture(texture_, at.st); /* PLUG: again (texture_) */ }");
  ASSERT_EQ(result.renamed_names.size(), 1U);
  EXPECT_EQ(result.renamed_names[0].written, "texture");
  EXPECT_EQ(result.renamed_names[0].renamed, "texture_");
}

TEST_F(DialectTest, VariableNamedTextureStaysWithoutAnOldCall) {
  const std::string text = "void f(sampler2D texture, vec2 c) { g(texture); }";
  EXPECT_EQ(upgraded(text), text);
}

TEST_F(DialectTest, GlobalNamedTextureIsAlwaysRenamed) {
  EXPECT_EQ(upgraded("uniform sampler2D texture;\nvoid f() { g(texture); }"),
            "uniform sampler2D texture_;\nvoid f() { g(texture_); }");
}

TEST_F(DialectTest, RenamingAvoidsNamesThatAreTaken) {
  EXPECT_EQ(upgraded("void f(sampler2D texture, vec2 texture_) { a = texture2D(texture, texture_); }"),
            "void f(sampler2D texture_2, vec2 texture_) { a = texture(texture_2, texture_); }");
}

TEST_F(DialectTest, MembersNamedTextureStay) {
  EXPECT_EQ(upgraded("struct S { vec4 texture; };\nvoid f(S s, sampler2D texture) { a = texture2D(texture, s.texture.xy); }"),
            "struct S { vec4 texture; };\nvoid f(S s, sampler2D texture_) { a = texture(texture_, s.texture.xy); }");
}

TEST_F(DialectTest, ParametersOfMacrosAreRenamedWithTheirBody) {
  EXPECT_EQ(upgraded("#define LOOK(texture, c) texture2D(texture, c)\n"), "#define LOOK(texture_, c) texture(texture_, c)\n");
}

TEST_F(DialectTest, NamesThatBecameKeywordsAreRenamed) {
  EXPECT_EQ(upgraded("float flat = 1.0; vec3 a, sample; vec4 filter(float smooth) { return flat * sample.x * smooth; }"),
            "float flat_ = 1.0; vec3 a, sample_; vec4 filter_(float smooth_) { return flat_ * sample_.x * smooth_; }");
  EXPECT_EQ(upgraded("struct S { float sample; }; f(s.sample);"), "struct S { float sample_; }; f(s.sample_);");
  EXPECT_EQ(upgraded("float uint = 1.0; uint += 1.0;"), "float uint_ = 1.0; uint_ += 1.0;");
}

TEST_F(DialectTest, KeywordsInTheirOwnPlaceStay) {
  const std::string text =
      "layout(location = 0) in vec3 a; flat in int b; smooth in vec3 c; precision mediump float; highp vec2 d;\n"
      "uint f(uint x) { switch (x) { case 1U: return uint(2); default: return 0U; } }";
  EXPECT_EQ(upgraded(text), text);
  EXPECT_EQ(upgraded("#define FLAT flat\nFLAT varying vec3 a;"), "#define FLAT flat\nFLAT in vec3 a;");
}

TEST_F(DialectTest, NewVersionMeansItsKeywords) {
  const std::string text = "#version 400\nfloat sample = 1.0; float inverse(float x) { return x; }";
  EXPECT_EQ(upgraded(text), text);
}

TEST_F(DialectTest, VersionTellsWhichWordsAreNames) {
  EXPECT_EQ(upgraded("#version 330\nfloat sample = 1.0; float inverse(float x) { return x; }"),
            "#version 330\nfloat sample_ = 1.0; float inverse(float x) { return x; }");
  EXPECT_EQ(upgraded("#version 300 es\nfloat shared = 1.0;"), "#version 300 es\nfloat shared_ = 1.0;");
  EXPECT_EQ(upgraded("#version 330\nlayout(shared) uniform Block { float level; };"),
            "#version 330\nlayout(shared) uniform Block { float level; };");
}

TEST_F(DialectTest, FunctionsThatBecameBuiltInAreRenamed) {
  EXPECT_EQ(upgraded("mat4 inverse(mat4 m);\nmat4 inverse(mat4 m) { return m; }\nvoid f() { a = inverse(b) * c.inverse; }"),
            "mat4 inverse_(mat4 m);\nmat4 inverse_(mat4 m) { return m; }\nvoid f() { a = inverse_(b) * c.inverse; }");
  const std::string local = "void f() { float round = 1.0; g(round); }";
  EXPECT_EQ(upgraded(local), local);
  EXPECT_EQ(upgraded("uniform float trunc; void f() { g(trunc, trunc(1.5)); }"),
            "uniform float trunc_; void f() { g(trunc_, trunc(1.5)); }");
}

TEST_F(DialectTest, ContinuedLinesAreJoined) {
  EXPECT_EQ(upgraded("#define A(x) \\\n  (x + \\\r\n 1)\nvec3 a;"), "#define A(x)    (x +   1)\nvec3 a;");
}

TEST_F(DialectTest, KeepsTheMap) {
  const std::string text = "varying vec3 n;\nvoid main() { gl_FragColor = texture2D(s, n.xy) * shadow2D(m, n).r + last; }";
  const UpgradedText result = upgrade_text(text);
  const auto check = [&](std::string_view now, std::string_view written) {
    const auto begin = static_cast<std::uint32_t>(result.text.text().find(now));
    const Span place = result.text.locate(begin, begin + static_cast<std::uint32_t>(now.size()));
    EXPECT_EQ(sources_.text(place), written);
    EXPECT_EQ(place.begin, text.find(written));
  };
  check("in", "varying");
  check("castle_FragColor", "gl_FragColor");
  check("texture", "texture2D");
  check("vec4(texture", "shadow2D");
  check("last", "last");
}

TEST_F(DialectTest, BrokenTextComesThrough) {
  EXPECT_EQ(upgraded("gl_TexCoord[ shadow2D( texture2D( gl_FragData[0 ftransform("),
            "gl_TexCoord[ vec4(texture( texture( gl_FragData[0 ftransform(");
  EXPECT_EQ(upgraded(""), "");
  EXPECT_EQ(upgraded("gl_TexCoord[123] gl_TexCoord[0x] gl_TexCoord"), "gl_TexCoord[123] gl_TexCoord[0x] gl_TexCoord");
}

}  // namespace
}  // namespace plugc
