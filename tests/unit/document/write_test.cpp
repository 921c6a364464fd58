// How written documents look; that they read as the same is a law of the pipeline's tests.

#include "document/write_document.h"

#include <gtest/gtest.h>

#include "unit/document/reading.h"

namespace plugc {
namespace {

TEST(WriteDocument, PutsSmallNodesIntoOneLine) {
  const Reading reading(
      classic("PROFILE Full\nShape { appearance Appearance { material Material { diffuseColor 1 0 0 } } geometry Box { } }"));
  EXPECT_EQ(write_classic(reading.document), R"(#X3D V3.3 utf8
PROFILE Full

Shape {
  appearance Appearance {
    material Material { diffuseColor 1 0 0 }
  }
  geometry Box { }
}
)");
}

TEST(WriteDocument, WritesAJsonObjectANode) {
  const Reading reading(classic("Transform { translation 1 2 3 children [ DEF B Box { solid FALSE } ] } ROUTE B.a TO B.b"));
  EXPECT_EQ(write_json(reading.document), R"({
  "X3D": {
    "encoding": "UTF-8",
    "@version": "3.3",
    "Scene": {
      "-children": [
        { "Transform": {
          "@translation": [ 1, 2, 3 ],
          "-children": [
            { "Box": { "@DEF": "B", "@solid": false } }
          ]
        } },
        { "ROUTE": { "@fromNode": "B", "@fromField": "a", "@toNode": "B", "@toField": "b" } }
      ]
    }
  }
}
)");
}

TEST(WriteDocument, WritesXmlElementsWithTheirCode) {
  const Reading reading(
      xml("<Effect language='GLSL'><EffectPart containerField='parts' type='VERTEX'><![CDATA[\nvoid x() { a < b; }\n]]>"
          "</EffectPart></Effect>"));
  EXPECT_EQ(write_xml(reading.document), R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version="3.3">
  <Scene>
    <Effect language="GLSL">
      <EffectPart containerField="parts" type="VERTEX"><![CDATA[
void x() { a < b; }
]]></EffectPart>
    </Effect>
  </Scene>
</X3D>
)");
}

TEST(WriteDocument, BreaksLongListsBetweenElements) {
  Reading reading(
      classic("Coordinate { point [ 0.125 0.25 0.5 1.125 1.25 1.5 2.125 2.25 2.5 3.125 3.25 3.5 4.125 4.25 4.5 "
              "5.125 5.25 5.5 6.125 6.25 6.5 ] }"));
  reading.document.fields.front().value.components = 3;
  EXPECT_EQ(write_classic(reading.document), R"(#X3D V3.3 utf8

Coordinate {
  point [
    0.125 0.25 0.5, 1.125 1.25 1.5, 2.125 2.25 2.5, 3.125 3.25 3.5, 4.125 4.25 4.5, 5.125 5.25 5.5,
    6.125 6.25 6.5
  ]
}
)");
}

TEST(WriteDocument, WritesTheNearestWhereAnEncodingHasNoWords) {
  const std::string body = "{\"A\":{\"@b\":\"\\u0001\\r\\n\\t'\\\"&\",\"@DEF\":\"1 x\"}}";
  const Reading reading("{\"X3D\":{\"@version\":\"4.0\",\"Scene\":{\"-children\":[" + body + "]}}}");
  EXPECT_EQ(write_xml(reading.document), R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version="4.0">
  <Scene>
    <A DEF="1 x" b=')"
                                         "\xEF\xBF\xBD&#13;&#10;&#9;&apos;\"&amp;'/>\n  </Scene>\n</X3D>\n");
  EXPECT_EQ(write_classic(reading.document), "#X3D V4.0 utf8\n\nDEF _x31__x20_x A {\n  b \"\x01\n\t'\\\"&\"\n}\n");
  EXPECT_EQ(dump_of(write_json(reading.document)),
            "document json 4.0\n7:11 DEF 1 x A\n  7:35 field b = \"\x01\r\\n\t'\\\"&\"\n");
}

TEST(WriteDocument, GivesAnInterfaceFieldWithoutAValueItsUsualOne) {
  const Reading reading(
      xml("<Script><field accessType='inputOutput' type='SFString' name='a'/>"
          "<field accessType='inputOutput' type='MFFloat' name='b'/>"
          "<field accessType='inputOutput' type='SFBool' name='c'/>"
          "<field accessType='inputOnly' type='SFBool' name='d'/></Script>"));
  EXPECT_EQ(write_classic(reading.document), R"(#X3D V3.3 utf8

Script {
  inputOutput SFString a ""
  inputOutput MFFloat b [ ]
  inputOutput SFBool c FALSE
  inputOnly SFBool d
}
)");
}

TEST(WriteDocument, CallsWhatNoElementMayBeCalledAnInstance) {
  const Reading reading(classic("field { a$ 1 USE 2 } ROUTE$ { }"));
  EXPECT_EQ(write_xml(reading.document), R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version="3.3">
  <Scene>
    <ProtoInstance name="field">
      <fieldValue name="a$" value="1"/>
      <fieldValue name="USE" value="2"/>
    </ProtoInstance>
    <ProtoInstance name="ROUTE$"/>
  </Scene>
</X3D>
)");
}

TEST(WriteDocument, VeryDeepNodesStopMovingToTheRight) {
  std::string text;
  for (int i = 0; i < 400; ++i) text += "G { c ";
  text += "NULL";
  for (int i = 0; i < 400; ++i) text += " }";
  const Reading reading(classic(text));
  EXPECT_LT(write_classic(reading.document).size(), 100'000U);
  EXPECT_LT(write_json(reading.document).size(), 150'000U);
}

}  // namespace
}  // namespace plugc
