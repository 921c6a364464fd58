// Depth is 32 bit float: it costs what 24 bits cost here, and reads back quicker.

#include "runtime/gl/target.h"

#include <algorithm>

namespace plugc::gl {
namespace {

constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT32F;

Renderbuffer new_renderbuffer(const Functions& gl, GLenum format, GLsizei width, GLsizei height, GLsizei samples) {
  Renderbuffer buffer = generate<Renderbuffer>(gl, gl.GenRenderbuffers);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  if (samples > 1)
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  else
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  return buffer;
}

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
  Renderbuffer buffer = new_renderbuffer(gl, format, width, height, samples);
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
  target.depth = attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, kDepthFormat, width, height, samples);
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

Framebuffer make_texture_target(const Functions& gl, const Texture& color, GLenum face, const Renderbuffer& depth) {
  Framebuffer framebuffer = bind_new_framebuffer(gl);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face, color.id(), 0);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
  return framebuffer;
}

Framebuffer make_texture_target(const Functions& gl, const Texture& color, const Texture& depth) {
  Framebuffer framebuffer = make_float_target(gl, color);
  if (depth) gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.id(), 0);
  return framebuffer;
}

Renderbuffer make_depth_buffer(const Functions& gl, GLsizei width, GLsizei height) {
  return new_renderbuffer(gl, kDepthFormat, width, height, 1);
}

bool is_complete(const Functions& gl, const Framebuffer& framebuffer) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  return is_complete(gl);
}

void copy_target(const Functions& gl, const Framebuffer& from, const Framebuffer& to, GLsizei width, GLsizei height,
                 bool with_depth) {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id());
  const GLbitfield what = with_depth ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT;
  gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
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
