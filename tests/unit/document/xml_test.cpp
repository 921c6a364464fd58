#include <gtest/gtest.h>

#include "reading.h"

namespace plugc {
namespace {

TEST(Document, ReadsNestedElements) {
  EXPECT_EQ(dump_of(xml("<Group DEF='G' class='c' id='i'>\n <Shape containerField='x'><Box size='1 2 3'/></Shape>\n <Group "
                        "USE='G'/>\n</Group>")),
            "document xml 3.3\n"
            "2:1 DEF G Group\n"
            "  3:3 field -\n"
            "    3:2 Shape\n"
            "      3:25 containerField x\n"
            "      3:29 field -\n"
            "        3:28 Box\n"
            "          3:33 field size = \"1 2 3\"\n"
            "  4:3 field -\n"
            "    4:2 USE G\n");
}

TEST(Document, SpansAnElementToItsEndTag) {
  const Reading reading(xml("<Group><!-- > </Group> --><Box a='>' /><?x </Group>?></Group >"));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_EQ(reading.sources.text(reading.document.nodes.at(0).span), "<Box a='>' />");
  EXPECT_EQ(reading.sources.text(reading.document.nodes.at(1).span),
            "<Group><!-- > </Group> --><Box a='>' /><?x </Group>?></Group >");
}

TEST(Document, DecodesEntitiesAndKeepsTheirPlaces) {
  const Reading reading(xml("<A b='x&lt;y&#65;&#x20AC;&amp;&quot;&apos;&gt;z'/>"));
  EXPECT_EQ(reading.messages(), "");
  const MappedText& text = reading.document.strings.at(0);
  EXPECT_EQ(text.text(), "x<yA\xE2\x82\xAC&\"'>z");
  const auto written = [&](std::uint32_t begin, std::uint32_t end) { return reading.sources.text(text.locate(begin, end)); };
  EXPECT_EQ(written(0, 1), "x");
  EXPECT_EQ(written(1, 2), "&lt;");
  EXPECT_EQ(written(2, 3), "y");
  EXPECT_EQ(written(3, 4), "&#65;");
  EXPECT_EQ(written(4, 7), "&#x20AC;");
  EXPECT_EQ(written(11, 12), "z");
}

TEST(Document, KeepsLineBreaksOfAttributes) {
  const Reading reading("\xEF\xBB\xBF<X3D version='3.3'><Scene>\r\n<A url='x\r\ny\tz'/></Scene></X3D>");
  EXPECT_EQ(reading.messages(), "");
  const MappedText& text = reading.document.strings.at(0);
  EXPECT_EQ(text.text(), "x\ny\tz");
  const Position y = reading.sources.position(reading.source, text.locate(2, 3).begin);
  EXPECT_EQ(y.line, 3U);
  EXPECT_EQ(y.column, 1U);
}

TEST(Document, KeepsCdataAndTextInOrder) {
  EXPECT_EQ(dump_of(xml("<EffectPart>\n <![CDATA[a < b && c]]>\n text &lt; more<![CDATA[]]></EffectPart>")),
            "document xml 3.3\n"
            "2:1 EffectPart\n"
            "  3:11 text \"a < b && c\"\n"
            "  3:24 text \"\\n text < more\"\n"
            "  0:0 text \"\"\n");
}

TEST(Document, ReadsInterfacesOfElements) {
  EXPECT_EQ(dump_of(xml("<Effect>\n<field accessType='inputOutput' type='SFFloat' name='a' value='1'/>\n"
                        "<field accessType='initializeOnly' type='MFNode' name='b'><Box/><Box/></field>\n"
                        "<field accessType='inputOnly' type='SFTime' name='c'/>\n"
                        "<field accessType='outputOnly' type='SFTime' name='d'/></Effect>")),
            "document xml 3.3\n"
            "2:1 Effect\n"
            "  3:1 inputOutput SFFloat a = \"1\"\n"
            "  4:1 initializeOnly MFNode b\n"
            "    4:59 Box\n"
            "    4:65 Box\n"
            "  5:1 inputOnly SFTime c\n"
            "  6:1 outputOnly SFTime d\n");
}

TEST(Document, ReadsPrototypesOfXml) {
  EXPECT_EQ(dump_of(xml("<ProtoDeclare name='P'>\n<ProtoInterface><field accessType='inputOutput' type='SFFloat' name='r' "
                        "value='2'/></ProtoInterface>\n"
                        "<ProtoBody><Sphere><IS><connect nodeField='radius' protoField='r'/></IS></Sphere>\n"
                        "<ROUTE fromNode='A' fromField='b' toNode='C' toField='d'/></ProtoBody></ProtoDeclare>\n"
                        "<ExternProtoDeclare name='E' url='\"urn:e\" \"e.x3d\"'><field accessType='inputOnly' type='SFTime' "
                        "name='t'/></ExternProtoDeclare>\n"
                        "<ProtoInstance name='P' DEF='D' containerField='c'><fieldValue name='r' value='3'/>\n"
                        "<fieldValue name='n'><Box/></fieldValue></ProtoInstance>\n<ProtoInstance USE='D'/>")),
            "document xml 3.3\n"
            "2:1 PROTO P\n"
            "  3:17 inputOutput SFFloat r = \"2\"\n"
            "  4:12 Sphere\n"
            "    4:44 field radius IS r\n"
            "  5:1 ROUTE A.b TO C.d\n"
            "6:1 EXTERNPROTO E \"urn:e\" \"e.x3d\"\n"
            "  6:52 inputOnly SFTime t\n"
            "7:1 DEF D P\n"
            "  7:49 containerField c\n"
            "  7:70 field r = \"3\"\n"
            "  8:19 field n\n"
            "    8:22 Box\n"
            "9:1 USE D\n");
}

TEST(Document, ConnectsAnInterfaceFieldOfTheNodeItself) {
  EXPECT_EQ(dump_of(xml("<Script><IS><connect nodeField='a' protoField='b'/></IS>\n<field accessType='inputOutput' "
                        "type='SFFloat' name='a'/></Script>")),
            "document xml 3.3\n"
            "2:1 Script\n"
            "  3:1 inputOutput SFFloat a IS b\n");
}

TEST(Document, ReadsImportsAndExportsOfXml) {
  EXPECT_EQ(dump_of(xml("<IMPORT inlineDEF='I' importedDEF='a' AS='b'/>\n<IMPORT inlineDEF='I' exportedDEF='c'/>\n<EXPORT "
                        "localDEF='b' AS='d'/>")),
            "document xml 3.3\n"
            "2:1 IMPORT I.a AS b\n"
            "3:1 IMPORT I.c AS c\n"
            "4:1 EXPORT b AS d\n");
}

TEST(Document, PassesOverADoctype) {
  EXPECT_EQ(dump_of("<?xml version='1.0'?>\n<!DOCTYPE X3D [ <!ENTITY a 'b'> ]>\n<X3D version='3.0' xmlns:x='y'><Scene>"
                    "<Box/></Scene></X3D>"),
            "2:15 1 declarations of a document type are passed over; plugc knows the five entities of XML alone\n"
            "document xml 3.0\n3:39 Box\n");
}

TEST(Document, KeepsTheHeadOfXml) {
  EXPECT_EQ(dump_of("<X3D version='3.3' profile='Immersive'>\n<head><component name='Shaders' level='2'/>\n"
                    "<unit category='length' name='inch' conversionFactor='0.0254'/>\n<meta name='a' content='&lt;b'/>\n"
                    "<meta charset='utf-8'/><link href='x'/></head>\n<Scene/></X3D>"),
            "document xml 3.3\n1:29 PROFILE Immersive\n2:7 COMPONENT Shaders:2\n3:1 UNIT length inch 0.0254\n"
            "4:1 META \"a\" \"<b\"\n");
}

TEST(Document, DecodesNames) {
  const Reading reading(xml("<Group DEF='a&amp;b'/><Group USE='a&amp;b'/>"));
  EXPECT_EQ(reading.document.nodes.at(0).extras->def.text, "a&b");
  EXPECT_EQ(reading.document.nodes.at(1).extras->use.text, "a&b");
  EXPECT_EQ(reading.sources.text(reading.document.nodes.at(0).extras->def.span), "a&amp;b");
}

// Mistakes

TEST(Document, ReportsMarkupThatDoesNotFit) {
  EXPECT_EQ(messages_of(xml("<Group>\n<Box/>")), "4:1 8 this end tag does not close `<Group>`, which is open here\n");
  EXPECT_EQ(messages_of("<X3D version='3.3'><Scene><Group/>"), "1:21 5 `<Scene>` is not closed before the end of the file\n");
  EXPECT_EQ(messages_of("<X3D version='3.3'><Scene/></X3D></Group>"), "1:34 8 this end tag closes nothing\n");
  EXPECT_EQ(messages_of(xml("<Box size=1/>")), "2:11 1 the value of `size` stands without quotes; write `size=\"1\"`\n");
  EXPECT_EQ(messages_of(xml("<A><![CDATA[ x </A>")), "2:4 9 a CDATA section is not closed by `]]>`\n");
}

TEST(Document, KeepsWhatStoodBeforeBrokenMarkup) {
  const Reading reading("<X3D version='3.3'><Scene><Box size='1 1 1'/><Sphere></Scene></X3D>");
  EXPECT_EQ(reading.document.statements.count, 2U);
  EXPECT_EQ(reading.diagnostics.all().size(), 1U);
}

TEST(Document, EndsAnElementInFrontOfTheEndTagThatOvertakesIt) {
  const Reading reading(xml("<Group><Shape><Box> </Group> <A b='1 <C/>"));
  EXPECT_EQ(reading.messages(),
            "2:21 8 this end tag does not close `<Box>`, which is open here\n"
            "2:35 1 this `'` begins a value that is not closed\n");
  const auto written = [&](std::size_t node) { return reading.sources.text(reading.document.nodes.at(node).span); };
  EXPECT_EQ(written(0), "<Box> ");
  EXPECT_EQ(written(1), "<Shape><Box> ");
  EXPECT_EQ(written(2), "<Group><Shape><Box> </Group>");
}

TEST(Document, ReadsBehindEveryMistakeOfMarkup) {
  for (const char* const mistake :
       {"</A>",    "<A</A>", "<A></A", "<A b></A>", "<A b=></A>",  "<A b='/>",   "<A b=\"/>",      "<A b=1/>",
        "<A , />", "<A / >", "<A></>", "<!--",      "<!-- -- -->", "<?a>",       "<!DOCTYPE X3D",  "<",
        "<!",      "<>",     "< A/>",  "<A></a>",   "&",           "<A b='<'/>", "<A b='1'c='2'/>"}) {
    const Reading reading(xml(std::string("<Box/>") + mistake + "\n<Sphere/>\n"));
    EXPECT_EQ(reading.diagnostics.all().size(), 1U) << mistake << "\n" << reading.messages();
    EXPECT_EQ(reading.sources.text(reading.document.nodes.back().span), "<Sphere/>") << mistake;
    EXPECT_EQ(reading.document.statements.count, reading.document.nodes.size()) << mistake;
  }
}

TEST(Document, ReportsUnknownEntitiesAndKeepsThemAsWritten) {
  const Reading reading(xml("<A b='1 &nope; &amp &#0; &#xD800; & 2'/>"));
  EXPECT_EQ(reading.messages(),
            "2:9 6 XML has no entity `&nope;`; write `&amp;` for the character `&`\n"
            "2:16 1 this `&` begins no entity of XML; write `&amp;`\n"
            "2:21 4 `&#0;` refers to no character\n"
            "2:26 8 `&#xD800;` refers to no character\n"
            "2:35 1 this `&` begins no entity of XML; write `&amp;`\n");
  EXPECT_EQ(reading.document.strings.at(0).text(), "1 &nope; &amp &#0; &#xD800; & 2");
}

TEST(Document, ReportsMissingAttributes) {
  const Reading reading(xml(
      "<ROUTE fromNode='A' fromField='b' toNode='C'/>\n<Script><field type='SFTime' name='t'/></Script>\n<ProtoInstance/>"));
  EXPECT_EQ(reading.messages(),
            "2:2 5 `<ROUTE>` needs the attribute `toField`\n"
            "3:10 5 `<field>` needs the attribute `accessType`\n"
            "4:2 13 `<ProtoInstance>` needs the attribute `name`\n");
  EXPECT_TRUE(reading.document.routes.empty());
}

TEST(Document, ReportsAnUnknownAccessType) {
  EXPECT_EQ(
      messages_of(xml("<Script><field accessType='exposedField' type='SFTime' name='t'/></Script>")),
      "2:28 12 there is no access type `exposedField`; write `inputOnly`, `outputOnly`, `initializeOnly` or `inputOutput`\n");
}

TEST(Document, ReportsElementsAndTextOutOfPlace) {
  EXPECT_EQ(messages_of("<X3D version='3.3'><Box/></X3D>"), "1:21 3 expected `<head>` or `<Scene>`, found `<Box>`\n");
  EXPECT_EQ(messages_of("<Foo/>"), "1:2 3 expected `<X3D>`, found `<Foo>`\n");
  EXPECT_EQ(messages_of(xml("text")), "2:1 4 text stands where only elements may\n");
  EXPECT_EQ(messages_of(xml("<Box><IS><field/></IS></Box>")), "2:11 5 expected `<connect>` inside `<IS>`\n");
}

TEST(Document, ReadsDeepElementsUpToTheLimit) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "<A>";
  for (int i = 0; i < 100'000; ++i) text += "</A>";
  const Reading reading(xml(text));
  EXPECT_EQ(reading.messages(), "2:1538 1 nodes are nested more than 512 deep; this one is passed over\n");
}

}  // namespace
}  // namespace plugc
