#pragma once
// The text of an XML attribute read as a list of numbers, booleans or strings (ISO/IEC 19776-1, 5: field value encodings).

#include <vector>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "base/source.h"

namespace plugc {

enum class LexicalKind : std::uint8_t { numbers, booleans };

struct LexicalNumbers {
  std::vector<double> numbers;
  bool damaged = false;  ///< Something in the text was reported.
  bool cut = false;      ///< There were more than asked for.
};

/// Numbers (hexadecimal `0xFF` too) or `true` and `false`, as 1 and 0, separated by white space and commas. What is none is
/// reported at its own place (field_type) and stands as 0. Reading ends behind the first `most` of them.
LexicalNumbers read_lexical_numbers(const MappedText& text, LexicalKind kind, Diagnostics& diagnostics,
                                    std::size_t most = kMaxDocumentNumbers);

/// `"a" "b\"c"` as MFString. Text without any quote is one string (common in real files).
std::vector<MappedText> read_lexical_strings(const MappedText& text, Diagnostics& diagnostics);

}  // namespace plugc
