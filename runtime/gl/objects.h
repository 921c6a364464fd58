#pragma once
// OpenGL names that delete themselves: move-only, one word and a pointer. Their context must be current when they die.

#include <utility>

#include "runtime/gl/functions.h"

namespace plugc::gl {

template <void (*Delete)(const Functions&, GLuint)>
class Object {
 public:
  Object() = default;
  Object(const Functions& functions, GLuint id) : functions_(&functions), id_(id) {}
  Object(Object&& other) noexcept : functions_(other.functions_), id_(std::exchange(other.id_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(functions_, other.functions_);
    std::swap(id_, other.id_);
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() {
    if (id_ != 0) Delete(*functions_, id_);
  }

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  const Functions* functions_ = nullptr;
  GLuint id_ = 0;
};

inline void delete_buffer(const Functions& gl, GLuint id) {
  gl.DeleteBuffers(1, &id);
}
inline void delete_framebuffer(const Functions& gl, GLuint id) {
  gl.DeleteFramebuffers(1, &id);
}
inline void delete_program(const Functions& gl, GLuint id) {
  gl.DeleteProgram(id);
}
inline void delete_renderbuffer(const Functions& gl, GLuint id) {
  gl.DeleteRenderbuffers(1, &id);
}
inline void delete_sampler(const Functions& gl, GLuint id) {
  gl.DeleteSamplers(1, &id);
}
inline void delete_shader(const Functions& gl, GLuint id) {
  gl.DeleteShader(id);
}
inline void delete_texture(const Functions& gl, GLuint id) {
  gl.DeleteTextures(1, &id);
}
inline void delete_vertex_array(const Functions& gl, GLuint id) {
  gl.DeleteVertexArrays(1, &id);
}

using Buffer = Object<delete_buffer>;
using Framebuffer = Object<delete_framebuffer>;
using Program = Object<delete_program>;
using Renderbuffer = Object<delete_renderbuffer>;
using Sampler = Object<delete_sampler>;
using Shader = Object<delete_shader>;
using Texture = Object<delete_texture>;
using VertexArray = Object<delete_vertex_array>;

/// A new name from one of the glGen functions: `generate<Buffer>(gl, gl.GenBuffers)`.
template <typename Handle, typename Generate>
Handle generate(const Functions& gl, Generate generate_names) {
  GLuint id = 0;
  generate_names(1, &id);
  return Handle(gl, id);
}

}  // namespace plugc::gl
