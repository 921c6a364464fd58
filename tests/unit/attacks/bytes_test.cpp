// Bytes that are no text: one message at the first of them, reading goes on, and nothing of them goes on to a shader.

#include "attack.h"
#include "base/clean_text.h"
#include "scene/scene.h"

namespace plugc {
namespace {

/// A scene as a file of its own, as `Inline` reads it: what is said of it, and the title of its WorldInfo.
struct Inlined {
  std::unique_ptr<BuiltGraph> built;
  explicit Inlined(const std::string& text) : built(build(classic_scene("Inline { url \"s\" }"), {{"s", text}})) {}
  std::string title() const {
    const NodeId inlined = built->graph.children(built->root(), "children").empty()
                               ? NodeId()
                               : built->graph.children(built->root(), "children")[0];
    return inlined.valid() ? std::string(built->graph.string(inlined, "title")) : "";
  }
};

const std::string kEncodings[] = {classic_scene("WorldInfo { title \"a*b*c\" }"),
                                  "#VRML V2.0 utf8\nWorldInfo { title \"a*b*c\" }", xml_scene("<WorldInfo title='a*b*c'/>"),
                                  json_scene(R"({"WorldInfo":{"@title":"a*b*c"}})")};

std::string with(std::string text, std::string_view bytes) {
  for (std::size_t at = text.find('*'); at != std::string::npos; at = text.find('*', at + bytes.size()))
    text.replace(at, 1, bytes);
  return text;
}

TEST(Attacks, BytesThatAreNoCharactersAreSaidOnce) {
  const std::pair<std::string_view, std::string_view> damaged[] = {{"\xFF", "?"},
                                                                   {"\xC0\xAF", "??"},            // overlong /
                                                                   {"\xE0\x80\xAF", "???"},       // overlong /
                                                                   {"\xED\xA0\x80", "???"},       // a surrogate
                                                                   {"\xF4\x90\x80\x80", "????"},  // behind U+10FFFF
                                                                   {"\xE2\x82", "??"},            // cut short
                                                                   {"\x80", "?"}};
  for (const std::string& text : kEncodings) {
    for (const auto& [bytes, read] : damaged) {
      const Inlined inlined(with(text, bytes));
      EXPECT_EQ(inlined.built->diagnostics.all().size(), 1U) << inlined.built->said();
      EXPECT_EQ(count_of(inlined.built->diagnostics, DiagnosticId::text_damaged), 1U);
      EXPECT_EQ(inlined.title(), with("a*b*c", read));
    }
  }
}

TEST(Attacks, WholeCharactersPass) {
  for (const std::string& text : kEncodings) {
    for (const std::string_view character :
         {"\xC3\xA9", "\xE2\x82\xAC", "\xED\x9F\xBF", "\xF0\x9F\x98\x80", "\xF4\x8F\xBF\xBF"}) {
      const Inlined inlined(with(text, character));
      EXPECT_EQ(inlined.built->said(), "");
      EXPECT_EQ(inlined.title(), with("a*b*c", character));
    }
  }
}

TEST(Attacks, ANulIsASpaceAndSaidOnce) {
  for (const std::string& text : kEncodings) {
    const Inlined inlined(with(text, std::string_view("\0", 1)));
    EXPECT_NE(inlined.built->said().find("a NUL byte stands in this text; each is read as a space [text-damaged]"),
              std::string::npos);
    EXPECT_EQ(inlined.built->diagnostics.all().size(), 1U) << inlined.built->said();
    EXPECT_EQ(inlined.title(), "a b c");
  }
}

TEST(Attacks, TheFirstBadByteHasItsPlace) {
  const Inlined inlined("#X3D V3.3 utf8\n# caf\xC3\xA9 \xE9\nWorldInfo { title \"\xFF\" }");
  EXPECT_EQ(inlined.built->said(),
            "s:2:8: warning: the byte 0xe9 belongs to no character of UTF-8; each such byte is read as `?` [text-damaged]\n");
}

TEST(Attacks, AByteOrderMarkIsNoText) {
  for (const std::string& text : kEncodings) {
    const Inlined inlined("\xEF\xBB\xBF" + text);
    EXPECT_EQ(inlined.built->said(), "");
    EXPECT_EQ(inlined.title(), "a*b*c");
  }
  for (const std::string_view mark : {"\xFF\xFE", "\xFE\xFF"}) {
    const Inlined inlined(std::string(mark) + std::string("#\0X\0", 4));
    EXPECT_NE(inlined.built->said().find("this text is in UTF-16; save it as UTF-8"), std::string::npos);
    EXPECT_EQ(inlined.built->diagnostics.all().size(), 1U);
  }
}

TEST(Attacks, LinesMayEndWithCrAlone) {
  std::string text = classic_scene("WorldInfo {\n title \"a\nb\"\n unknown 1\n}\n");
  std::replace(text.begin(), text.end(), '\n', '\r');
  const Inlined inlined(text);
  EXPECT_EQ(inlined.title(), "a\nb");
  EXPECT_EQ(inlined.built->said(), "s:5:2: warning: `WorldInfo` has no field `unknown` [field-unknown]\n");
}

TEST(Attacks, ShadersGetCleanText) {
  const auto built =
      build(classic_scene("Shape { appearance Appearance { effects Effect { language \"GLSL\" parts EffectPart { url "
                          "\"code.fs\" } } } geometry Box { } }"),
            {{"code.fs", std::string("// caf\xE9 \0\nvoid PLUG_fragment_modify(inout vec4 c) { }\n", 53)}});
  const Scene scene = build_scene(built->graph, built->sources, built->files, {}, built->diagnostics);
  ASSERT_EQ(scene.effects.size(), 1U);
  ASSERT_EQ(scene.effects[0].parts.size(), 1U);
  EXPECT_TRUE(scene.effects[0].parts[0].text.text().starts_with("// caf?  \nvoid")) << built->said();
  EXPECT_EQ(count_of(built->diagnostics, DiagnosticId::text_damaged), 1U);
}

}  // namespace
}  // namespace plugc
