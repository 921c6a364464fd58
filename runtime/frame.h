#pragma once
// What the parts of a frame share while it is drawn.

#include <set>

#include "runtime/loaded_scene.h"
#include "runtime/render.h"

namespace plugc {

struct Frame {
  const gl::Functions& gl;
  LoadedScene& scene;
  Messages& messages;
  const FrameOptions& options;
  View viewer = {};  ///< Whom the picture is for; needed where the scene has rendered textures.
  FrameStatistics statistics = {};
  std::set<std::uint32_t> programs = {};  ///< Drawn with so far.
};

/// Has depth, and colour in any format.
struct FrameTarget {
  const gl::Framebuffer& framebuffer;
  GLsizei width = 0;
  GLsizei height = 0;
  bool screen_effects = true;  ///< False: the scene alone, for measurements.
};

}  // namespace plugc
