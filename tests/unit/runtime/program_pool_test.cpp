#include "runtime/program_pool.h"

#include <gtest/gtest.h>

namespace plugc {
namespace {

std::vector<std::pair<std::uint32_t, std::string>> parsed(std::string_view log) {
  std::vector<std::pair<std::uint32_t, std::string>> result;
  for (const DriverError& error : parse_driver_log(log)) result.emplace_back(error.line, error.text);
  return result;
}

using Lines = std::vector<std::pair<std::uint32_t, std::string>>;

TEST(DriverLog, ReadsMesasLines) {
  EXPECT_EQ(parsed("0:12(3): error: `foo' undeclared\n0:13(1): warning: odd\n"),
            (Lines{{12, "error: `foo' undeclared"}, {13, "warning: odd"}}));
}

TEST(DriverLog, ReadsOtherDriversLines) {
  EXPECT_EQ(parsed("0(12) : error C1503: undefined variable \"foo\"\r\n"),
            (Lines{{12, "error C1503: undefined variable \"foo\""}}));
}

TEST(DriverLog, KeepsWhatItCannotRead) {
  EXPECT_EQ(parsed("error: unresolved\n\n99999999999999999999:1(2): x\n0:\n"),
            (Lines{{0, "error: unresolved"}, {0, "99999999999999999999:1(2): x"}, {0, "0:"}}));
  EXPECT_EQ(parsed(""), (Lines{{0, "it gives no reason"}}));
}

}  // namespace
}  // namespace plugc
