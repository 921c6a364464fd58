#pragma once
// The text of an XML attribute read as a list of numbers, booleans or strings (ISO/IEC 19776-1, 5: field value encodings).

#include <vector>

#include "base/diagnostics.h"
#include "base/source.h"

namespace plugc {

/// Numbers separated by white space and commas; `true`/`false` count as 1/0; hexadecimal `0xFF` too. The first thing that
/// is none of them is reported at its own place (field_type), and what was read before it is kept.
std::vector<double> read_lexical_numbers(const MappedText& text, Diagnostics& diagnostics);

/// `"a" "b\"c"` as MFString. Text without any quote is one string (common in real files).
std::vector<MappedText> read_lexical_strings(const MappedText& text, Diagnostics& diagnostics);

}  // namespace plugc
