// The package's bytes go to the GPU as they are; a stream becomes an attribute pointer at its semantic's fixed location.

#include "runtime/gl/mesh.h"

#include <array>

#include "runtime/gl/program.h"

namespace plugc::gl {
namespace {

GLenum topology_of(PackedTopology topology) {
  switch (topology) {
    case PackedTopology::triangles: return GL_TRIANGLES;
    case PackedTopology::lines: return GL_LINES;
    case PackedTopology::points: return GL_POINTS;
  }
  return GL_TRIANGLES;
}

Buffer upload_buffer(const Functions& gl, GLenum target, const void* data, std::size_t bytes) {
  Buffer buffer = generate<Buffer>(gl, gl.GenBuffers);
  gl.BindBuffer(target, buffer.id());
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

void point_at_stream(const Functions& gl, const PackedStream& stream, std::uint32_t stride) {
  const GLint location = attribute_location(stream.semantic(), stream.unit());
  if (location < 0) return;
  const auto* const offset = reinterpret_cast<const void*>(static_cast<std::uintptr_t>(stream.offset()));
  gl.EnableVertexAttribArray(static_cast<GLuint>(location));
  gl.VertexAttribPointer(static_cast<GLuint>(location), stream.components(), GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                         offset);
}

const PackedMeshAttribute* find_attribute(const PackedMesh& mesh, const PackedAttribute& wanted) {
  if (wanted.semantic() != PackedSemantic::custom || mesh.attributes() == nullptr) return nullptr;
  for (const PackedMeshAttribute* attribute : *mesh.attributes()) {
    if (attribute->name()->string_view() == wanted.name()->string_view()) return attribute;
  }
  return nullptr;
}

/// A matrix takes a location for each column.
void point_at_attribute(const Functions& gl, const PackedMeshAttribute& attribute, unsigned unit, std::uint32_t stride) {
  const GLint location = attribute_location(PackedSemantic::custom, unit);
  if (location < 0) return;
  for (unsigned column = 0; column < attribute.columns(); ++column) {
    const std::uintptr_t offset = attribute.offset() + std::uintptr_t{column} * attribute.components() * sizeof(float);
    const auto at = static_cast<GLuint>(location) + column;
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, attribute.components(), GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
  }
}

}  // namespace

bool reads_custom(const PackedMesh& mesh, const Attributes& attributes) {
  for (const PackedAttribute* wanted : attributes) {
    if (find_attribute(mesh, *wanted) != nullptr) return true;
  }
  return false;
}

Mesh upload_mesh(const Functions& gl, const PackedMesh& packed) {
  Mesh mesh;
  mesh.topology = topology_of(packed.topology());
  mesh.index_count = static_cast<GLsizei>(packed.indices()->size());
  mesh.vertex_array = generate<VertexArray>(gl, gl.GenVertexArrays);
  gl.BindVertexArray(mesh.vertex_array.id());
  mesh.vertices = upload_buffer(gl, GL_ARRAY_BUFFER, packed.vertices()->data(), packed.vertices()->size());
  mesh.indices = upload_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, packed.indices()->data(),
                               std::size_t{packed.indices()->size()} * sizeof(std::uint32_t));
  for (const PackedStream* stream : *packed.streams()) point_at_stream(gl, *stream, packed.stride());
  gl.BindVertexArray(0);
  return mesh;
}

void rewrite_vertices(const Functions& gl, const Mesh& mesh, std::span<const std::uint8_t> vertices) {
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices.data(), GL_DYNAMIC_DRAW);
}

WholeTarget make_whole_target(const Functions& gl) {
  constexpr std::array<float, 24> kVertices = {-1, -1, 0, 1, 0, 0, 0, 1,   //
                                               3,  -1, 0, 1, 2, 0, 0, 1,   //
                                               -1, 3,  0, 1, 0, 2, 0, 1};  // position, texture coordinate
  constexpr std::uint32_t kStride = 8 * sizeof(float);
  WholeTarget whole;
  whole.vertex_array = generate<VertexArray>(gl, gl.GenVertexArrays);
  gl.BindVertexArray(whole.vertex_array.id());
  whole.vertices = upload_buffer(gl, GL_ARRAY_BUFFER, kVertices.data(), sizeof kVertices);
  point_at_stream(gl, PackedStream(PackedSemantic::position, 0, 4, 0), kStride);
  point_at_stream(gl, PackedStream(PackedSemantic::tex_coord, 0, 4, kStride / 2), kStride);
  gl.BindVertexArray(0);
  return whole;
}

void draw_whole(const Functions& gl, const WholeTarget& whole) {
  gl.BindVertexArray(whole.vertex_array.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

VertexArray make_vertex_array(const Functions& gl, const Mesh& mesh, const PackedMesh& packed,
                              std::span<const ExtraStream> extra, const Attributes& attributes) {
  VertexArray array = generate<VertexArray>(gl, gl.GenVertexArrays);
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.id());
  for (const PackedStream* stream : *packed.streams()) point_at_stream(gl, *stream, packed.stride());
  for (const ExtraStream& stream : extra) {
    gl.BindBuffer(GL_ARRAY_BUFFER, stream.buffer.id());
    const PackedStream alone(stream.semantic, static_cast<std::uint8_t>(stream.unit), 4, 0);
    point_at_stream(gl, alone, 4 * sizeof(float));
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices.id());
  for (const PackedAttribute* wanted : attributes) {
    const PackedMeshAttribute* const found = find_attribute(packed, *wanted);
    if (found != nullptr) point_at_attribute(gl, *found, wanted->unit(), packed.stride());
  }
  gl.BindVertexArray(0);
  return array;
}

Buffer make_stream_buffer(const Functions& gl) {
  return generate<Buffer>(gl, gl.GenBuffers);
}

void write_stream(const Functions& gl, const Buffer& buffer, std::span<const float> values) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_DYNAMIC_DRAW);
}

void draw_mesh(const Functions& gl, const Mesh& mesh, const VertexArray* vertex_array) {
  gl.BindVertexArray(vertex_array != nullptr ? vertex_array->id() : mesh.vertex_array.id());
  gl.DrawElements(mesh.topology, mesh.index_count, GL_UNSIGNED_INT, nullptr);
}

}  // namespace plugc::gl
