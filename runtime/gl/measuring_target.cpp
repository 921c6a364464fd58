#include "runtime/gl/measuring_target.h"

#include <array>

#include "runtime/gl/target.h"

namespace plugc::gl {

MeasuringTarget make_measuring_target(const Functions& gl, GLsizei width, GLsizei height) {
  MeasuringTarget target;
  target.framebuffer = generate<Framebuffer>(gl, gl.GenFramebuffers);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  target.outputs[0] = attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA32F, width, height);
  target.outputs[1] = attach_renderbuffer(gl, GL_COLOR_ATTACHMENT1, GL_RGBA32F, width, height);
  target.depth = attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height);
  constexpr std::array<GLenum, 2> both = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  gl.DrawBuffers(2, both.data());
  target.width = width;
  target.height = height;
  return target;
}

std::vector<glm::vec4> read_output(const Functions& gl, const MeasuringTarget& target, int index) {
  std::vector<glm::vec4> values(static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height));
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  gl.ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, target.width, target.height, GL_RGBA, GL_FLOAT, values.data());
  return values;
}

}  // namespace plugc::gl
