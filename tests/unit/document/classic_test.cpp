#include <gtest/gtest.h>

#include "reading.h"

namespace plugc {
namespace {

TEST(Document, ReadsNestedNodes) {
  EXPECT_EQ(dump_of(classic("DEF G Group { children [\n  Shape { geometry Box { size 1 2 3 } }\n  USE G\n] }")),
            "document classic 3.3\n"
            "2:1 DEF G Group\n"
            "  2:15 field children\n"
            "    3:3 Shape\n"
            "      3:11 field geometry\n"
            "        3:20 Box\n"
            "          3:26 field size 1 2 3\n"
            "    4:3 USE G\n");
}

TEST(Document, TakesAValueByWhatItLooksLike) {
  EXPECT_EQ(dump_of(classic(
                "A {\n a 1 b TRUE c \"x\" d NULL e [] f [ TRUE FALSE ] g [ \"x\", \"y\" ] h [ 1, 2 ] i [ NULL ] j IS k\n}")),
            "document classic 3.3\n"
            "2:1 A\n"
            "  3:2 field a 1\n"
            "  3:6 field b TRUE\n"
            "  3:13 field c \"x\"\n"
            "  3:19 field d NULL\n"
            "  3:26 field e [ ]\n"
            "  3:31 field f [ ] TRUE FALSE\n"
            "  3:48 field g [ ] \"x\" \"y\"\n"
            "  3:63 field h [ ] 1 2\n"
            "  3:74 field i NULL\n"
            "  3:85 field j IS k\n");
}

TEST(Document, ReadsNumbersInEveryForm) {
  const Reading reading(classic("A { b .5 -.5 +1 -1e-3 1E2 2. 0xFF 0XfffFFFFF -0x10 1e-999 007 }"));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_EQ(reading.document.numbers, (std::vector<double>{.5, -.5, 1, -.001, 100, 2, 255, 4294967295.0, -16, 0, 7}));
}

TEST(Document, KeepsOneStringOnlyAsAValueWithoutBrackets) {
  EXPECT_EQ(messages_of(classic("A { b \"x\" \"y\" c 1 }")), "2:11 3 several strings need `[` and `]` around them\n");
}

TEST(Document, DecodesStringsAndKeepsTheirPlaces) {
  const Reading reading(classic("A { b \"a\\\"b\\\\c\\n\r\nd\" }"));
  EXPECT_EQ(reading.messages(), "");
  const MappedText& text = reading.document.strings.at(0);
  EXPECT_EQ(text.text(), "a\"b\\c\\n\nd");
  const auto column = [&](std::uint32_t at) {
    return reading.sources.position(reading.source, text.locate(at, at + 1).begin).column;
  };
  EXPECT_EQ(column(0), 8U);
  EXPECT_EQ(column(1), 9U);  // the backslash of \"
  EXPECT_EQ(column(2), 11U);
  EXPECT_EQ(column(3), 12U);  // the backslash of its pair
  EXPECT_EQ(column(4), 14U);
  const Span last = text.locate(8, 9);
  EXPECT_EQ(reading.sources.position(reading.source, last.begin).line, 3U);
}

TEST(Document, TakesCommasAndCommentsAsWhiteSpace) {
  EXPECT_EQ(dump_of(classic("A{#x {\n,b[1,,2#3\n 4]c\"#no\"}#end")),
            "document classic 3.3\n"
            "2:1 A\n"
            "  3:2 field b [ ] 1 2 4\n"
            "  4:4 field c \"#no\"\n");
}

TEST(Document, ReadsInterfacesInBothVocabularies) {
  EXPECT_EQ(
      dump_of(classic("Script {\n inputOnly SFTime a\n eventIn SFTime b IS c\n outputOnly SFVec3f d\n eventOut SFVec3f e\n"
                      " initializeOnly SFFloat f 1\n field SFNode g Box { }\n inputOutput MFNode h [ ]\n"
                      " exposedField SFInt32 i IS j\n url \"x\"\n}")),
      "document classic 3.3\n"
      "2:1 Script\n"
      "  3:2 inputOnly SFTime a\n"
      "  4:2 inputOnly SFTime b IS c\n"
      "  5:2 outputOnly SFVec3f d\n"
      "  6:2 outputOnly SFVec3f e\n"
      "  7:2 initializeOnly SFFloat f 1\n"
      "  8:2 initializeOnly SFNode g\n"
      "    8:17 Box\n"
      "  9:2 inputOutput MFNode h [ ]\n"
      "  10:2 inputOutput SFInt32 i IS j\n"
      "  11:2 field url \"x\"\n");
}

TEST(Document, TakesAnAccessWordWithoutATypeAsAField) {
  EXPECT_EQ(dump_of(classic("A { field 1 eventIn Box { } }")),
            "document classic 3.3\n"
            "2:1 A\n"
            "  2:5 field field 1\n"
            "  2:13 field eventIn\n"
            "    2:21 Box\n");
}

TEST(Document, ReadsPrototypes) {
  EXPECT_EQ(dump_of(classic(
                "PROTO P [ inputOutput SFFloat r 2, inputOnly SFTime t ] {\n Sphere { radius IS r }\n ROUTE A.b TO C.d\n}\n"
                "EXTERNPROTO E [ field SFFloat r ] [ \"urn:e\" \"e.wrl#E\" ]\nEXTERNPROTO F [ ] \"f\"\nP { r 3 }")),
            "document classic 3.3\n"
            "2:1 PROTO P\n"
            "  2:11 inputOutput SFFloat r 2\n"
            "  2:36 inputOnly SFTime t\n"
            "  3:2 Sphere\n"
            "    3:11 field radius IS r\n"
            "  4:2 ROUTE A.b TO C.d\n"
            "6:1 EXTERNPROTO E \"urn:e\" \"e.wrl#E\"\n"
            "  6:17 initializeOnly SFFloat r\n"
            "7:1 EXTERNPROTO F \"f\"\n"
            "8:1 P\n"
            "  8:5 field r 3\n");
}

TEST(Document, ReadsStatementsInsideNodes) {
  EXPECT_EQ(dump_of(classic("Group {\n PROTO P [ ] { Box { } }\n ROUTE A.b TO C.d\n children P { }\n}")),
            "document classic 3.3\n"
            "2:1 Group\n"
            "  5:2 field children\n"
            "    5:11 P\n"
            "  3:2 PROTO P\n"
            "    3:16 Box\n"
            "  4:2 ROUTE A.b TO C.d\n");
}

TEST(Document, KeepsStatementsAboutTheFile) {
  EXPECT_EQ(dump_of(classic("PROFILE Immersive\nCOMPONENT Shaders:2\nMETA \"a\" \"b\"\nUNIT length inch 0.0254\nBox { }")),
            "document classic 3.3\n2:9 PROFILE Immersive\n3:1 COMPONENT Shaders:2\n5:1 UNIT length inch 0.0254\n"
            "4:1 META \"a\" \"b\"\n6:1 Box\n");
}

TEST(Document, ReadsImportsAndExports) {
  EXPECT_EQ(dump_of(classic("IMPORT I.a AS b\nIMPORT I.c\nEXPORT b AS d\nEXPORT e")),
            "document classic 3.3\n"
            "2:1 IMPORT I.a AS b\n"
            "3:1 IMPORT I.c AS c\n"
            "4:1 EXPORT b AS d\n"
            "5:1 EXPORT e AS e\n");
}

TEST(Document, SpansANodeFromDefToItsBrace) {
  const Reading reading(classic("DEF A Group {\n} USE A"));
  EXPECT_EQ(reading.sources.text(reading.document.nodes.at(0).span), "DEF A Group {\n}");
  EXPECT_EQ(reading.sources.text(reading.document.nodes.at(1).span), "USE A");
}

TEST(Document, SpansAValueWithItsBrackets) {
  const Reading reading(classic("A { b [ 1 2 ]  c 1 2 # x\n d \"s\" e IS f }"));
  std::vector<std::string_view> values;
  for (const FieldSyntax& field : reading.document.fields) values.push_back(reading.sources.text(field.value.span));
  EXPECT_EQ(values, (std::vector<std::string_view>{"[ 1 2 ]", "1 2", "\"s\"", "IS f"}));
}

TEST(Document, ReadsVrml) {
  EXPECT_EQ(dump_of("#VRML V2.0 utf8 CosmoWorlds V1.0\nBox { }"), "document vrml 2.0\n2:1 Box\n");
}

TEST(Document, ReadsBehindAByteOrderMarkAndWithCarriageReturns) {
  EXPECT_EQ(dump_of("\xEF\xBB\xBF#X3D V4.0 utf8\r\nBox {\r\n size 1 1 1 }"),
            "document classic 4.0\n2:1 Box\n  3:2 field size 1 1 1\n");
}

// Mistakes: one message each, and what follows is read

TEST(Document, ReportsAMissingValue) {
  const Reading reading(classic("A { b }\nC { d 1 }"));
  EXPECT_EQ(reading.messages(), "2:7 1 expected a value for `b`, found `}`\n");
  EXPECT_EQ(reading.document.nodes.size(), 2U);
}

TEST(Document, ReportsAWordThatIsNoValue) {
  const Reading reading(classic("Switch { whichChoice one children [ ] }\nA { b c 2 }"));
  EXPECT_EQ(reading.messages(),
            "2:22 3 expected a value for `whichChoice`, found `one`\n"
            "3:7 1 expected a value for `b`, found `c`\n");
  EXPECT_EQ(reading.document.fields.size(), 4U);
}

TEST(Document, ReadsLowerCaseBooleansUnderProtest) {
  const Reading reading(classic("A { solid true b [ false ] }"));
  EXPECT_EQ(reading.messages(),
            "2:11 4 the classic encoding spells `true` as `TRUE`\n"
            "2:20 5 the classic encoding spells `false` as `FALSE`\n");
  EXPECT_EQ(reading.document.numbers, (std::vector<double>{1, 0}));
}

TEST(Document, ReportsWhatIsNoNumber) {
  const Reading reading(classic("A { b 1.0f 2 c 1.2.3 d - e 0xZZ f 1e999 g [ -inf ] }"));
  EXPECT_EQ(reading.messages(),
            "2:7 4 `1.0f` is no number that plugc can read\n"
            "2:16 5 `1.2.3` is no number that plugc can read\n"
            "2:24 1 `-` is no number that plugc can read\n"
            "2:28 4 `0xZZ` is no number that plugc can read\n"
            "2:35 5 `1e999` is no number that plugc can read\n"
            "2:45 4 `-inf` is no number that plugc can read\n");
  EXPECT_EQ(reading.document.numbers, (std::vector<double>{1, 2, 1.2, 0, 0, 0, 0}));
}

TEST(Document, AssumesAForgottenBrace) {
  const Reading reading(classic("Shape { geometry Box size 1 2 3 } appearance NULL }\nA { }"));
  EXPECT_EQ(reading.messages(), "2:22 4 expected `{` behind `Box`, found `size`\n");
  EXPECT_EQ(reading.document.nodes.size(), 3U);
}

TEST(Document, EndsAListBeforeTheNextField) {
  const Reading reading(classic("A { coord [ 0 1 -1 solid TRUE }\nB { }"));
  EXPECT_EQ(reading.messages(), "2:11 1 `[` is not closed before `solid`\n");
  EXPECT_EQ(reading.document.fields.size(), 2U);
  EXPECT_EQ(reading.document.nodes.size(), 2U);
}

TEST(Document, ReportsOnlyTheInnermostUnclosedBracket) {
  EXPECT_EQ(messages_of(classic("Group { children [ Shape { geometry Box { size 1 1 1")),
            "2:37 3 `Box` is not closed before the end of the file\n");
}

TEST(Document, ReportsAnUnclosedStringAtItsQuote) {
  EXPECT_EQ(messages_of(classic("A { b \"abc }\nB { }")), "2:7 1 this `\"` begins a string that is not closed\n");
}

TEST(Document, ReportsStrayBrackets) {
  const Reading reading(classic("} ]\nA { ] [ 1 { } ] b 1 }\n5 B { }"));
  EXPECT_EQ(reading.messages(),
            "2:1 1 `}` closes nothing here\n"
            "3:5 1 `]` closes nothing here\n"
            "4:1 1 expected a node or a statement, found `5`\n");
}

TEST(Document, KeepsAListToOneKindOfThing) {
  const Reading reading(classic("A { b [ 1 \"x\" 2 Box { s 7 } ] c [ Box { } 3 ] }"));
  EXPECT_EQ(reading.messages(),
            "2:11 3 this list holds numbers; a string cannot stand in it\n"
            "2:17 3 this list holds numbers; `Box` cannot stand in it\n"
            "2:43 1 this list holds nodes; `3` cannot stand in it\n");
  EXPECT_EQ(reading.document.numbers, (std::vector<double>{1, 2}));
  EXPECT_EQ(reading.document.nodes.size(), 2U);
}

TEST(Document, ReportsIncompleteStatements) {
  EXPECT_EQ(messages_of(classic("ROUTE A.b C.d\n")), "2:11 1 expected `TO`, found `C`\n");
  EXPECT_EQ(messages_of(classic("ROUTE A b TO C.d\nROUTE C. TO }\nBox { }")),
            "2:9 1 expected `.`, found `b`\n"
            "3:13 1 expected `TO`, found `}`\n"
            "3:13 1 `}` closes nothing here\n");
  EXPECT_EQ(messages_of(classic("PROTO P { Box { } }")), "2:9 1 expected `[` and the interface of `P`, found `{`\n");
  EXPECT_EQ(messages_of(classic("PROTO P [ SFFloat a 1 inputOnly SFTime t ] { }")),
            "2:11 7 expected an access type such as `inputOutput`, or `]`, found `SFFloat`\n");
  EXPECT_EQ(messages_of(classic("EXTERNPROTO E [ field SFFloat a 1 ] \"u\"")),
            "2:33 1 expected an access type such as `inputOutput`, or `]`, found `1`\n");
}

TEST(Document, ReadsDeepNestingUpToItsLimit) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "A { b ";
    text += "C { }";
    for (int i = 0; i < depth; ++i) text += " }";
    return classic(text + "\nD { }");
  };
  EXPECT_EQ(messages_of(nested(511)), "");
  const Reading reading(nested(200'000));
  EXPECT_EQ(reading.messages(), "2:3073 1 nodes are nested more than 512 deep; this one is passed over\n");
  EXPECT_EQ(reading.document.nodes.back().type.text, "D");
}

TEST(Document, ReadsDeepPrototypesUpToTheLimit) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "PROTO A [ ] { ";
  const Reading reading(classic(text));
  EXPECT_EQ(reading.messages(),
            "2:7175 1 nodes are nested more than 512 deep; this one is passed over\n"
            "2:7181 1 `{` is not closed before the end of the file\n");
}

TEST(Document, GivesUpAfterManyMistakes) {
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "A { b }\n";
  const Reading reading(classic(text));
  ASSERT_EQ(reading.diagnostics.all().size(), 101U);
  EXPECT_EQ(reading.diagnostics.all().back().message, "this file has 100 mistakes; the rest of it is not read");
}

}  // namespace
}  // namespace plugc
