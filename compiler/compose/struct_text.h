#pragma once
// A struct definition as its tokens alone, so that two that differ only in white space and comments compare equal.

#include <string>

#include "compose/code_unit.h"

namespace plugc {

/// `struct S { float x ; }`
std::string struct_text(const CodeUnit& code, const StructOutline& type);

/// The tokens of [begin, end), a blank between them.
std::string token_line(const CodeUnit& code, std::uint32_t begin, std::uint32_t end);

}  // namespace plugc
