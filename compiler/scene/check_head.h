#pragma once
// What a file says of itself, held against what X3D has.

#include "base/diagnostics.h"
#include "document/document.h"

namespace plugc {

/// Reports profiles, components, levels and categories of units that no version of X3D has (head_unknown), and units whose
/// values plugc takes for others (unit_not_converted). None of it changes what is read.
/// Source: X3D 4.1 part 1, 4.3.6 (units), 4.5 (profiles and components), annexes A to H.
void check_head(const HeadSyntax& head, Diagnostics& diagnostics);

}  // namespace plugc
