#include "base/data_url.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

TEST(DataUrl, Base64ComesBackAsItWent) {
  for (const std::string& bytes :
       {std::string(), std::string("a"), std::string("ab"), std::string("abc"), std::string("\0\xFF\x80~", 4)}) {
    EXPECT_EQ(base64_decode(base64_encode(bytes)), bytes);
  }
  EXPECT_EQ(base64_encode("abcd"), "YWJjZA==");
  EXPECT_EQ(base64_decode("YWJj\n ZA"), "abcd");
  EXPECT_EQ(base64_decode("YW-j"), std::nullopt);
}

TEST(DataUrl, HoldsItsBytes) {
  EXPECT_EQ(data_url_bytes("data:image/png;base64,YWJj"), "abc");
  EXPECT_EQ(data_url_bytes(" data:,a%20b"), "a b");
  EXPECT_EQ(data_url_bytes("data:image/png;base64,!"), std::nullopt);
  EXPECT_EQ(data_url_bytes("data:image/png"), std::nullopt);
  EXPECT_EQ(data_url_bytes("a,b"), std::nullopt);
}

}  // namespace
}  // namespace plugc
