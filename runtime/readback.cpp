// Samples are averaged first. One glReadPixels, then alpha is made opaque here: masking it while drawing would be one more
// blend state to generate code for.

#include "runtime/readback.h"

namespace plugc {

Picture read_back(const gl::Functions& functions, const gl::ColorTarget& target) {
  gl::resolve(functions, target);
  Picture picture{static_cast<std::uint32_t>(target.width), static_cast<std::uint32_t>(target.height),
                  gl::read_rgba(functions, target.width, target.height)};
  for (std::size_t i = 3; i < picture.pixels.size(); i += 4) picture.pixels[i] = 255;
  return picture;
}

}  // namespace plugc
