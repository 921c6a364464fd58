#include "document/read_lexical.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

struct Lexical {
  SourceSet sources;
  Diagnostics diagnostics{sources};
  MappedText text;
  explicit Lexical(std::string written) {
    const auto size = static_cast<std::uint32_t>(written.size());
    text = MappedText(sources, {sources.add("s", std::move(written)), 0, size});
  }
  std::string messages() const {
    std::string all;
    for (const Diagnostic& one : diagnostics.all()) {
      all += std::to_string(one.span.begin) + "-" + std::to_string(one.span.end) + " " + one.message + "\n";
    }
    return all;
  }
};

std::vector<std::string> strings_of(Lexical& lexical) {
  std::vector<std::string> strings;
  for (const MappedText& text : read_lexical_strings(lexical.text, lexical.diagnostics)) strings.emplace_back(text.text());
  return strings;
}

TEST(Document, ReadsNumbersOfAnAttribute) {
  Lexical lexical(" 1,-2.5 ,, +3\n.5 0xFF true false TRUE 1e-3 ");
  EXPECT_EQ(read_lexical_numbers(lexical.text, lexical.diagnostics), (std::vector<double>{1, -2.5, 3, .5, 255, 1, 0, 1, .001}));
  EXPECT_EQ(lexical.messages(), "");
}

TEST(Document, StopsAtTheFirstThingThatIsNoNumber) {
  Lexical lexical("1 2 x3 4 y");
  EXPECT_EQ(read_lexical_numbers(lexical.text, lexical.diagnostics), (std::vector<double>{1, 2}));
  EXPECT_EQ(lexical.messages(), "4-6 `x3` is no number\n");
  EXPECT_EQ(lexical.diagnostics.all()[0].id, DiagnosticId::field_type);
  Lexical suffix("1 2.0f");
  EXPECT_EQ(read_lexical_numbers(suffix.text, suffix.diagnostics), (std::vector<double>{1}));
  EXPECT_EQ(suffix.messages(), "2-6 `2.0f` is no number\n");
}

TEST(Document, ReadsQuotedStringsOfAnAttribute) {
  Lexical lexical(" \"a\", \"b\\\"c\"\"\\\\\"\n\"\" ");
  EXPECT_EQ(strings_of(lexical), (std::vector<std::string>{"a", "b\"c", "\\", ""}));
  EXPECT_EQ(lexical.messages(), "");
}

TEST(Document, TakesTextWithoutQuotesAsOneString) {
  Lexical lexical(" a.png ");
  EXPECT_EQ(strings_of(lexical), (std::vector<std::string>{" a.png "}));
  Lexical code("ecmascript: print(\"x\")");
  EXPECT_EQ(strings_of(code), (std::vector<std::string>{"ecmascript: print(\"x\")"}));
  Lexical nothing(" ");
  EXPECT_TRUE(strings_of(nothing).empty());
}

TEST(Document, KeepsThePlacesOfQuotedStrings) {
  Lexical lexical("\"a\\\"b\"");
  const auto strings = read_lexical_strings(lexical.text, lexical.diagnostics);
  EXPECT_EQ(strings.at(0).locate(2, 3), (Span{SourceId{0}, 4, 5}));
}

TEST(Document, ReportsTextBetweenStrings) {
  Lexical lexical("\"a\" b \"c\" \"d");
  EXPECT_EQ(strings_of(lexical), (std::vector<std::string>{"a", "c", "d"}));
  EXPECT_EQ(lexical.messages(),
            "4-5 text between strings; put it into quotes\n10-11 this `\"` begins a string that is not closed\n");
}

}  // namespace
}  // namespace plugc
