#pragma once
// THE FRAME: the textures that the scene draws for itself, the picture with its shadow maps, then the screen effects, into a
// target of the caller's.

#include "runtime/frame.h"

namespace plugc {

/// Draws what is out of date of the scene's textures and maps, then the picture. `width`, `height` and `samples` of the options
/// are the target's.
FrameStatistics draw_frame(const gl::Functions& gl, LoadedScene& scene, const FrameTarget& target, const FrameOptions& options,
                           Messages& messages);

}  // namespace plugc
