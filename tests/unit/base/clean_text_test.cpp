#include "base/clean_text.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

TEST(Printable, KeepsWhatCanBeRead) {
  EXPECT_EQ(printable("phong lit; effects `Gl\xC3\xBChen` \xE2\x82\xAC"), "phong lit; effects `Gl\xC3\xBChen` \xE2\x82\xAC");
  EXPECT_EQ(printable("\xC2\xA0"), "\xC2\xA0");
}

TEST(Printable, SpellsOutWhatATerminalObeys) {
  EXPECT_EQ(printable("\x1B]0;owned\x07"), "\\x1b]0;owned\\x07");
  EXPECT_EQ(printable("a\nb\x7F"), "a\\x0ab\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\xc2\\x9b31m")
      << "the same as ESC [";
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, SpellsOutBytesOfNoCharacter) {
  EXPECT_EQ(printable("\x9B"
                      "31m \xFF\xC3"),
            "\\x9b31m \\xff\\xc3");
}

}  // namespace
}  // namespace plugc
