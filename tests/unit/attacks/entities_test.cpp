// What XML readers are attacked with: entities that grow, and entities that are files.

#include "attack.h"

namespace plugc {
namespace {

std::string with_declarations(const std::string& declarations, const std::string& elements) {
  return "<?xml version='1.0'?>\n<!DOCTYPE X3D [" + declarations + "]>\n" + xml_scene(elements);
}

TEST(Attacks, ABillionLaughsAreNotHeard) {
  std::string laughs = "<!ENTITY l0 'lol'>";
  for (int i = 1; i < 10; ++i) {
    laughs += "<!ENTITY l" + std::to_string(i) + " '" + repeated("&l" + std::to_string(i - 1) + ";", 10) + "'>";
  }
  const auto built = build(with_declarations(laughs, "<WorldInfo title='&l9;'/>"), {}, "s.x3d");
  EXPECT_EQ(built->said(),
            "s.x3d:2:15: warning: declarations of a document type are passed over; plugc knows the five entities of XML alone "
            "[doctype-subset]\n"
            "s.x3d:4:19: error: XML has no entity `&l9;`; write `&amp;` for the character `&` [syntax]\n");
  EXPECT_EQ(built->graph.string(built->root(), "title"), "&l9;");
}

TEST(Attacks, OneLongEntityIsNotRepeated) {
  const std::string text = with_declarations("<!ENTITY a '" + repeated("a", 100'000) + "'>",
                                             "<WorldInfo title='" + repeated("&a;", 100'000) + "'/>");
  const std::size_t peak = peak_of([&] { build(text); });
  expect_peak(peak, 12 * text.size());
}

TEST(Attacks, EntitiesReadNoFile) {
  const auto built = build(with_declarations("<!ENTITY e SYSTEM 'file:///etc/passwd'><!ENTITY % p SYSTEM 'secret.dtd'> %p;",
                                             "<WorldInfo title='&e;&p;'/>"),
                           {{"secret.dtd", "<!ENTITY q 'secret'>"}});
  EXPECT_EQ(built->graph.string(built->root(), "title"), "&e;&p;");
  EXPECT_EQ(built->said().find("root:"), std::string::npos);
}

TEST(Attacks, TheEntitiesOfXmlAndReferencesStillCount) {
  const auto built = build(xml_scene("<WorldInfo title='&lt;&gt;&amp;&quot;&apos;&#65;&#x42;'/>"));
  EXPECT_EQ(built->said(), "");
  EXPECT_EQ(built->graph.string(built->root(), "title"), "<>&\"'AB");
}

}  // namespace
}  // namespace plugc
