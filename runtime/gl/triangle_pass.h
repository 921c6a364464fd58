#pragma once
// A picture of numbers: which triangle of which shape each pixel shows.

#include <vector>

#include "runtime/gl/mesh.h"
#include "runtime/gl/objects.h"
#include "runtime/gl/pass.h"

namespace plugc::gl {

/// Its program, and a target of the size that was drawn last.
struct TrianglePass {
  Program program;
  GLint model_view = -1, projection = -1, shape = -1, alpha = -1, cutoff = -1;
  Framebuffer framebuffer;
  Renderbuffer triangles;
  Renderbuffer depth;
  GLsizei width = 0;
  GLsizei height = 0;
};

/// One shape as the pass draws it. Matrices as OpenGL takes them: 16 floats, column by column.
struct TriangleDraw {
  const float* model_view = nullptr;
  const float* projection = nullptr;
  float shape = 0;
  GLuint alpha_texture = 0;  ///< Texels whose alpha is below `cutoff` are holes; 0: there are none.
  float cutoff = 0;
  DrawState state;
};

/// Binds the target, cleared to -1, and the program; both are made when they are missing or the size is another. False when
/// the driver cannot.
bool begin_triangle_pass(const Functions& gl, TrianglePass& pass, GLsizei width, GLsizei height);
void draw_triangles(const Functions& gl, const TrianglePass& pass, const Mesh& mesh, const TriangleDraw& draw);

/// Two numbers a pixel, shape and triangle; -1 where nothing is. Rows from the bottom up.
std::vector<float> read_triangles(const Functions& gl, const TrianglePass& pass);

}  // namespace plugc::gl
