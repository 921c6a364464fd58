#pragma once
// The screen effects over the picture.

#include "runtime/draw_view.h"
#include "runtime/frame.h"

namespace plugc {

/// Lets each effect that is on change what the target shows of `view`; of several samples a pixel they see the average.
void draw_screen_effects(Frame& frame, const FrameTarget& target, const SceneView& view);

}  // namespace plugc
