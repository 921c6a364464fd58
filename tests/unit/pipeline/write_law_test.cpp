// What is written reads as what was read: every document in every encoding, again and again, and the programs that it
// composes to.

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "base/file_access.h"
#include "document/read_document.h"
#include "document/write_document.h"
#include "scene/type_document.h"
#include "support/compile_text.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::array<Encoding, 3> kEncodings = {Encoding::classic, Encoding::xml, Encoding::json};

std::string_view name_of(Encoding encoding) {
  return encoding == Encoding::xml ? "xml" : encoding == Encoding::json ? "json" : "classic";
}

std::string read_file(const fs::path& path) {
  FileContent content = DiskFiles({}).read(path);
  return std::move(content.bytes);
}

/// A text as a typed document.
struct Typed {
  SourceSet sources;
  Diagnostics diagnostics{sources};
  Document document;

  explicit Typed(std::string text) {
    const SourceId source = sources.add("s", std::move(text));
    document = type_document(read_document(source, sources, diagnostics));
  }
  Typed(const Typed&) = delete;

  std::string messages() const {
    std::string all;
    for (const Diagnostic& one : diagnostics.all()) all += to_text(one, sources);
    return all;
  }
};

/// The document without places and the name of its encoding. XML has no words for an empty field of a node.
std::string content(const Typed& typed, bool without_empty_fields) {
  std::string all;
  static const std::regex place(R"(^( *)\d+:\d+ )"), header(R"(^document \w+)"), empty_field(R"(^ *field \S+ NULL$)");
  std::istringstream dump(dump_document(typed.document, typed.sources));
  for (std::string line; std::getline(dump, line);) {
    line = std::regex_replace(line, place, "$1");
    if (without_empty_fields && std::regex_match(line, empty_field)) continue;
    all += std::regex_replace(line, header, "document") + "\n";
  }
  return all;
}

void expect_laws(const Typed& read, Encoding as) {
  SCOPED_TRACE(name_of(as));
  const bool xml = as == Encoding::xml;
  const std::string written = write_document(read.document, as);
  const Typed again(written);
  EXPECT_EQ(again.messages(), "") << written.substr(0, 5000);
  ASSERT_EQ(content(again, xml), content(read, xml)) << written.substr(0, 5000);
  const std::string classic = write_classic(read.document);  // unlike the dump it shows every number
  const bool has_empty_fields = classic.find(" NULL") != std::string::npos || classic.find(" [ ]") != std::string::npos;
  if (!xml || !has_empty_fields) {
    EXPECT_TRUE(write_classic(again.document) == classic) << classic.substr(0, 5000);
  }
  EXPECT_TRUE(write_document(again.document, as) == written) << written.substr(0, 5000);
}

/// Writes a text in each encoding, and what that reads as in each again.
void expect_laws(const std::string& text) {
  const Typed read(text);
  for (const Encoding first : kEncodings) {
    expect_laws(read, first);
    SCOPED_TRACE(name_of(first));
    const Typed between(write_document(read.document, first));
    for (const Encoding second : kEncodings) expect_laws(between, second);
  }
}

/// The scenes below a folder: classic, XML and JSON.
std::vector<fs::path> scenes_below(const fs::path& folder) {
  std::vector<fs::path> scenes;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".x3dv" || extension == ".x3d" || extension == ".wrl" || extension == ".x3dj")
      scenes.push_back(entry.path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

const fs::path kCorpus = fs::path(PLUGC_SOURCE_DIR) / "../shared/corpus/scenes";

constexpr std::string_view kEverything = R"#(#X3D V3.2 utf8
PROFILE Immersive
COMPONENT Shaders:1
COMPONENT Text:2
UNIT length inch 0.0254
META "ti\"tle" "a <b> & 'c' \\ é
second line"
EXTERNPROTO Ext [ inputOutput SFFloat a  initializeOnly MFNode kids ] [ "ext.x3dv#Ext" "b \"q\".x3dv" ]
PROTO Lamp [
  inputOutput SFFloat strength 0.25
  initializeOnly SFNode shape Box { size 1 2 3 }
  initializeOnly MFString words [ "a" "b c" ]
  initializeOnly SFRotation turn 0 1 0 1.5707963267948966
  inputOnly SFBool go
  outputOnly SFTime went
] {
  PROTO Inner [ inputOutput SFColor c 1 0 0 ] { PointLight { color IS c } }
  Group { children [
    PointLight { location 1 2 5 intensity IS strength set_on IS go }
    Shape { geometry IS shape }
    Inner { c 0 1 0 }
  ] }
  DEF S Script {
    inputOnly SFBool go IS go
    outputOnly SFTime went IS went
    initializeOnly SFNode self USE S
    initializeOnly MFInt32 numbers [ 1 ]
    inputOutput SFString text "a \"quoted\" \\ text"
    url [ "javascript:function go(value, time) { if (a[b[c]]>0 && c < 1) went = time; }" ]
    directOutput TRUE
    mustEvaluate FALSE
  }
  ROUTE S.went TO S.set_text
}
DEF L Lamp { strength 0.75 words "d" shape Cone { } }
Ext { a 1 kids [ Box { } ] }
Transform { translation -1e-7 1e30 0.1 children USE L }
DEF G Group {
  PROTO InNode [ ] { Group { } }
  metadata MetadataFloat { name "n" value 0.3333333333333333 }
  children [ InNode { } Ext { } USE G2 Foo { bar 1 baz "x" w Box { } ww [ Box { } USE L ] yes TRUE } ]
  ROUTE L.went TO G.set_bboxSize
}
Group { ROUTE L.went TO G.set_bboxSize }
DEF Clock TimeSensor { cycleInterval 4.000000000000001 loop TRUE }
Shape {
  appearance Appearance {
    effects [ Effect {
      language "GLSL"
      inputOutput SFColor tint 1 0.5 0
      inputOutput MFBool flags [ TRUE FALSE ]
      initializeOnly SFMatrix3f m 1 0 0 0 1 0 0 0 1
      parts [
        EffectPart { type "FRAGMENT" url [ "a.glsl" "data:text/plain,
// é \"quoted\" \\ and ]]> and <tag> &amp; 'single'
  if (a[b[c]]>0 && 1 < 2)\tx();

" ] }
        EffectPart { type "VERTEX" url "data:text/plain,x" }
        EffectPart { type "VERTEX" url "vertex.glsl" }
      ] }
      USE Ext ]
  }
  geometry DEF IFS IndexedFaceSet {
    coordIndex [ 0 1 2 -1 2 3 0 -1 4 5 6 -1 7 8 9 -1 10 11 12 -1 13 14 15 -1 0 1 2 -1 2 3 0 -1 4 5 6 -1 7 8 9 -1 ]
    coord Coordinate { point [ 0 0 0, 1 0 0, 0.1 0.2 0.3, 1e-45 1.7976931348623157e308 -0, 4.9e-324 1 2, 1 1 1, 2 2 2, 3 3 3 ] }
    color DEF C Color { color 1 0 0 }
    texCoord MultiTextureCoordinate { texCoord [ TextureCoordinate { point [ 0 0 1 1 ] } TextureCoordinateGenerator { } ] }
  }
}
Shape { appearance Appearance { shaders ComposedShader {
  inputOutput SFNode map PixelTexture { image 2 1 3 0xFF0000 255 }
  parts ShaderPart { url "data:text/plain,void main() { }" } } } geometry Text { string [ "a" "b \" \\ c" "" ] } }
Text { string [ "a string that is long enough" "for lines to be broken between" "the strings of a list" ] solid FALSE }
Text { string "one" }
Viewpoint { description "" }
WorldInfo { title "tab	and é 日本" info [ "'" "&quot;" "
" ] }
DEF I Inline { url [ "other.x3dv" ] }
IMPORT I.a AS b
IMPORT I.c
EXPORT G AS H
EXPORT L
ROUTE Clock.fraction_changed TO G.set_bboxSize
)#";

TEST(WriteLaw, EveryFeatureReadsAgain) {
  expect_laws(std::string(kEverything));
}

TEST(WriteLaw, WhatIsEmptyStaysEmpty) {
  expect_laws(R"(#X3D V3.3 utf8
PROTO P [ initializeOnly SFNode shape Box { } initializeOnly MFNode list [ Box { } ] inputOutput MFFloat numbers [ ] ] {
  Group { children IS list metadata NULL }
}
P { shape NULL list [ ] numbers [ ] }
P { shape NULL list [ Sphere { } DEF Ball Sphere { } ] }
Group { children [ ] }
Shape { appearance NULL geometry Text { string [ ] } }
Script { initializeOnly SFNode a NULL initializeOnly MFNode b [ ] initializeOnly MFVec3f c [ ] url [ ] }
)");
}

constexpr std::string_view kVrml = R"(#VRML V2.0 utf8
PROTO P [ field SFFloat a 1 exposedField SFColor b 1 0 0 eventIn SFBool c eventOut SFTime d ] {
  Switch { whichChoice 0 choice [ LOD { range [ 1 ] level [ Group { } ] } ] }
  Script { eventIn SFBool c IS c eventOut SFTime d IS d field SFFloat a IS a url "vrmlscript:function c() { }" }
}
P { a 2 }
Collision { collide FALSE }
)";

TEST(WriteLaw, Vrml2BecomesX3d) {
  expect_laws(std::string(kVrml));
  const Typed read{std::string(kVrml)};
  EXPECT_THAT(write_classic(read.document), testing::StartsWith(R"(#X3D V3.0 utf8

PROTO P [
  initializeOnly SFFloat a 1
  inputOutput SFColor b 1 0 0
  inputOnly SFBool c
  outputOnly SFTime d
] {
  Switch {
    whichChoice 0
    children [
      LOD {
        range [ 1 ]
        children [
          Group { }
        ]
      }
    ]
  }
)"));
}

constexpr std::string_view kXml = R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D profile="Full" version="4.0"><head><meta name="a" content="&quot;&#10;b&quot;"/></head><Scene>
<ProtoDeclare name="P"><ProtoInterface>
  <field accessType="initializeOnly" type="SFNode" name="geometry"/>
  <field accessType="initializeOnly" type="MFNode" name="kids"><Box/><Sphere/></field>
  </ProtoInterface><ProtoBody><Shape><IS><connect nodeField="geometry" protoField="geometry"/></IS></Shape></ProtoBody></ProtoDeclare>
<ProtoInstance name="P" DEF="One"><Cone containerField="kids"/><fieldValue name="geometry" value="NULL"/></ProtoInstance>
<Group bboxSize="1,1 1"><ProtoInstance USE="One"/><Shape><Appearance><Material diffuseColor="1 0 0"/>
  <Effect containerField="effects"><EffectPart containerField="parts">some<![CDATA[ <code> ]]]]><![CDATA[> split]]></EffectPart></Effect>
  </Appearance><Text string='"a" "b \"c\\"' solid="true"/></Shape><Text string="one word"/>
  <EXPORT localDEF="One"/><ROUTE fromNode="One" fromField="a" toNode="One" toField="b"/></Group>
<Shape><Box size="1 two 3"/><Unknown a="1" b="true" c="words" d='"x" "y"' DEF="my name" e=""><Box/></Unknown></Shape>
<Transform DEF="2 odd.names" scale="0x10 1 1"/><Anchor url=""><Transform USE="2 odd.names"/></Anchor>
<Inline DEF="I"/><IMPORT inlineDEF="I" importedDEF="M"/><Shape><Appearance><Material USE="M"/></Appearance></Shape>
</Scene></X3D>
)";

TEST(WriteLaw, WhatXmlWritesOtherwiseIsTheSame) {
  const Typed read{std::string(kXml)};
  for (const Encoding as : {Encoding::xml, Encoding::json}) expect_laws(read, as);
  // a name that the classic encoding cannot hold is another one there, but keeps its meaning
  const std::string classic = write_classic(read.document);
  EXPECT_THAT(classic, testing::HasSubstr("DEF _x32__x20_odd_x2e_names Transform { scale 16 1 1 }"));
  EXPECT_THAT(classic, testing::HasSubstr("USE _x32__x20_odd_x2e_names"));
  EXPECT_EQ(Typed(classic).messages(), "");
  EXPECT_EQ(write_classic(Typed(classic).document), classic);
}

TEST(WriteLaw, EverySceneOfTheProjectReadsAgain) {
  for (const char* folder : {"examples", "docs/samples", "tests/bench/scenes"}) {
    const auto scenes = scenes_below(fs::path(PLUGC_SOURCE_DIR) / folder);
    EXPECT_FALSE(scenes.empty()) << folder;
    for (const fs::path& scene : scenes) {
      SCOPED_TRACE(scene.string());
      expect_laws(read_file(scene));
    }
  }
}

TEST(WriteLaw, EverySceneOfTheCorpusReadsAgain) {
  const auto scenes = scenes_below(kCorpus);
  if (scenes.empty()) GTEST_SKIP() << "no scenes below " << kCorpus;
  for (const fs::path& scene : scenes) {
    SCOPED_TRACE(scene.string());
    const Typed read(read_file(scene));
    for (const Encoding as : kEncodings) expect_laws(read, as);
  }
}

/// A folder in which every folder from `root` down to the scene's is there again, with links to all that lies in them, so that
/// another file in the scene's place finds what the scene finds.
fs::path mirror(const SceneFolder& folder, const fs::path& root, const fs::path& scene) {
  fs::path here = folder.path(), there = root;
  const fs::path inside = fs::relative(scene, root);
  for (auto part = inside.begin(); part != inside.end(); ++part) {
    for (const auto& entry : fs::directory_iterator(there)) {
      const fs::path name = entry.path().filename();
      if (name != *part) fs::create_symlink(fs::canonical(entry.path()), here / name);
    }
    if (std::next(part) == inside.end()) return here / *part;
    here /= *part;
    there /= *part;
    fs::create_directory(here);
  }
  return here;
}

/// All that a package holds, as text, but where its lines came from; effects without a name are called by their line.
std::string compiled_text(const fs::path& scene, Validator& validator) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions options;
  options.root = "/";
  const auto bytes = write_package(compile({scene}, options, validator, sources, diagnostics).package);
  const PackageView view = open_package(bytes);
  static const std::regex line("at line [0-9]+");
  return view.package == nullptr ? view.error : std::regex_replace(dump_package(*view.package), line, "at a line");
}

void expect_one_package(const std::vector<fs::path>& scenes, const fs::path& root) {
  const SceneFolder cache;
  ValidatorOptions with_cache;
  with_cache.cache_folder = cache.path();
  with_cache.timeout = std::chrono::milliseconds(60'000);
  Validator validator(with_cache);
  std::size_t with_programs = 0;
  for (const fs::path& scene : scenes) {
    SCOPED_TRACE(scene.string());
    const SceneFolder folder;
    const fs::path copy = mirror(folder, root, scene);
    const Typed read(read_file(scene));
    std::ofstream(copy, std::ios::binary) << read_file(scene);
    std::vector<std::string> compiled;
    const std::string original = compiled_text(copy, validator);
    for (const Encoding as : kEncodings) {
      std::ofstream(copy, std::ios::binary) << write_document(read.document, as);
      compiled.push_back(compiled_text(copy, validator));
    }
    with_programs += original.find("\nprogram 0 ") != std::string::npos ? 1 : 0;
    EXPECT_EQ(original, compiled[0]);
    EXPECT_EQ(compiled[0], compiled[1]);
    EXPECT_EQ(compiled[0], compiled[2]);
  }
  EXPECT_GT(2 * with_programs, scenes.size());
}

TEST(WriteLaw, EveryExampleComposesToTheSameInEveryEncoding) {
  for (const char* folder : {"examples", "tests/bench/scenes"}) {
    expect_one_package(scenes_below(fs::path(PLUGC_SOURCE_DIR) / folder), PLUGC_SOURCE_DIR);
  }
}

TEST(WriteLaw, EverySceneOfTheCorpusComposesToTheSameInEveryEncoding) {
  const auto scenes = scenes_below(kCorpus);
  if (scenes.empty()) GTEST_SKIP() << "no scenes below " << kCorpus;
  expect_one_package(scenes, kCorpus);
}

}  // namespace
}  // namespace plugc
