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
void draw_mesh(const Functions& gl, const Mesh& mesh);

}  // namespace plugc::gl
