#pragma once
// The views that rendered textures show.

#include "runtime/frame.h"

namespace plugc {

/// Draws every rendered texture that is due and that some visible shape reads. One that shows itself sees white there; one that
/// shows a later one sees what that held before, at first what it holds without any of the others.
void draw_rendered_textures(Frame& frame);

}  // namespace plugc
