// Most numbers in scenes are short decimals such as -0.70711. Their digits without the point are a whole number below 2^53,
// which a double holds exactly, as it does the powers of ten up to 10^22; so one division of the two rounds once, and rightly
// (W. D. Clinger, How to read floating point numbers accurately, 1990). Everything else goes through std::from_chars.

#include "document/scan_number.h"

#include <array>
#include <cstdint>

#include "document/characters.h"

namespace plugc {
namespace {

constexpr std::array<double, 16> kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
constexpr std::ptrdiff_t kExactDigits = 15;  // 10^15 < 2^53

unsigned digit_of(char c) {
  return static_cast<unsigned>(static_cast<unsigned char>(c)) - '0';
}

/// Behind the short decimal at `at`, or null when there is none that ends where a number may end.
inline const char* scan_short_decimal(const char* at, const char* end, double& value) {
  const bool negative = at != end && *at == '-';
  at += negative ? 1 : 0;
  std::uint64_t digits = 0;
  const char* const whole = at;
  for (; at != end && digit_of(*at) < 10; ++at) digits = digits * 10 + digit_of(*at);
  std::ptrdiff_t count = at - whole, decimals = 0;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    for (; at != end && digit_of(*at) < 10; ++at) digits = digits * 10 + digit_of(*at);
    decimals = at - fraction;
    count += decimals;
  }
  const bool ends = at == end || !runs_on_number(*at);
  if (count == 0 || count > kExactDigits || !ends) return nullptr;
  const double magnitude = static_cast<double>(digits) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  value = negative ? -magnitude : magnitude;
  return at;
}

}  // namespace

std::from_chars_result scan_number(const char* at, const char* end, double& value) {
  const char* first = at;
  if (first != end && (*first == '+' || *first == '-')) ++first;
  if (first == end || !is_a(*first, kNumberStart) || *first == '+' || *first == '-') return {at, std::errc::invalid_argument};
  if (*first == '0' && end - first > 2 && (first[1] | 0x20) == 'x') {
    std::uint64_t bits = 0;
    const auto result = std::from_chars(first + 2, end, bits, 16);
    value = *at == '-' ? -static_cast<double>(bits) : static_cast<double>(bits);
    return result;
  }
  return std::from_chars(*at == '+' ? first : at, end, value);
}

NumberRun scan_numbers(const char* at, const char* end, std::vector<double>& numbers, std::size_t most) {
  NumberRun run{at, at};
  while (numbers.size() < most) {
    double value = 0;
    const char* behind = scan_short_decimal(at, end, value);
    if (behind == nullptr) {
      const auto [stop, error] = scan_number(at, end, value);
      if (error != std::errc() || (stop != end && runs_on_number(*stop))) return run;
      behind = stop;
    }
    numbers.push_back(value);
    run.numbers_end = behind;
    for (at = behind; at != end && is_a(*at, kSpaceCharacter);) ++at;
    run.next = at;
  }
  return run;
}

}  // namespace plugc
