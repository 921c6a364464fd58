// The vertex shader's arithmetic is that of stdlib_plugs/templates/phong.vert, so that both put every edge on the same pixels.

#include "runtime/gl/triangle_pass.h"

#include <array>

#include "runtime/gl/program.h"
#include "runtime/gl/target.h"
#include "runtime/gl/texture.h"

namespace plugc::gl {
namespace {

constexpr GLint kAlphaUnit = 0;

constexpr const char* kVertexText = R"(#version 330 core
uniform mat4 castle_ModelViewMatrix;
uniform mat4 castle_ProjectionMatrix;
layout(location = 0) in vec4 castle_Vertex;
layout(location = 4) in vec4 castle_MultiTexCoord0;
out vec2 tex_coord;
void main()
{
  vec4 vertex_eye = castle_ModelViewMatrix * castle_Vertex;
  tex_coord = castle_MultiTexCoord0.st;
  gl_Position = castle_ProjectionMatrix * vertex_eye;
}
)";

constexpr const char* kFragmentText = R"(#version 330 core
uniform float shape;
uniform sampler2D alpha;
uniform float cutoff;
in vec2 tex_coord;
layout(location = 0) out vec4 triangle;
void main()
{
  if (texture(alpha, tex_coord).a < cutoff)
    discard;
  triangle = vec4(shape, float(gl_PrimitiveID), 0.0, 1.0);
}
)";

void attach_shader(const Functions& gl, const Program& program, GLenum type, const char* text) {
  const Shader shader(gl, gl.CreateShader(type));
  gl.ShaderSource(shader.id(), 1, &text, nullptr);
  gl.CompileShader(shader.id());
  gl.AttachShader(program.id(), shader.id());
}

Program build_triangle_program(const Functions& gl) {
  Program program(gl, gl.CreateProgram());
  attach_shader(gl, program, GL_VERTEX_SHADER, kVertexText);
  attach_shader(gl, program, GL_FRAGMENT_SHADER, kFragmentText);
  gl.LinkProgram(program.id());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  return linked == GL_TRUE ? std::move(program) : Program();
}

void prepare_program(const Functions& gl, TrianglePass& pass) {
  if (pass.program) return;
  pass.program = build_triangle_program(gl);
  pass.model_view = uniform_location(gl, pass.program, "castle_ModelViewMatrix");
  pass.projection = uniform_location(gl, pass.program, "castle_ProjectionMatrix");
  pass.shape = uniform_location(gl, pass.program, "shape");
  pass.alpha = uniform_location(gl, pass.program, "alpha");
  pass.cutoff = uniform_location(gl, pass.program, "cutoff");
}

void prepare_target(const Functions& gl, TrianglePass& pass, GLsizei width, GLsizei height) {
  if (pass.framebuffer && pass.width == width && pass.height == height) return;
  pass.framebuffer = generate<Framebuffer>(gl, gl.GenFramebuffers);
  gl.BindFramebuffer(GL_FRAMEBUFFER, pass.framebuffer.id());
  pass.triangles = attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RG32F, width, height);
  pass.depth = attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height);
  pass.width = width;
  pass.height = height;
}

}  // namespace

bool begin_triangle_pass(const Functions& gl, TrianglePass& pass, GLsizei width, GLsizei height) {
  prepare_program(gl, pass);
  prepare_target(gl, pass, width, height);
  begin_color_pass(gl, pass.framebuffer, width, height, {-1, -1, -1});
  use_program(gl, pass.program);
  return pass.program && gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void draw_triangles(const Functions& gl, const TrianglePass& pass, const Mesh& mesh, const TriangleDraw& draw) {
  set_uniform(gl, pass.model_view, PackedUniformType::mat4, 1, {draw.model_view, 16});
  set_uniform(gl, pass.projection, PackedUniformType::mat4, 1, {draw.projection, 16});
  set_uniform(gl, pass.shape, PackedUniformType::float_, 1, {&draw.shape, 1});
  set_uniform(gl, pass.cutoff, PackedUniformType::float_, 1, {&draw.cutoff, 1});
  set_sampler(gl, pass.alpha, 1, kAlphaUnit);
  bind_texture(gl, kAlphaUnit, GL_TEXTURE_2D, draw.alpha_texture, 0);
  set_draw_state(gl, draw.state);
  draw_mesh(gl, mesh);
}

std::vector<float> read_triangles(const Functions& gl, const TrianglePass& pass) {
  std::vector<float> numbers(static_cast<std::size_t>(pass.width) * static_cast<std::size_t>(pass.height) * 2);
  gl.BindFramebuffer(GL_FRAMEBUFFER, pass.framebuffer.id());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, pass.width, pass.height, GL_RG, GL_FLOAT, numbers.data());
  return numbers;
}

}  // namespace plugc::gl
