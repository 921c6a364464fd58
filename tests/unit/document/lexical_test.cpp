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

LexicalNumbers read(Lexical& lexical, LexicalKind kind = LexicalKind::numbers) {
  return read_lexical_numbers(lexical.text, kind, lexical.diagnostics);
}

TEST(Document, ReadsNumbersOfAnAttribute) {
  Lexical lexical(" 1,-2.5 ,, +3\n.5 0xFF 1e-3 1e-999 ");
  EXPECT_EQ(read(lexical).numbers, (std::vector<double>{1, -2.5, 3, .5, 255, .001, 0}));
  EXPECT_EQ(lexical.messages(), "");
}

TEST(Document, ReadsBooleansOfAnAttribute) {
  Lexical lexical("true false,true");
  const LexicalNumbers booleans = read(lexical, LexicalKind::booleans);
  EXPECT_EQ(booleans.numbers, (std::vector<double>{1, 0, 1}));
  EXPECT_FALSE(booleans.damaged);
  Lexical odd("TRUE 1 no");
  EXPECT_EQ(read(odd, LexicalKind::booleans).numbers, (std::vector<double>{1, 1, 0}));
  EXPECT_EQ(odd.messages(),
            "0-4 `TRUE` is spelled `true` here\n5-6 `1` is neither `true` nor `false`\n"
            "7-9 `no` is neither `true` nor `false`\n");
}

TEST(Document, ReportsEachThingThatIsNoNumberAndReadsOn) {
  Lexical lexical("1 2 x3 4 true 2.0f 1e999");
  const LexicalNumbers numbers = read(lexical);
  EXPECT_EQ(numbers.numbers, (std::vector<double>{1, 2, 0, 4, 0, 0, 0}));
  EXPECT_TRUE(numbers.damaged);
  EXPECT_EQ(lexical.messages(),
            "4-6 `x3` is no number\n9-13 `true` is no number\n14-18 `2.0f` is no number\n"
            "19-24 `1e999` is larger than any number that plugc reads\n");
  EXPECT_EQ(lexical.diagnostics.all()[0].id, DiagnosticId::field_type);
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
