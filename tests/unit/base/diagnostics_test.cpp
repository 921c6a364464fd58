#include "base/diagnostics.h"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "base/limits.h"

namespace plugc {
namespace {

std::string text_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& one : diagnostics.all()) text += to_text(one, diagnostics.sources());
  return text;
}

TEST(Base, WritesAMessageWithItsLineAndACaret) {
  SourceSet sources;
  const SourceId id = sources.add("scene.x3dv", "Shape {\n\tsolid maybe\n}\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 15, 20}, "`maybe` is no value");
  EXPECT_EQ(text_of(diagnostics),
            "scene.x3dv:2:8: error: `maybe` is no value [syntax]\n"
            "   solid maybe\n"
            "         ^~~~~\n");
}

TEST(Base, WritesRelatedPlaces) {
  SourceSet sources;
  const SourceId id = sources.add("a", "one\ntwo");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::field_unknown, {id, 4, 7}, "again", {{{id, 0, 1}, "first here"}, {{}, "by plugc"}});
  EXPECT_EQ(text_of(diagnostics),
            "a:2:1: warning: again [field-unknown]\n"
            "  two\n"
            "  ^~~\n"
            "a:1:1: note: first here\n"
            "  one\n"
            "  ^\n"
            "plugc: note: by plugc\n");
}

TEST(Base, EndsTheCaretWithItsLine) {
  SourceSet sources;
  const SourceId id = sources.add("a", "abc {\n}\n");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 4, 7}, "x");
  EXPECT_EQ(text_of(diagnostics), "a:1:5: error: x [syntax]\n  abc {\n      ^\n");
}

TEST(Base, PointsBehindTheLastCharacterAtTheEndOfTheFile) {
  SourceSet sources;
  const SourceId id = sources.add("a", "abc");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 3, 3}, "x");
  EXPECT_EQ(text_of(diagnostics), "a:1:4: error: x [syntax]\n  abc\n     ^\n");
}

TEST(Base, MeasuresTheCaretInCodePoints) {
  SourceSet sources;
  const SourceId id = sources.add("a", "\xEF\xBB\xBF\xC3\xA4 \xC3\xB6\xC3\xBC!");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 6, 10}, "x");
  EXPECT_EQ(text_of(diagnostics), "a:1:3: error: x [syntax]\n  \xC3\xA4 \xC3\xB6\xC3\xBC!\n    ^~\n");
}

TEST(Base, ShowsNoControlCharacters) {
  SourceSet sources;
  const SourceId id = sources.add("a", "a\x1B[31mb");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 0, 1}, "x");
  EXPECT_EQ(text_of(diagnostics), "a:1:1: error: x [syntax]\n  a [31mb\n  ^\n");
}

TEST(Base, ShowsWhatStandsAroundThePlaceInAVeryLongLine) {
  SourceSet sources;
  const SourceId id = sources.add("a", std::string(400, 'x') + "here" + std::string(400, 'y'));
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 400, 404}, "m");
  EXPECT_EQ(text_of(diagnostics), "a:1:401: error: m [syntax]\n  ..." + std::string(60, 'x') + "here" + std::string(96, 'y') +
                                      "...\n" + std::string(65, ' ') + "^~~~\n");
}

TEST(Base, KeepsAMessageToOneLineThatIsNotTooLong) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {}, "a\x1B[31m\nb" + std::string(1'000'000, 'x'));
  EXPECT_EQ(diagnostics.all()[0].message, "a?[31m?b" + std::string(1992, 'x') + "...");
}

TEST(Base, SaysEachDifferentThingOnceInOrder) {
  SourceSet sources;
  const SourceId id = sources.add("a", "abc");
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::syntax, {id, 1, 2}, "b");
  diagnostics.report(DiagnosticId::syntax, {id, 0, 1}, "a");
  diagnostics.report(DiagnosticId::syntax, {id, 1, 2}, "b");
  diagnostics.report(DiagnosticId::syntax, {id, 1, 3}, "b");
  diagnostics.report(DiagnosticId::field_type, {id, 1, 2}, "b");
  ASSERT_EQ(diagnostics.all().size(), 4U);
  EXPECT_EQ(diagnostics.all()[0].message, "b");
  EXPECT_EQ(diagnostics.all()[1].message, "a");
}

TEST(Base, CountsBySeverity) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  diagnostics.report(DiagnosticId::field_unknown, {}, "w");
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.report(DiagnosticId::syntax, {}, "e");
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.count(Severity::warning), 1U);
  EXPECT_EQ(diagnostics.count(Severity::note), 0U);
}

TEST(Base, StopsListingAfterVeryManyDiagnostics) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  for (std::size_t i = 0; i < kMaxDiagnostics + 500; ++i) {
    diagnostics.report(DiagnosticId::field_unknown, {}, std::to_string(i));
  }
  ASSERT_EQ(diagnostics.all().size(), kMaxDiagnostics + 1);
  EXPECT_EQ(diagnostics.all().back().message, "more than 10000 things are wrong; no more of them are listed");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Base, FindsTheNearestName) {
  static constexpr std::array<std::string_view, 3> kNames = {"texture_color", "light_scale", "main"};
  EXPECT_EQ(nearest_name("texture_colour", kNames), "texture_color");
  EXPECT_EQ(nearest_name("fog", kNames), "");
  EXPECT_EQ(nearest_name(std::string(5000, 'x'), kNames), "");
  EXPECT_EQ(did_you_mean("ligt_scale", kNames), "; did you mean `light_scale`?");
  EXPECT_EQ(did_you_mean("zzz", kNames), "");
  EXPECT_EQ(did_you_mean("z", std::vector<std::string_view>{"a", "b"}), "");
}

TEST(Base, GivesEveryKindACodeOfItsOwn) {
  std::vector<std::string_view> codes;
  for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(DiagnosticId::count); ++i) {
    codes.push_back(diagnostic_kind(static_cast<DiagnosticId>(i)).code);
  }
  std::sort(codes.begin(), codes.end());
  EXPECT_EQ(std::adjacent_find(codes.begin(), codes.end()), codes.end());
}

}  // namespace
}  // namespace plugc
