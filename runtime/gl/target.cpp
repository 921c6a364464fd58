// Depth is 32 bit float: it costs what 24 bits cost here, and reads back quicker.

#include "runtime/gl/target.h"

#include <algorithm>

namespace plugc::gl {
namespace {

Framebuffer bind_new_framebuffer(const Functions& gl) {
  Framebuffer framebuffer = generate<Framebuffer>(gl, gl.GenFramebuffers);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  return framebuffer;
}

bool is_complete(const Functions& gl) {
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

Renderbuffer attach_renderbuffer(const Functions& gl, GLenum attachment, GLenum format, GLsizei width, GLsizei height,
                                 GLsizei samples) {
  Renderbuffer buffer = generate<Renderbuffer>(gl, gl.GenRenderbuffers);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  if (samples > 1)
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  else
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
  return buffer;
}

ColorTarget make_color_target(const Functions& gl, GLsizei width, GLsizei height, GLsizei samples) {
  ColorTarget target;
  target.width = width;
  target.height = height;
  target.samples = samples;
  bool complete = true;
  if (samples > 1) {
    target.resolved = bind_new_framebuffer(gl);
    target.resolved_color = attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height);
    complete = is_complete(gl);
  }
  target.framebuffer = bind_new_framebuffer(gl);
  target.color = attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, samples);
  target.depth = attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height, samples);
  if (complete && is_complete(gl)) return target;
  take_errors(gl);  // out of memory: told by the empty target, not again by the next draw
  return {};
}

void resolve(const Functions& gl, const ColorTarget& target) {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer.id());
  if (!target.resolved) return;
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.resolved.id());
  gl.BlitFramebuffer(0, 0, target.width, target.height, 0, 0, target.width, target.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.resolved.id());
}

Framebuffer make_depth_target(const Functions& gl, const Texture& texture, GLenum face) {
  Framebuffer framebuffer = bind_new_framebuffer(gl);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, face, texture.id(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  return framebuffer;
}

Framebuffer make_float_target(const Functions& gl, const Texture& texture) {
  Framebuffer framebuffer = bind_new_framebuffer(gl);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  return framebuffer;
}

GLsizei max_target_side(const Functions& gl) {
  GLint texture = 0;
  GLint renderbuffer = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  return std::min(texture, renderbuffer);
}

GLsizei max_cube_map_side(const Functions& gl) {
  GLint texture = 0;
  gl.GetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &texture);
  return std::min(texture, max_target_side(gl));
}

std::vector<std::uint8_t> read_rgba(const Functions& gl, GLsizei width, GLsizei height) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

}  // namespace plugc::gl
