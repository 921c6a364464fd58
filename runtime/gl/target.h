#pragma once
// What is drawn into: a picture with depth, or a depth texture alone.

#include <cstdint>
#include <vector>

#include "runtime/gl/objects.h"

namespace plugc::gl {

struct ColorTarget {
  Framebuffer framebuffer;  ///< Drawn into.
  Renderbuffer color;
  Renderbuffer depth;
  Framebuffer resolved;  ///< With several samples a pixel: their average, made by resolve().
  Renderbuffer resolved_color;
  GLsizei width = 0;
  GLsizei height = 0;
  GLsizei samples = 1;  ///< As asked for; the driver may give more.
};
/// No framebuffer when the driver cannot give one of that size.
ColorTarget make_color_target(const Functions& gl, GLsizei width, GLsizei height, GLsizei samples);

/// A new renderbuffer as that attachment of the framebuffer that is bound. `samples` above 1: so many a pixel, or more.
Renderbuffer attach_renderbuffer(const Functions& gl, GLenum attachment, GLenum format, GLsizei width, GLsizei height,
                                 GLsizei samples = 1);

/// Averages the samples, and binds for reading what has one sample a pixel.
void resolve(const Functions& gl, const ColorTarget& target);

/// A framebuffer whose depth is `texture`, or that face of a cube, and that has no colour.
Framebuffer make_depth_target(const Functions& gl, const Texture& texture, GLenum face = GL_TEXTURE_2D);

/// A framebuffer whose colour is `texture` and that has no depth.
Framebuffer make_float_target(const Functions& gl, const Texture& texture);

/// Draws into that texture, or that face of a cube, with that depth.
Framebuffer make_texture_target(const Functions& gl, const Texture& color, GLenum face, const Renderbuffer& depth);
/// As above, with a texture for its depth; none where `depth` is none.
Framebuffer make_texture_target(const Functions& gl, const Texture& color, const Texture& depth);
Renderbuffer make_depth_buffer(const Functions& gl, GLsizei width, GLsizei height);
bool is_complete(const Functions& gl, const Framebuffer& framebuffer);

/// Copies what is drawn, the average of its samples, into a target of that size; its depth, too, where asked for.
void copy_target(const Functions& gl, const Framebuffer& from, const Framebuffer& to, GLsizei width, GLsizei height,
                 bool with_depth);

GLsizei max_target_side(const Functions& gl);
/// The same of a face of a cube map.
GLsizei max_cube_map_side(const Functions& gl);

/// RGBA, 8 bits, rows from the bottom up. The target must be bound.
std::vector<std::uint8_t> read_rgba(const Functions& gl, GLsizei width, GLsizei height);

}  // namespace plugc::gl
