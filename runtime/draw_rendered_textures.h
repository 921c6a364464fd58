#pragma once
// The views that rendered textures show.

#include "runtime/frame.h"

namespace plugc {

/// Draws every rendered texture that is due and that some visible shape reads. One that shows itself, or a later one, sees what
/// that held before; those that are new are drawn again until what they show is three deep.
void draw_rendered_textures(Frame& frame);

}  // namespace plugc
