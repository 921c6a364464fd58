#pragma once
// `plugc inspect --orders`: which effects at one plug may be written in either order.

#include <string>

#include "compile.h"

namespace plugc {

/// Draws every pair of effects that meet at a plug in both orders, with three sets of field values, and prints what differs.
/// Returns the exit status.
int print_effect_orders(const std::string& scene, const CompileOptions& options, Validator& validator);

}  // namespace plugc
