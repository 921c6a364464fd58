#pragma once
// A mesh on the GPU: one vertex buffer, one index buffer, one vertex array that fits every program.

#include "package/package_file.h"
#include "runtime/gl/objects.h"

namespace plugc::gl {

struct Mesh {
  VertexArray vertex_array;
  Buffer vertices;
  Buffer indices;
  GLenum topology = GL_TRIANGLES;
  GLsizei index_count = 0;
};

Mesh upload_mesh(const Functions& gl, const PackedMesh& mesh);
/// Three vertices without attributes: the vertex stage makes of gl_VertexID a triangle over the whole target.
void draw_whole(const Functions& gl, const VertexArray& empty);

void draw_mesh(const Functions& gl, const Mesh& mesh);

}  // namespace plugc::gl
