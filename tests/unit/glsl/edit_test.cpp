#include <gtest/gtest.h>

#include "glsl/edit.h"

namespace plugc {
namespace {

class EditTest : public testing::Test {
 protected:
  MappedText part(std::string text) {
    const SourceId id = sources_.add("part.glsl", std::move(text));
    return MappedText(sources_, {id, 0, static_cast<std::uint32_t>(sources_.text(id).size())});
  }
  SourceSet sources_;
};

TEST_F(EditTest, ReplacesInsertsAndRemoves) {
  EXPECT_EQ(apply_edits(part("one two three"), {{8, 13, "four"}, {0, 4, ""}, {7, 7, ","}}).text(), "two, four");
  EXPECT_EQ(apply_edits(part("abc"), {}).text(), "abc");
  EXPECT_EQ(apply_edits(part(""), {{0, 0, "x"}}).text(), "x");
}

TEST_F(EditTest, InsertionsAtOnePlaceKeepTheirOrder) {
  EXPECT_EQ(apply_edits(part("abc"), {{1, 2, "B"}, {1, 1, "1"}, {1, 1, "2"}, {2, 2, "3"}}).text(), "a12B3c");
}

TEST_F(EditTest, KeepsTheMap) {
  const MappedText text = part("one two three");
  const MappedText edited = apply_edits(text, {{4, 7, "second"}, {0, 0, "// \n"}});
  ASSERT_EQ(edited.text(), "// \none second three");
  EXPECT_FALSE(edited.locate(0, 4).valid());
  EXPECT_EQ(edited.locate(4, 7), text.locate(0, 3));
  EXPECT_EQ(edited.locate(8, 14), text.locate(4, 7));
  EXPECT_EQ(edited.locate(15, 20), text.locate(8, 13));
}

TEST_F(EditTest, TakesAPlaceForWhatIsInserted) {
  const MappedText text = part("ab");
  const Span origin = text.locate(1, 2);
  EXPECT_EQ(apply_edits(text, {{0, 0, "x", origin}}).locate(0, 1), origin);
}

TEST_F(EditTest, OverlappingEditsAreABug) {
  const MappedText text = part("abcdef");
  EXPECT_DEATH(apply_edits(text, {{0, 3, "x"}, {2, 4, "y"}}), "edits lie inside the text and do not overlap");
  EXPECT_DEATH(apply_edits(text, {{4, 9, "x"}}), "edits lie inside the text and do not overlap");
}

}  // namespace
}  // namespace plugc
