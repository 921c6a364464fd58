#pragma once
// Diagnostics for machines.

#include <string>
#include <string_view>

#include "base/diagnostics.h"

namespace plugc {

/// `json`: an array of {code, severity, message, file, line, column, end_line, end_column, related}. `sarif`: SARIF 2.1.0.
/// `github`: workflow commands (`::error file=...`).
std::string formatted_messages(const Diagnostics& diagnostics, std::string_view format);

}  // namespace plugc
