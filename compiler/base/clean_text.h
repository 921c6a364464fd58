#pragma once
// Text from files as valid UTF-8 without NUL, so that nothing behind the door has to ask: not the readers, not a message, not
// the shader compiler.

#include <string>

#include "base/diagnostics.h"

namespace plugc {

/// Adds a file's text to `sources`. A byte that belongs to no character (RFC 3629) becomes `?` and a NUL becomes a space, so
/// that places stay what they are; the first of them is reported (text_damaged). Text that says it is none in UTF-8 (UTF-16
/// with its byte order mark, gzip, binary glTF) stays as it is.
SourceId add_clean_text(SourceSet& sources, std::string name, std::string text, Diagnostics& diagnostics);

/// Text of a stranger's for a terminal or a line: control characters, which a terminal may obey, and bytes of no character are
/// written as \xNN.
std::string printable(std::string_view text);

/// The length of the character that begins at `at`, or 0 when no valid one does.
std::size_t character_length(std::string_view text, std::size_t at);

}  // namespace plugc
