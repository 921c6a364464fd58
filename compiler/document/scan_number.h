#pragma once
// The one way to read numbers, alone and in long lists, for all encodings.

#include <charconv>
#include <vector>

#include "base/limits.h"

namespace plugc {

/// A number at `at`: `1`, `+.5`, `-1e-3`, `0xFF`. Like std::from_chars, but with a plus and hexadecimal, without `inf` and
/// `nan`. Exactly rounded.
std::from_chars_result scan_number(const char* at, const char* end, double& value);

/// Where a run of numbers stopped.
struct NumberRun {
  const char* numbers_end;  ///< Behind the last number; `at` when there was none.
  const char* next;         ///< The first thing that is neither a number nor white space nor a comma.
};

/// Appends the numbers at `at` as long as they are plain ones between white space and commas. It stops in front of anything
/// odd (a bracket, a comment, a number that is out of range or runs into other characters), which the caller looks at, and
/// when there are `most` numbers in the list.
NumberRun scan_numbers(const char* at, const char* end, std::vector<double>& numbers, std::size_t most = kMaxDocumentNumbers);

}  // namespace plugc
