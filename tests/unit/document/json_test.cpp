#include <gtest/gtest.h>

#include "reading.h"

namespace plugc {
namespace {

/// A JSON scene; the children begin in line 2.
std::string json(const std::string& children) {
  return "{\"X3D\":{\"@version\":\"4.0\",\"Scene\":{\"-children\":[\n" + children + "\n]}}}";
}

std::string field_of(const std::string& value) {
  const Reading reading(json("{\"A\":{\"@b\":" + value + "}}"));
  const std::string dump = reading.dump();
  return reading.messages() + dump.substr(dump.find("field"));
}

TEST(Document, ReadsNodesOfJson) {
  EXPECT_EQ(dump_of(json("{\"Shape\":{\n \"@DEF\":\"S\",\n \"-geometry\":{\"Box\":{\"@size\":[1,2,3]}},\n \"-appearance\":"
                         "{\"Appearance\":{\"-effects\":[{\"Effect\":{}},{\"Effect\":{\"@USE\":\"E\"}}]}}}},\n{\"Group\":{}}")),
            "document json 4.0\n"
            "2:2 DEF S Shape\n"
            "  4:4 field geometry\n"
            "    4:15 Box\n"
            "      4:24 field size [ ] 1 2 3\n"
            "  5:4 field appearance\n"
            "    5:17 Appearance\n"
            "      5:33 field effects\n"
            "        5:44 Effect\n"
            "        5:58 USE E\n"
            "6:2 Group\n");
}

TEST(Document, SpansWhatJsonSays) {
  const Reading reading(json("{\"Shape\" : { \"@DEF\":\"S\", \"-geometry\" : { \"Box\":{\"@size\":[ 1, 2,3 ]} } } }"));
  ASSERT_EQ(reading.messages(), "");
  const auto written = [&](const Span& span) { return reading.sources.text(span); };
  const Document& document = reading.document;
  EXPECT_EQ(written(document.nodes.at(0).span), "\"Box\":{\"@size\":[ 1, 2,3 ]}");
  EXPECT_EQ(written(document.nodes.at(0).type.span), "Box");
  EXPECT_EQ(written(document.nodes.at(1).extras->def.span), "S");
  EXPECT_EQ(written(document.fields.at(0).name.span), "size");
  EXPECT_EQ(written(document.fields.at(0).value.span), "[ 1, 2,3 ]");
  EXPECT_EQ(written(document.fields.at(1).value.span), "{ \"Box\":{\"@size\":[ 1, 2,3 ]} }");
}

TEST(Document, TakesJsonValuesByWhatTheyLookLike) {
  EXPECT_EQ(field_of("-1.5e2"), "field b -150\n");
  EXPECT_EQ(field_of("[0,1E2,-0.25]"), "field b [ ] 0 100 -0.25\n");
  EXPECT_EQ(field_of("true"), "field b TRUE\n");
  EXPECT_EQ(field_of("[true,false]"), "field b [ ] TRUE FALSE\n");
  EXPECT_EQ(field_of("\"0.5\""), "field b = \"0.5\"\n");
  EXPECT_EQ(field_of("[\"x\",\"y z\"]"), "field b [ ] \"x\" \"y z\"\n");
  EXPECT_EQ(field_of("[]"), "field b [ ]\n");
  EXPECT_EQ(field_of("null"), "field b NULL\n");
  EXPECT_EQ(field_of("1e-400"), "field b 0\n");
}

TEST(Document, DecodesEscapesOfJsonAndKeepsTheirPlaces) {
  const Reading reading(json(R"({"A":{"@b":["x\n\"\\\/\u00e9\uD83D\uDE00y"]}})"));
  ASSERT_EQ(reading.messages(), "");
  const MappedText& text = reading.document.strings.at(0);
  EXPECT_EQ(text.text(), "x\n\"\\/\xC3\xA9\xF0\x9F\x98\x80y");
  const auto written = [&](std::uint32_t begin, std::uint32_t end) { return reading.sources.text(text.locate(begin, end)); };
  EXPECT_EQ(written(0, 1), "x");
  EXPECT_EQ(written(1, 2), "\\n");
  EXPECT_EQ(written(4, 5), "\\/");
  EXPECT_EQ(written(5, 7), "\\u00e9");
  EXPECT_EQ(written(7, 11), "\\uD83D\\uDE00");
  EXPECT_EQ(written(11, 12), "y");
}

TEST(Document, DecodesNamesOfJson) {
  const Reading reading(json(R"({"Group":{"@DEF":"a\/b"}})"));
  EXPECT_EQ(reading.document.nodes.at(0).extras->def.text, "a/b");
  EXPECT_EQ(reading.sources.text(reading.document.nodes.at(0).extras->def.span), R"(a\/b)");
}

TEST(Document, JoinsTheLinesOfShaderCode) {
  const Reading reading(json(
      "{\"ShaderPart\":{\"#sourceCode\":[\"\",\n\"void main()\",\n\"{ }\"\n]}},\n{\"EffectPart\":{\"#cdata\":\"a\\nb\"}}"));
  ASSERT_EQ(reading.messages(), "");
  const MappedText& lines = reading.document.strings.at(0);
  EXPECT_EQ(lines.text(), "\nvoid main()\n{ }");
  EXPECT_EQ(reading.sources.text(lines.locate(13, 16)), "{ }");
  EXPECT_EQ(reading.document.strings.at(1).text(), "a\nb");
  EXPECT_EQ(reading.document.nodes.at(1).extras->cdata.count, 1U);
}

TEST(Document, ReadsInterfacesOfJson) {
  EXPECT_EQ(
      dump_of(json(
          "{\"Effect\":{\"field\":[\n{\"@name\":\"a\",\"@type\":\"SFFloat\",\"@accessType\":\"inputOutput\",\"@value\":0.5},\n"
          "{\"@accessType\":\"initializeOnly\",\"@type\":\"MFNode\",\"@name\":\"b\",\"-children\":[{\"Box\":{}},{\"#comment\":"
          "\"x\"}]},\n"
          "{\"@accessType\":\"inputOnly\",\"@type\":\"SFTime\",\"@name\":\"c\"}]}}")),
      "document json 4.0\n"
      "2:2 Effect\n"
      "  3:1 inputOutput SFFloat a 0.5\n"
      "  4:1 initializeOnly MFNode b\n"
      "    4:76 Box\n"
      "  5:1 inputOnly SFTime c\n");
}

TEST(Document, ReadsPrototypesOfJson) {
  EXPECT_EQ(
      dump_of(json(
          "{\"ProtoDeclare\":{\"@name\":\"P\",\"ProtoInterface\":{\"field\":[\n{\"@name\":\"r\",\"@type\":\"SFFloat\","
          "\"@accessType\":\"inputOutput\",\"@value\":2}]},\n\"ProtoBody\":{\"-children\":[{\"Sphere\":{\"IS\":{\"connect\":"
          "[{\"@nodeField\":\"radius\",\"@protoField\":\"r\"}]}}},\n{\"ROUTE\":{\"@fromNode\":\"A\",\"@fromField\":\"b\","
          "\"@toNode\":\"C\",\"@toField\":\"d\"}}]}}},\n{\"ExternProtoDeclare\":{\"@name\":\"E\",\"@url\":[\"urn:e\",\"e.x3d\"]"
          ","
          "\"field\":[\n{\"@name\":\"t\",\"@type\":\"SFTime\",\"@accessType\":\"inputOnly\"}]}},\n"
          "{\"ProtoInstance\":{\"@DEF\":\"D\",\"fieldValue\":[{\"@name\":\"r\",\"@value\":\"3\"},\n"
          "{\"@name\":\"n\",\"-children\":[{\"Box\":{}}]}],\"@name\":\"P\"}},\n{\"ProtoInstance\":{\"@USE\":\"D\"}}")),
      "document json 4.0\n"
      "2:2 PROTO P\n"
      "  3:1 inputOutput SFFloat r 2\n"
      "  4:28 Sphere\n"
      "    4:70 field radius IS r\n"
      "  5:2 ROUTE A.b TO C.d\n"
      "6:2 EXTERNPROTO E \"urn:e\" \"e.x3d\"\n"
      "  7:1 inputOnly SFTime t\n"
      "8:2 DEF D P\n"
      "  8:54 field r = \"3\"\n"
      "  9:11 field n\n"
      "    9:28 Box\n"
      "10:2 USE D\n");
}

TEST(Document, ConnectsAFieldThatJsonDeclaresLater) {
  EXPECT_EQ(dump_of(json("{\"Script\":{\"IS\":{\"connect\":[{\"@nodeField\":\"a\",\"@protoField\":\"b\"}]},\"field\":[\n"
                         "{\"@name\":\"a\",\"@type\":\"SFFloat\",\"@accessType\":\"inputOutput\"}]}}")),
            "document json 4.0\n2:2 Script\n  3:1 inputOutput SFFloat a IS b\n");
}

TEST(Document, ReadsImportsAndExportsOfJson) {
  EXPECT_EQ(
      dump_of(json(
          "{\"IMPORT\":{\"@inlineDEF\":\"I\",\"@importedDEF\":\"a\",\"@AS\":\"b\"}},\n{\"EXPORT\":{\"@localDEF\":\"b\"}}")),
      "document json 4.0\n2:2 IMPORT I.a AS b\n3:2 EXPORT b AS b\n");
}

TEST(Document, PutsANodeOfJsonIntoTheFieldThatItNames) {
  EXPECT_EQ(dump_of(json("{\"Group\":{\"-children\":[{\"Box\":{}},\n{\"Effect\":{\"@containerField\":\"effects\"}}]}}")),
            "document json 4.0\n2:2 Group\n  3:2 field -\n    3:2 Effect\n      3:31 containerField effects\n"
            "  2:13 field children\n    2:25 Box\n");
}

TEST(Document, TakesCommentsAndStatementsOfJsonForNoChildren) {
  EXPECT_EQ(
      dump_of(json("{\"Shape\":{\"-children\":[{\"#comment\":\"c\"},\n{\"ROUTE\":{\"@fromNode\":\"A\",\"@fromField\":\"b\","
                   "\"@toNode\":\"C\",\"@toField\":\"d\"}}],\n\"-geometry\":null,\"-effects\":[]}}")),
      "document json 4.0\n2:2 Shape\n  4:3 field geometry NULL\n  4:20 field effects NULL\n  3:2 ROUTE A.b TO C.d\n");
}

TEST(Document, PassesOverRemarksOfJson) {
  EXPECT_EQ(dump_of("{\"$id\":1,\"X3D\":{\"encoding\":\"UTF-8\",\"@profile\":\"Full\",\"@version\":\"3.3\",\"JSON "
                    "schema\":\"x\",\"head\":{\"meta\":[{}]},\n"
                    "\"Scene\":{\"#comment\":\"c\",\"-children\":[{\"#comment\":[\"a\"]},{\"Box\":{\"#comment\":\"c\",\"@"
                    "class\":\"k\"}}]}}}"),
            "document json 3.3\n1:48 PROFILE Full\n2:58 Box\n");
}

TEST(Document, KeepsTheHeadOfJson) {
  EXPECT_EQ(dump_of("{\"X3D\":{\"@version\":\"3.3\",\"head\":{\"#comment\":\"c\",\n"
                    "\"component\":[{\"@name\":\"Shaders\",\"@level\":2},{\"@name\":\"Text\",\"@level\":\"1\"}],\n"
                    "\"unit\":{\"@category\":\"length\",\"@name\":\"inch\",\"@conversionFactor\":0.0254},\n"
                    "\"meta\":[{\"@name\":\"a\",\"@content\":\"\\\"b\"}]},\"Scene\":{}}}"),
            "document json 3.3\n2:14 COMPONENT Shaders:2\n2:45 COMPONENT Text:1\n3:8 UNIT length inch 0.0254\n"
            "4:9 META \"a\" \"\\\"b\"\n");
}

// Mistakes

TEST(Document, ReportsAMissingOrExtraComma) {
  const Reading missing(json("{\"A\":{\"@b\":[1 2], \"@c\":1\n\"@d\":2}}"));
  EXPECT_EQ(missing.messages(), "2:13 1 a `,` is missing behind this\n2:24 1 a `,` is missing behind this\n");
  EXPECT_EQ(missing.document.fields.size(), 3U);
  EXPECT_EQ(missing.document.numbers.size(), 4U);
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":[1,2,]}}")), "2:16 1 no `,` may stand before `]`\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":[1,,2]}}")), "2:15 1 expected a value or `]`, found `,`\n");
}

TEST(Document, ReportsAKeyWithoutColonValueOrQuotes) {
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\" 1}}")), "2:7 4 a `:` is missing behind this\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":, \"@c\":1}}")), "2:11 1 a value is missing behind this\n");
  EXPECT_EQ(messages_of(json("{\"A\":{@b:1}}")), "2:7 2 put `@b` into quotes\n");
  EXPECT_EQ(messages_of(json("{\"A\":{{}}}")), "2:7 1 expected a key in quotes, found `{`\n");
}

TEST(Document, ReportsABracketThatDoesNotFit) {
  const Reading object(json("{\"A\":{\"-b\":[{\"B\":{]}},\n{\"C\":{}}"));
  EXPECT_EQ(object.messages(), "2:19 1 `}` is missing before this `]`\n");
  EXPECT_EQ(object.document.nodes.size(), 3U);
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":[1}},{\"C\":{}}")), "2:14 1 `]` is missing before this `}`\n");
  EXPECT_EQ(messages_of("{\"X3D\":{\"Scene\":{]}}}"), "1:18 1 expected a key or `}`, found `]`\n");
  EXPECT_EQ(messages_of("{\"X3D\":{\"Scene\":{\"-children\":["), "1:30 1 this `[` is not closed before the end of the file\n");
  EXPECT_EQ(messages_of("{\"X3D\":{\"Scene\":{}}}}"), "1:21 1 text stands behind the scene\n");
}

TEST(Document, EndsAStringWithoutQuoteAtItsLine) {
  const Reading reading(json("{\"A\":{\"@DEF\":\"x,\n\"@b\":1}}"));
  EXPECT_EQ(reading.messages(), "2:14 1 this `\"` begins a string that is not closed\n");
  EXPECT_EQ(reading.document.fields.size(), 1U);
}

TEST(Document, ReadsAStringOverSeveralLinesAndSaysSo) {
  const Reading reading(json("{\"A\":{\"#cdata\":\"x\r\n y\",\n\"@b\":1}}"));
  EXPECT_EQ(reading.messages(), "2:18 1 a string may hold no line break; write `\\n`\n");
  EXPECT_EQ(reading.document.strings.at(0).text(), "x\n y");
  EXPECT_EQ(reading.document.fields.size(), 1U);
}

TEST(Document, ReportsEscapesThatAreNone) {
  EXPECT_EQ(field_of(R"("a\db")"), "2:14 1 this `\\` begins no escape of JSON; write `\\\\`\nfield b = \"a\\\\db\"\n");
  EXPECT_EQ(field_of(R"("\uD83Dx")"), "2:13 6 `\\uD83D` is no character\nfield b = \"\xEF\xBF\xBDx\"\n");
  EXPECT_EQ(field_of(R"("\u12")"),
            "2:13 2 `\\u` is no character\nfield b = \"\xEF\xBF\xBD"
            "12\"\n");
}

TEST(Document, UnderstandsNumbersThatJsonDoesNotWrite) {
  EXPECT_EQ(field_of("+1"), "2:12 2 JSON does not write a number as `+1`\nfield b 1\n");
  EXPECT_EQ(field_of("[.5,01,2.]"),
            "2:13 2 JSON does not write a number as `.5`\n2:16 2 JSON does not write a number as `01`\n"
            "2:19 2 JSON does not write a number as `2.`\nfield b [ ] 0.5 1 2\n");
  EXPECT_EQ(field_of("1x"), "2:12 2 `1x` is no number that plugc can read\nfield b 1\n");
  EXPECT_EQ(field_of("-inf"), "2:12 4 `-inf` is no number that plugc can read\nfield b 0\n");
}

TEST(Document, ReportsValuesThatJsonDoesNotHave) {
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":TRUE}}")),
            "2:12 4 expected a number, a string in quotes, `true` or `false`, found `TRUE`\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":[[1,2],[3]]}}")),
            "2:13 1 a list stands inside a list; write its items into one\n"
            "2:19 1 a list stands inside a list; write its items into one\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":[1,\"x\"]}}")), "2:15 3 this list holds numbers; a string cannot stand in it\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":{\"Box\":{}}}}")),
            "2:12 1 expected a value, found an object; nodes stand behind a key with `-`\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"@DEF\":12}}")), "2:14 2 `DEF` is a string; put `12` into quotes\n");
}

TEST(Document, ReportsCommentsOfJsonOnce) {
  const Reading reading(json("// one\n{\"A\":{}}, /* two */ {\"B\":{}} // three"));
  EXPECT_EQ(reading.messages(), "2:1 2 JSON has no comments; write a member `#comment`\n");
  EXPECT_EQ(reading.document.nodes.size(), 2U);
}

TEST(Document, ReportsWhatIsNoNodeOfJson) {
  EXPECT_EQ(messages_of(json("{\"A\":{},\"B\":{}}")), "2:10 1 give `B` an object of its own: an object holds one node\n");
  EXPECT_EQ(messages_of(json("3, {\"@DEF\":\"x\"}")),
            "2:1 1 expected a node, found `3`\n2:6 4 expected the type of a node, found `@DEF`\n");
  EXPECT_EQ(messages_of(json("{\"A\":7}")), "2:6 1 expected an object for `A`, found `7`\n");
  EXPECT_EQ(messages_of(json("{\"A\":{\"b\":1}}")),
            "2:8 1 expected `@` before the name of a field, or `-` before that of a field for nodes, found `b`\n");
  EXPECT_EQ(messages_of("{\"asset\":{}}"), "1:1 1 this object holds no `X3D`\n");
  EXPECT_EQ(messages_of("{\"X3D\":{\"scene\":{}}}"),
            "1:10 5 expected `head` or `Scene`, found `scene`\n1:3 3 `X3D` holds no `Scene`\n");
}

TEST(Document, ReportsStatementsOfJsonThatLackAKey) {
  EXPECT_EQ(messages_of(json("{\"ROUTE\":{\"@fromNode\":\"a\"}}")), "2:3 5 `ROUTE` needs `@fromField`\n");
  EXPECT_EQ(messages_of(json("{\"ProtoInstance\":{}}")), "2:3 13 `ProtoInstance` needs `@name`\n");
  EXPECT_EQ(messages_of(json("{\"ProtoDeclare\":{\"@name\":\"P\"}}")), "2:3 12 `ProtoDeclare` holds no `ProtoBody`\n");
  EXPECT_EQ(messages_of(json("{\"ExternProtoDeclare\":{\"@name\":\"P\"}}")), "2:3 18 `ExternProtoDeclare` needs `@url`\n");
  EXPECT_EQ(messages_of(json("{\"Script\":{\"field\":[{\"@name\":\"a\",\"@type\":\"SFFloat\",\"@accessType\":\"field\"}]}}")),
            "2:67 5 there is no access type `field`; write `inputOnly`, `outputOnly`, `initializeOnly` or `inputOutput`\n");
  EXPECT_EQ(messages_of(json("{\"ProtoInstance\":{\"@name\":\"P\",\"fieldValue\":[{\"@name\":\"a\"}]}}")),
            "2:45 1 `fieldValue` needs `@value` or `-children`\n");
}

TEST(Document, PassesOverNodesOfJsonThatNestTooDeep) {
  std::string open, close;
  for (int i = 0; i < 600; ++i) {
    open += "{\"G\":{\"-c\":";
    close += "}}";
  }
  const Reading reading(json(open + "{\"Box\":{}}" + close));
  ASSERT_EQ(reading.diagnostics.all().size(), 1U);
  EXPECT_EQ(reading.diagnostics.all()[0].id, DiagnosticId::nesting_limit);
  EXPECT_EQ(messages_of(json("{\"A\":{\"@b\":" + std::string(100'000, '['))).substr(0, 4), "2:13");
}

TEST(Document, StopsAfterManyMistakesOfJson) {
  std::string values;
  for (int i = 0; i < 1000; ++i) values += "x,";
  const Reading reading(json("{\"A\":{\"@b\":[" + values + "1]}}"));
  EXPECT_EQ(reading.diagnostics.all().size(), 101U);
}

}  // namespace
}  // namespace plugc
