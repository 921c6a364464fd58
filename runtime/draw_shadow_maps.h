#pragma once
// The shadow maps of one view.

#include "runtime/frame.h"

namespace plugc {

/// Draws the maps that are out of date for what `camera` sees. One that looks `all_around` sees everything.
void draw_shadow_maps(Frame& frame, const View& camera);

}  // namespace plugc
