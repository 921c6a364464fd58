#pragma once
// THE FRAME: shadow passes, then the colour pass, into a target of the caller's.

#include "runtime/loaded_scene.h"
#include "runtime/render.h"

namespace plugc {

/// Has depth, and colour in any format.
struct FrameTarget {
  const gl::Framebuffer& framebuffer;
  GLsizei width = 0;
  GLsizei height = 0;
};

/// Draws what is out of date of the scene's maps, then the picture. `width`, `height` and `samples` of the options are the
/// target's.
FrameStatistics draw_frame(const gl::Functions& gl, LoadedScene& scene, const FrameTarget& target, const FrameOptions& options,
                           Messages& messages);

}  // namespace plugc
