#pragma once
// What the children of a Worker do. Neither function returns.

#include <vector>

#include "glsl/stage.h"
#include "validate/socket.h"

namespace plugc {

/// For each byte that the owner sends, kills the worker before, forks one and sends its socket to the owner. Ends when the
/// owner's end of `owner` closes.
[[noreturn]] void run_spawner(Descriptor owner, const std::vector<Target>& warm_targets);

/// Warms up, greets with an empty message, then answers candidates with verdicts until `owner` closes.
[[noreturn]] void run_worker(Descriptor owner, const std::vector<Target>& warm_targets);

}  // namespace plugc
