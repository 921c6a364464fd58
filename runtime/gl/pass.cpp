// GL_DEPTH_CLAMP is on in every pass that does not ask for clip_depth(): a caster between the light and the near plane still
// casts, and no camera fit can cut a hole into a scene. What is clamped keeps its place in the picture and loses only its order
// in depth.

#include "runtime/gl/pass.h"

#include "runtime/gl/program.h"

namespace plugc::gl {
namespace {

void set_enabled(const Functions& gl, GLenum capability, bool enabled) {
  if (enabled) {
    gl.Enable(capability);
  } else {
    gl.Disable(capability);
  }
}

GLenum blend_factor(PackedBlendFactor factor) {
  switch (factor) {
    case PackedBlendFactor::zero: return GL_ZERO;
    case PackedBlendFactor::one: return GL_ONE;
    case PackedBlendFactor::src_color: return GL_SRC_COLOR;
    case PackedBlendFactor::one_minus_src_color: return GL_ONE_MINUS_SRC_COLOR;
    case PackedBlendFactor::dst_color: return GL_DST_COLOR;
    case PackedBlendFactor::one_minus_dst_color: return GL_ONE_MINUS_DST_COLOR;
    case PackedBlendFactor::src_alpha: return GL_SRC_ALPHA;
    case PackedBlendFactor::one_minus_src_alpha: return GL_ONE_MINUS_SRC_ALPHA;
    case PackedBlendFactor::dst_alpha: return GL_DST_ALPHA;
    case PackedBlendFactor::one_minus_dst_alpha: return GL_ONE_MINUS_DST_ALPHA;
    case PackedBlendFactor::src_alpha_saturate: return GL_SRC_ALPHA_SATURATE;
    case PackedBlendFactor::constant_color: return GL_CONSTANT_COLOR;
    case PackedBlendFactor::one_minus_constant_color: return GL_ONE_MINUS_CONSTANT_COLOR;
    case PackedBlendFactor::constant_alpha: return GL_CONSTANT_ALPHA;
    case PackedBlendFactor::one_minus_constant_alpha: return GL_ONE_MINUS_CONSTANT_ALPHA;
  }
  return GL_ONE;
}

void begin_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei width, GLsizei height, bool reversed) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.Viewport(0, 0, width, height);
  set_draw_state(gl, DrawState{});  // also lets depth be written, which clearing needs
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(reversed ? GL_GEQUAL : GL_LEQUAL);
  gl.ClearDepth(reversed ? 0.0 : 1.0);
  if (gl.ClipControl != nullptr) gl.ClipControl(GL_LOWER_LEFT, reversed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  gl.Enable(GL_DEPTH_CLAMP);
}

}  // namespace

void set_context_defaults(const Functions& gl) {
  const auto location = [](PackedSemantic semantic, unsigned unit) {
    return static_cast<GLuint>(attribute_location(semantic, unit));
  };
  gl.VertexAttrib4f(location(PackedSemantic::normal, 0), 0, 0, 1, 0);
  gl.VertexAttrib4f(location(PackedSemantic::color, 0), 1, 1, 1, 1);
  gl.VertexAttrib4f(location(PackedSemantic::tangent, 0), 1, 0, 0, 1);
  for (unsigned unit = 0; unit < kTexCoordUnits; ++unit) {
    gl.VertexAttrib4f(location(PackedSemantic::tex_coord, unit), 0, 0, 0, 1);
  }
  gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void begin_color_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei width, GLsizei height,
                      const std::array<float, 3>& background) {
  begin_pass(gl, framebuffer, width, height, false);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.ClearColor(background[0], background[1], background[2], 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void begin_depth_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei size, float scale, float bias,
                      bool reversed) {
  begin_pass(gl, framebuffer, size, size, reversed);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(reversed ? -scale : scale, reversed ? -bias : bias);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
}

void clip_depth(const Functions& gl, bool on) {
  set_enabled(gl, GL_DEPTH_CLAMP, !on);
}

void set_far_away(const Functions& gl, bool on) {
  gl.DepthRange(on ? 1.0 : 0.0, 1.0);  // unlike switching the depth test off, this needs no other code for the program
}

void begin_whole_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei width, GLsizei height) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.Viewport(0, 0, width, height);
  set_draw_state(gl, DrawState{});
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
}

void set_draw_state(const Functions& gl, const DrawState& state) {
  set_enabled(gl, GL_BLEND, state.blended);
  gl.DepthMask(state.blended ? GL_FALSE : GL_TRUE);
  if (state.blended) {
    const std::array<float, 4>& color = state.blend_color;
    gl.BlendFunc(blend_factor(state.blend_source), blend_factor(state.blend_destination));
    gl.BlendColor(color[0], color[1], color[2], color[3]);
  }
  set_enabled(gl, GL_CULL_FACE, state.cull_back);
  gl.FrontFace(state.front_clockwise ? GL_CW : GL_CCW);
  gl.PolygonMode(GL_FRONT_AND_BACK, state.wireframe ? GL_LINE : GL_FILL);
  gl.LineWidth(state.line_width);
  set_enabled(gl, GL_PROGRAM_POINT_SIZE, state.program_sizes_points);
}

}  // namespace plugc::gl
