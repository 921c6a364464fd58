#pragma once
// glslang's log as data.

#include <string_view>
#include <vector>

#include "validate/verdict.h"

namespace plugc {

/// The errors of a log; warnings and summaries are left out, and nothing is said twice.
///
///     ERROR: 0:12: 'foo' : undeclared identifier   ->   line 12, token `foo`, text "`foo`: undeclared identifier"
///
/// `stage` is the one that was parsed; a linker's message may name another.
std::vector<VerdictMessage> read_glslang_log(std::string_view log, ShaderStage stage);

}  // namespace plugc
