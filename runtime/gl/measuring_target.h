#pragma once
// A target for measurements: two outputs of 32-bit floats and a depth.

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include "runtime/gl/objects.h"

namespace plugc::gl {

struct MeasuringTarget {
  Framebuffer framebuffer;
  std::array<Renderbuffer, 2> outputs;
  Renderbuffer depth;
  GLsizei width = 0;
  GLsizei height = 0;
};

/// Whether the driver can draw into it is not asked.
MeasuringTarget make_measuring_target(const Functions& gl, GLsizei width, GLsizei height);

/// What programs wrote into output `index`: four numbers a pixel, rows from the bottom up.
std::vector<glm::vec4> read_output(const Functions& gl, const MeasuringTarget& target, int index);

}  // namespace plugc::gl
