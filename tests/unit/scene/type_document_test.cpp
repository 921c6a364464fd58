// What type_document makes of values, fields and names, shown by the classic text of the result.

#include "scene/type_document.h"

#include <gmock/gmock.h>

#include "document/read_document.h"
#include "document/write_document.h"

namespace plugc {
namespace {

/// The typed document in the classic encoding, without its first line and the empty line behind it.
std::string typed(std::string text, Encoding as = Encoding::classic) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const SourceId source = sources.add("s", std::move(text));
  const std::string written = write_document(type_document(read_document(source, sources, diagnostics)), as);
  return as == Encoding::classic ? written.substr(written.find("\n\n") + 2) : written;
}

std::string typed_xml(const std::string& body) {
  return typed("<X3D version='3.3'><Scene>" + body + "</Scene></X3D>");
}

TEST(TypeDocument, ReadsAttributesByTheFieldsType) {
  EXPECT_EQ(typed_xml("<Text string='\"a\" \"b\"' length='1 2' solid='true'/>"),
            "Text { string [ \"a\" \"b\" ] length [ 1 2 ] solid TRUE }\n");
  EXPECT_EQ(typed_xml("<Box size='1,2,3'/>"), "Box { size 1 2 3 }\n");
}

TEST(TypeDocument, KeepsAsTextWhatDoesNotFit) {
  EXPECT_EQ(typed_xml("<Box size='1 two 3' solid='2'/>"), "Box { size \"1 two 3\" solid \"2\" }\n");
}

TEST(TypeDocument, FindsTheFieldsOfChildElements) {
  EXPECT_EQ(typed_xml("<Shape><Appearance/><Sphere/></Shape>"),
            "Shape {\n  appearance Appearance { }\n  geometry Sphere { }\n}\n");
  EXPECT_EQ(typed_xml("<Group><Shape DEF='S'/><MetadataSet containerField='metadata'/><Shape USE='S'/></Group>"),
            "Group {\n  children [\n    DEF S Shape { }\n    USE S\n  ]\n  metadata MetadataSet { }\n}\n");
}

TEST(TypeDocument, NamesTheContainerFieldOnlyWhereItIsNotTheUsualOne) {
  const std::string scene =
      "#X3D V4.0 utf8\nShape { appearance Appearance { material DEF M Material { } backMaterial USE M } }";
  EXPECT_THAT(typed(scene, Encoding::xml),
              testing::HasSubstr("<Material DEF=\"M\"/>\n        <Material USE=\"M\" containerField=\"backMaterial\"/>"));
}

TEST(TypeDocument, AnInstanceStandsWhereItsFirstNodeWould) {
  const std::string prototype =
      "#X3D V4.0 utf8\nPROTO Look [ inputOutput SFColor c 1 0 0 ] { Appearance { } }\nShape { appearance Look { c 0 1 0 } }";
  EXPECT_THAT(
      typed(prototype, Encoding::xml),
      testing::HasSubstr("<Shape>\n      <ProtoInstance name=\"Look\">\n        <fieldValue name=\"c\" value=\"0 1 0\"/>"));
}

TEST(TypeDocument, TypesTheFieldsOfAnInstanceByItsPrototype) {
  EXPECT_THAT(typed_xml("<ProtoDeclare name='P'><ProtoInterface><field accessType='inputOutput' type='MFString' name='a'/>"
                        "</ProtoInterface><ProtoBody><Group/></ProtoBody></ProtoDeclare>"
                        "<ProtoInstance name='P'><fieldValue name='a' value='\"1\"'/></ProtoInstance>"),
              testing::HasSubstr("\nP { a [ \"1\" ] }\n"));
}

TEST(TypeDocument, TakesTheValuesOfUnknownFieldsForWhatTheyLookLike) {
  EXPECT_EQ(typed_xml("<New a='1 2' b='true' c='1 x' d='\"x\"'/>"), "New { a 1 2 b TRUE c \"1 x\" d [ \"x\" ] }\n");
}

TEST(TypeDocument, KeepsCodeBehindTheUrls) {
  const std::string scene =
      "#X3D V4.0 utf8\nScript { url [ \"a.js\" \"ecmascript:b < c\" ] }\nInline { url \"data:text/plain,x\" }";
  const std::string written = typed(scene, Encoding::xml);
  EXPECT_THAT(written, testing::HasSubstr("<Script url='\"a.js\"'><![CDATA[ecmascript:b < c]]></Script>"));
  EXPECT_THAT(written, testing::HasSubstr("<Inline url='\"data:text/plain,x\"'/>"));  // code of no shader
}

TEST(TypeDocument, GivesAFieldItsNameOfX3d) {
  EXPECT_EQ(typed("#X3D V4.0 utf8\nSwitch { choice [ ] }"), "Switch { children [ ] }\n");
  EXPECT_EQ(typed_xml("<Switch><Box containerField='choice'/></Switch>"), "Switch {\n  children [\n    Box { }\n  ]\n}\n");
}

TEST(TypeDocument, KnowsWhatAUseStandsFor) {
  EXPECT_THAT(
      typed("#X3D V4.0 utf8\nPROTO P [ ] { Group { } }\nGroup { children [ DEF A P { } USE A USE Nobody ] }", Encoding::xml),
      testing::HasSubstr("<ProtoInstance name=\"P\" DEF=\"A\"/>\n      <ProtoInstance name=\"P\" USE=\"A\"/>\n"
                         "      <Group USE=\"Nobody\"/>"));
}

}  // namespace
}  // namespace plugc
