// Vertices are written stream by stream into one interleaved buffer.

#include "package/pack_geometry.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/limits.h"
#include "mesh/live_vertices.h"
#include "package/pack_attributes.h"

namespace plugc {
namespace {

class VertexWriter {
 public:
  explicit VertexWriter(PackedMeshT& mesh) : mesh_(mesh) {}

  std::uint32_t add_stream(PackedSemantic semantic, std::uint8_t unit, std::uint8_t components) {
    const std::uint32_t offset = mesh_.stride;
    mesh_.streams.emplace_back(semantic, unit, components, offset);
    mesh_.stride += components * static_cast<std::uint32_t>(sizeof(float));
    return offset;
  }
  void alias_stream(std::uint8_t unit, const PackedStream& stream) {
    mesh_.streams.emplace_back(stream.semantic(), unit, stream.components(), stream.offset());
  }
  void allocate() { mesh_.vertices.resize(std::size_t{mesh_.stride} * mesh_.vertex_count); }
  void write(std::size_t vertex, std::uint32_t offset, const float* values, std::size_t count) {
    std::memcpy(mesh_.vertices.data() + vertex * mesh_.stride + offset, values, count * sizeof(float));
  }

 private:
  PackedMeshT& mesh_;
};

bool needs_four(const std::vector<glm::vec4>& coords) {
  return std::any_of(coords.begin(), coords.end(), [](const glm::vec4& c) { return c.z != 0.0F || c.w != 1.0F; });
}

void set_bounds(const Mesh& mesh, PackedMeshT& packed) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  glm::dvec3 low(kInfinity);
  glm::dvec3 high(-kInfinity);
  for (const glm::vec3& position : mesh.positions) {
    low = glm::min(low, glm::dvec3(position));
    high = glm::max(high, glm::dvec3(position));
  }
  packed.bounds_min = std::make_unique<PackedVec3>(low.x, low.y, low.z);
  packed.bounds_max = std::make_unique<PackedVec3>(high.x, high.y, high.z);
}

}  // namespace

std::unique_ptr<PackedMeshT> pack_mesh(const Mesh& mesh, std::uint32_t units) {
  auto packed = std::make_unique<PackedMeshT>();
  packed->topology = static_cast<PackedTopology>(mesh.topology);
  packed->vertex_count = static_cast<std::uint32_t>(mesh.positions.size());
  packed->indices = mesh.indices;
  VertexWriter writer(*packed);
  const std::uint32_t position = writer.add_stream(PackedSemantic::position, 0, 3);
  const std::uint32_t normal = mesh.normals.empty() ? 0 : writer.add_stream(PackedSemantic::normal, 0, 3);
  std::vector<std::pair<std::uint32_t, std::uint8_t>> coords;  // offset, components
  for (std::size_t unit = 0; unit < mesh.tex_coords.size(); ++unit) {
    const bool four = needs_four(mesh.tex_coords[unit]) || fed_width(mesh, static_cast<unsigned>(unit)) > 2;
    const std::uint8_t components = four ? 4 : 2;
    coords.emplace_back(writer.add_stream(PackedSemantic::tex_coord, static_cast<std::uint8_t>(unit), components), components);
  }
  if (!coords.empty()) {
    const PackedStream last = packed->streams.back();
    const std::size_t count = std::min<std::size_t>(units, kMaxTexCoordSets);
    for (std::size_t unit = coords.size(); unit < count; ++unit) writer.alias_stream(static_cast<std::uint8_t>(unit), last);
  }
  const std::uint32_t color = mesh.colors.empty() ? 0 : writer.add_stream(PackedSemantic::color, 0, 4);
  const std::uint32_t tangent = mesh.tangents.empty() ? 0 : writer.add_stream(PackedSemantic::tangent, 0, 4);
  const std::uint32_t fog = mesh.fog_coords.empty() ? 0 : writer.add_stream(PackedSemantic::fog_coord, 0, 1);
  add_mesh_attributes(mesh, *packed);
  writer.allocate();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    writer.write(v, position, &mesh.positions[v].x, 3);
    if (!mesh.normals.empty()) writer.write(v, normal, &mesh.normals[v].x, 3);
    for (std::size_t unit = 0; unit < coords.size(); ++unit) {
      writer.write(v, coords[unit].first, &mesh.tex_coords[unit][v].x, coords[unit].second);
    }
    if (!mesh.colors.empty()) writer.write(v, color, &mesh.colors[v].x, 4);
    if (!mesh.tangents.empty()) writer.write(v, tangent, &mesh.tangents[v].x, 4);
    if (!mesh.fog_coords.empty()) writer.write(v, fog, &mesh.fog_coords[v], 1);
  }
  write_mesh_attributes(mesh, *packed);
  set_bounds(mesh, *packed);
  return packed;
}

std::unique_ptr<PackedImageT> pack_image(const Image& image) {
  auto packed = std::make_unique<PackedImageT>();
  packed->width = image.width;
  packed->height = image.height;
  packed->depth = image.depth;
  packed->channels = static_cast<std::uint8_t>(image.channels);
  packed->pixels = image.pixels;
  return packed;
}

}  // namespace plugc
