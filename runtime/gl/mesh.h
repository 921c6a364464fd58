#pragma once
// A mesh on the GPU: one vertex buffer, one index buffer, one vertex array that fits every program.

#include <span>

#include "package/package_file.h"
#include "runtime/gl/objects.h"
#include "runtime/gl/program.h"

namespace plugc::gl {

struct Mesh {
  VertexArray vertex_array;
  Buffer vertices;
  Buffer indices;
  GLenum topology = GL_TRIANGLES;
  GLsizei index_count = 0;
};

/// A stream of four floats a vertex that is not part of the mesh's own vertices.
struct ExtraStream {
  PackedSemantic semantic = PackedSemantic::tex_coord;
  unsigned unit = 0;
  Buffer buffer;
};

/// The mesh with those streams in place of its own, and what a program's custom attributes find in it by their names. Refers to
/// the mesh's buffers.
VertexArray make_vertex_array(const Functions& gl, const Mesh& mesh, const PackedMesh& packed,
                              std::span<const ExtraStream> extra, const Attributes& attributes);
/// Whether the program reads an attribute that the mesh has by its name.
bool reads_custom(const PackedMesh& mesh, const Attributes& attributes);
Buffer make_stream_buffer(const Functions& gl);
void write_stream(const Functions& gl, const Buffer& buffer, std::span<const float> values);

Mesh upload_mesh(const Functions& gl, const PackedMesh& packed);
/// Other vertices, as many and laid out alike.
void rewrite_vertices(const Functions& gl, const Mesh& mesh, std::span<const std::uint8_t> vertices);
/// A triangle over a whole target: its corners in clip space, and texture coordinates that run from 0 to 1 over the target.
/// Most vertex stages ask for neither, and make it of gl_VertexID.
struct WholeTarget {
  VertexArray vertex_array;
  Buffer vertices;
};
WholeTarget make_whole_target(const Functions& gl);
void draw_whole(const Functions& gl, const WholeTarget& whole);

/// With another vertex array of that mesh, where one is given.
void draw_mesh(const Functions& gl, const Mesh& mesh, const VertexArray* vertex_array = nullptr);

}  // namespace plugc::gl
