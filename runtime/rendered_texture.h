#pragma once
// The textures that a scene draws for itself: their storage, and who reads them. When they are drawn:
// draw_rendered_textures.h.

#include <cstdint>
#include <vector>

#include "package/package_file.h"
#include "runtime/binding_readers.h"
#include "runtime/gl/target.h"
#include "runtime/gl/texture.h"
#include "runtime/messages.h"

namespace plugc {

/// What is drawn into.
struct DrawnPicture {
  gl::Texture texture;
  gl::Renderbuffer depth;
  gl::Texture color;                     ///< Drawn beside a texture of depths, and read by nobody.
  std::vector<gl::Framebuffer> targets;  ///< One, or one a face of a cube: +x -x +y -y +z -z.
};

struct RenderedTexture {
  DrawnPicture shown;  ///< No texture when it is never drawn, or no shape reads it: whoever does sees white.
  /// Drawn into in its place by one that may show itself, which then shows what it held before; the two change places. Else
  /// empty.
  DrawnPicture next;
  GLsizei width = 0, height = 0;
  PackedFilter minification = PackedFilter::linear;  ///< As it is looked up.
  std::vector<std::uint32_t> readers;                ///< Shapes some program of which reads it.
  bool read_by_screen = false;                       ///< Some screen effect does.
  std::uint64_t times_drawn = 0;                     ///< What was made of it at another count may be out of date.
  bool being_drawn = false;  ///< What reads it meanwhile sees what it held before, if there is a `next`, else white.
};

/// One per PackedRenderedTexture. Sizes beyond what can be made are reported.
std::vector<RenderedTexture> make_rendered_textures(const gl::Functions& functions, const PackedScene& scene,
                                                    const BindingReaders& readers_of, Messages& messages);

}  // namespace plugc
