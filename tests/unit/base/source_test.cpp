#include "base/source.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

std::string at(const SourceSet& sources, SourceId id, std::uint32_t offset) {
  const Position position = sources.position(id, offset);
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

TEST(Base, CountsLinesAndColumnsFromOne) {
  SourceSet sources;
  const SourceId id = sources.add("a.x3dv", "ab\ncd\r\n\ne");
  EXPECT_EQ(at(sources, id, 0), "1:1");
  EXPECT_EQ(at(sources, id, 2), "1:3");
  EXPECT_EQ(at(sources, id, 3), "2:1");
  EXPECT_EQ(at(sources, id, 7), "3:1");
  EXPECT_EQ(at(sources, id, 8), "4:1");
}

TEST(Base, TakesAnOffsetBehindTheEndAsTheEnd) {
  SourceSet sources;
  const SourceId id = sources.add("a", "ab\nc");
  EXPECT_EQ(at(sources, id, 4), "2:2");
  EXPECT_EQ(at(sources, id, 4000), "2:2");
  EXPECT_EQ(at(sources, sources.add("empty", ""), 7), "1:1");
}

TEST(Base, CountsCodePointsNotBytes) {
  SourceSet sources;
  const SourceId id = sources.add("a", "\xC3\xA4\xE2\x82\xACx");  // ä € x
  EXPECT_EQ(at(sources, id, 2), "1:2");
  EXPECT_EQ(at(sources, id, 5), "1:3");
}

TEST(Base, GivesTheByteOrderMarkNoColumn) {
  SourceSet sources;
  const SourceId id = sources.add("a", "\xEF\xBB\xBF#X3D\nab");
  EXPECT_EQ(at(sources, id, 0), "1:1");
  EXPECT_EQ(at(sources, id, 3), "1:1");
  EXPECT_EQ(at(sources, id, 4), "1:2");
  EXPECT_EQ(at(sources, id, 9), "2:2");
}

TEST(Base, CountsColumnsAlikeInAnyOrderOfQuestions) {
  SourceSet sources;
  const SourceId id = sources.add("a", "x\xC3\xA4y\nabcdef");
  EXPECT_EQ(at(sources, id, 8), "2:4");
  EXPECT_EQ(at(sources, id, 10), "2:6");
  EXPECT_EQ(at(sources, id, 6), "2:2");
  EXPECT_EQ(at(sources, id, 3), "1:3");
  EXPECT_EQ(at(sources, id, 10), "2:6");
}

TEST(Base, GivesTheLineThatHoldsAByte) {
  SourceSet sources;
  const SourceId id = sources.add("a", "one\r\n\ntwo");
  EXPECT_EQ(sources.line_at(id, 0), "one");
  EXPECT_EQ(sources.line_at(id, 4), "one");
  EXPECT_EQ(sources.line_at(id, 5), "");
  EXPECT_EQ(sources.line_at(id, 6), "two");
  EXPECT_EQ(sources.line_at(id, 900), "two");
}

TEST(Base, ClampsASpanToItsText) {
  SourceSet sources;
  const SourceId id = sources.add("a", "hello");
  EXPECT_EQ(sources.text(Span{id, 1, 3}), "el");
  EXPECT_EQ(sources.text(Span{id, 3, 99}), "lo");
  EXPECT_EQ(sources.text(Span{id, 99, 120}), "");
  EXPECT_EQ(sources.text(Span{id, 3, 1}), "");
}

TEST(Base, JoinsSpans) {
  const SourceId id{0};
  EXPECT_EQ(join({id, 2, 4}, {id, 7, 9}), (Span{id, 2, 9}));
  EXPECT_EQ(join({id, 2, 20}, {id, 7, 9}), (Span{id, 2, 20}));
}

TEST(Base, MapsEscapedTextBackToItsPlaces) {
  const SourceId id{3};
  MappedText text;  // a\"bc at 10
  text.append("a", id, 10);
  text.append_generated("\"", {id, 11, 13});
  text.append("bc", id, 13);
  EXPECT_EQ(text.text(), "a\"bc");
  EXPECT_EQ(text.locate(0, 1), (Span{id, 10, 11}));
  EXPECT_EQ(text.locate(1, 2), (Span{id, 11, 13}));
  EXPECT_EQ(text.locate(2, 4), (Span{id, 13, 15}));
  EXPECT_EQ(text.locate(0, 4), (Span{id, 10, 11}));
}

TEST(Base, LocatesTheEndOfAText) {
  MappedText text;
  text.append("abc", SourceId{0}, 20);
  EXPECT_EQ(text.locate(3, 3), (Span{SourceId{0}, 23, 23}));
  EXPECT_EQ(text.locate(900, 901), (Span{SourceId{0}, 23, 23}));
  EXPECT_FALSE(MappedText().locate(0, 1).valid());
}

TEST(Base, SkipsTextFromNowhereWhenItLocates) {
  MappedText text;
  text.append_generated("void ");
  text.append("main", SourceId{1}, 40);
  EXPECT_FALSE(text.locate(0, 4).valid());
  EXPECT_EQ(text.locate(0, 9), (Span{SourceId{1}, 40, 44}));
}

TEST(Base, AppendsAPartOfAMappedTextWithItsMap) {
  MappedText inner;
  inner.append("abcd", SourceId{0}, 100);
  inner.append_generated("&", {SourceId{0}, 104, 109});
  inner.append("ef", SourceId{0}, 109);
  MappedText outer;
  outer.append_generated("--");
  outer.append(inner, 2, 6);
  EXPECT_EQ(outer.text(), "--cd&e");
  EXPECT_EQ(outer.locate(2, 4), (Span{SourceId{0}, 102, 104}));
  EXPECT_EQ(outer.locate(4, 5), (Span{SourceId{0}, 104, 109}));
  EXPECT_EQ(outer.locate(5, 6), (Span{SourceId{0}, 109, 110}));
}

TEST(Base, AppendsATextToItself) {
  MappedText text;
  text.append("ab", SourceId{0}, 5);
  text.append(text);
  EXPECT_EQ(text.text(), "abab");
  EXPECT_EQ(text.locate(3, 4), (Span{SourceId{0}, 6, 7}));
}

TEST(Base, KeepsThePlacesOfTwoTouchingPiecesOfDifferentSources) {
  MappedText text;
  text.append("ab", SourceId{0}, 0);
  text.append("cd", SourceId{1}, 2);
  EXPECT_EQ(text.locate(1, 3), (Span{SourceId{0}, 1, 2}));
  EXPECT_EQ(text.locate(2, 4), (Span{SourceId{1}, 2, 4}));
}

}  // namespace
}  // namespace plugc
