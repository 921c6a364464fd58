#include <gtest/gtest.h>

#include "reading.h"

namespace plugc {
namespace {

TEST(Document, TellsTheEncodingByContent) {
  EXPECT_EQ(Reading("#X3D V3.2 utf8\n").document.encoding, Encoding::classic);
  EXPECT_EQ(Reading("#VRML V2.0 utf8\n").document.encoding, Encoding::vrml2);
  EXPECT_EQ(Reading("#VRML V1.0 ascii\n").document.encoding, Encoding::vrml1);
  EXPECT_EQ(Reading("\xEF\xBB\xBF \n<X3D><Scene/></X3D>").document.encoding, Encoding::xml);
  EXPECT_EQ(Reading("\xEF\xBB\xBF\n{\"X3D\": {\"Scene\": {}}}").document.encoding, Encoding::json);
}

TEST(Document, NamesWhatItDoesNotRead) {
  EXPECT_EQ(messages_of("\x1F\x8B\x08xx"), "1:1 5 this file is compressed; unpack it with `gunzip` first\n");
  EXPECT_EQ(messages_of(std::string("\xFF\xFE<\0", 4)), "1:1 4 this text is in UTF-16; save it as UTF-8\n");
  EXPECT_EQ(messages_of(""), "1:1 0 this file is empty\n");
  EXPECT_EQ(messages_of("\n\nShape { }\n"),
            "3:1 9 a scene begins with `#X3D V3.3 utf8`, `#VRML V2.0 utf8`, an XML tag or `{`; this text does not\n");
}

TEST(Document, WarnsOfAVersionThatDoesNotExist) {
  const Reading reading("#X3D V3.7 utf8\nBox { }");
  EXPECT_EQ(reading.messages(), "1:6 4 there is no version `3.7` of X3D; this file is read as 4.0\n");
  EXPECT_EQ(reading.diagnostics.all()[0].id, DiagnosticId::header_odd);
  EXPECT_EQ(reading.document.nodes.size(), 1U);
  EXPECT_EQ(messages_of("#VRML V2.1 utf8\n"), "1:7 4 there is no version `2.1` of VRML; this file is read as 2.0\n");
  EXPECT_EQ(messages_of("<X3D version='5'><Scene/></X3D>"),
            "1:15 1 there is no version `5` of X3D; this file is read as 4.0\n");
}

}  // namespace
}  // namespace plugc
