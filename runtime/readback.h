#pragma once
// From the GPU's picture to the caller's.

#include "runtime/gl/target.h"
#include "runtime/render.h"

namespace plugc {

/// The average of its samples. Alpha is 255 throughout: an X3D background is opaque, like the window it stands for, however the
/// shaders in front of it left their alpha.
Picture read_back(const gl::Functions& functions, const gl::ColorTarget& target);

}  // namespace plugc
