#pragma once
// What screen effects read and write: the picture so far and its depths as textures, in two copies that take turns.

#include "runtime/gl/objects.h"

namespace plugc {

struct ScreenTargets {
  gl::Texture colors[2];
  gl::Texture depth;  ///< Drawn with colors[0].
  gl::Framebuffer framebuffers[2];
  int shown = 0;  ///< Which of both the next effect reads.
  GLsizei width = 0, height = 0;
};

}  // namespace plugc
