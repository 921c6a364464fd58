#pragma once
// What screen effects read and write: the picture so far as a texture, in two copies that take turns, and its depths.

#include "runtime/gl/objects.h"

namespace plugc {

struct ScreenTargets {
  gl::Texture colors[2];
  gl::Texture depth;
  gl::Framebuffer copied;           ///< colors[0] and the depths: what the picture is copied into.
  gl::Framebuffer framebuffers[2];  ///< Without them, as who draws there may read them.
  int shown = 0;                    ///< Which of both the next effect reads.
  GLsizei width = 0, height = 0;
};

}  // namespace plugc
