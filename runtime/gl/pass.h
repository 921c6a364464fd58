#pragma once
// The fixed-function state of a pass and of a draw. Few variants on purpose: llvmpipe generates code again for each new
// blend state.

#include <array>

#include "package/package_file.h"
#include "runtime/gl/objects.h"

namespace plugc::gl {

/// Once a context: what a vertex input reads where the mesh has no such stream (normal 0 0 1, colour white, tangent
/// 1 0 0, texture coordinates 0 0 0 1), and cube maps without seams.
void set_context_defaults(const Functions& gl);

/// Colour and depth cleared, depth test on, depth clamped instead of clipped. Binds the framebuffer.
void begin_color_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei width, GLsizei height,
                      const std::array<float, 3>& background);

/// Depth cleared to the far plane, both faces drawn, moved away by glPolygonOffset(scale, bias). `reversed`: depth falls from
/// 1 to 0, for a target that stores it so.
void begin_depth_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei size, float scale, float bias,
                      bool reversed);

/// From here on in this pass, what lies in front of the near or behind the far plane is cut away.
void clip_depths(const Functions& gl);

/// While it is on, whatever is drawn lies as far away as can be: nothing is behind it.
void set_far_away(const Functions& gl, bool on);

/// Every texel is written, and nothing tested. Binds the framebuffer; draw_whole() draws.
void begin_whole_pass(const Functions& gl, const Framebuffer& framebuffer, GLsizei width, GLsizei height);

struct DrawState {
  bool blended = false;
  PackedBlendFactor blend_source = PackedBlendFactor::one;
  PackedBlendFactor blend_destination = PackedBlendFactor::zero;
  bool cull_back = false;
  bool front_clockwise = false;
  bool wireframe = false;
  std::array<float, 4> blend_color{};  ///< What the constant blend factors mean.
  float line_width = 1;                ///< Pixels; drivers cut it to what they have.
  bool program_sizes_points = false;   ///< Else points have one pixel.
};
void set_draw_state(const Functions& gl, const DrawState& state);

}  // namespace plugc::gl
