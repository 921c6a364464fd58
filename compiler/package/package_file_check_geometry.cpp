// Meshes, images, and textures of them.

#include <set>
#include <utility>

#include "base/limits.h"
#include "package/package_file_check.h"

namespace plugc {
namespace {

std::uint32_t corners(PackedTopology topology) {
  switch (topology) {
    case PackedTopology::triangles: return 3;
    case PackedTopology::lines: return 2;
    case PackedTopology::points: return 1;
  }
  return 1;
}

bool check_stream(PackageCheck& check, const PackedStream& stream, std::uint32_t stride, const Place& place) {
  if (!is_enumerator(stream.semantic())) return check.fail(place, "its semantic is unknown");
  if (stream.unit() != 0 && stream.semantic() != PackedSemantic::tex_coord)
    return check.fail(place, "only texture coordinates are numbered");
  if (stream.components() < 1 || stream.components() > 4) return check.fail(place, "it has not 1 to 4 components");
  const std::uint64_t end = std::uint64_t{stream.offset()} + stream.components() * sizeof(float);
  const bool fits = stream.offset() % sizeof(float) == 0 && end <= stride;
  return fits || check.fail(place, fmt::format("bytes {} to {} do not fit into a vertex of {}", stream.offset(), end, stride));
}

/// One place a vertex, and nothing twice: who reads a stream takes the only one.
bool check_streams(PackageCheck& check, const PackedMesh& mesh, const Place& place) {
  std::set<std::pair<PackedSemantic, std::uint8_t>> seen;
  const auto check_new = [&](const PackedStream* stream, const Place& at) {
    if (!check_stream(check, *stream, mesh.stride(), at)) return false;
    return seen.emplace(stream->semantic(), stream->unit()).second || check.fail(at, "it is there twice");
  };
  if (!check.each(&place, "stream", *mesh.streams(), check_new)) return false;
  return seen.contains({PackedSemantic::position, 0}) || check.fail(place, "its vertices have no position");
}

bool check_vertices(PackageCheck& check, const PackedMesh& mesh, const Place& place) {
  if (mesh.stride() % sizeof(float) != 0) return check.fail(place, "its stride is no multiple of 4");
  const std::uint64_t bytes = std::uint64_t{mesh.vertex_count()} * mesh.stride();
  if (mesh.vertices()->size() != bytes) {
    return check.fail(place, fmt::format("its vertices take {} bytes, not {}", mesh.vertices()->size(), bytes));
  }
  if (mesh.vertex_count() != 0 && mesh.stride() == 0) return check.fail(place, "its vertices have no bytes");
  if (!check.charge(place, *mesh.vertices())) return false;
  return mesh.vertices()->size() == 0 || is_aligned(mesh.vertices()->data(), 16) ||
         check.fail(place, "its vertices are not aligned");
}

bool check_attribute(PackageCheck& check, const PackedMeshAttribute& attribute, std::uint32_t stride, const Place& place) {
  constexpr std::uint32_t kMost = 4;
  const auto is_count = [](std::uint32_t count) { return count >= 1 && count <= kMost; };
  if (!check.charge(place, *attribute.name())) return false;
  if (!is_count(attribute.columns()) || !is_count(attribute.components()))
    return check.fail(place, "it has not 1 to 4 columns of 1 to 4 components");
  const std::uint64_t end = std::uint64_t{attribute.offset()} + attribute.columns() * attribute.components() * sizeof(float);
  const bool fits = attribute.offset() % sizeof(float) == 0 && end <= stride;
  return fits ||
         check.fail(place, fmt::format("bytes {} to {} do not fit into a vertex of {}", attribute.offset(), end, stride));
}

}  // namespace

bool is_aligned(const void* data, std::size_t alignment) {
  return reinterpret_cast<std::uintptr_t>(data) % alignment == 0;
}

bool check_mesh(PackageCheck& check, const PackedMesh& mesh, const Place& place) {
  if (!is_enumerator(mesh.topology())) return check.fail(place, "its topology is unknown");
  if (mesh.bounds_min() == nullptr || mesh.bounds_max() == nullptr) return check.fail(place, "it has no bounds");
  if (!check_vertices(check, mesh, place)) return false;
  if (mesh.indices()->size() % corners(mesh.topology()) != 0) return check.fail(place, "its last primitive is cut short");
  const bool attributes_fit =
      mesh.attributes() == nullptr ||
      check.each(&place, "attribute", *mesh.attributes(), [&](const PackedMeshAttribute* attribute, const Place& at) {
        return check_attribute(check, *attribute, mesh.stride(), at);
      });
  return attributes_fit && check_streams(check, mesh, place) &&
         check.each(&place, "index", *mesh.indices(), [&](std::uint32_t index, const Place& at) {
           return check.require_index(at, "vertex", index, mesh.vertex_count());
         });
}

bool check_image(PackageCheck& check, const PackedImage& image, const Place& place) {
  const auto is_side = [](std::uint32_t side) { return side >= 1 && side <= kMaxImageSide; };
  if (!is_side(image.width()) || !is_side(image.height()) || !is_side(image.depth())) {
    return check.fail(place,
                      fmt::format("its size {} x {} x {} is out of range", image.width(), image.height(), image.depth()));
  }
  if (image.channels() < 1 || image.channels() > 4) return check.fail(place, "it has not 1 to 4 channels");
  const std::uint64_t bytes = std::uint64_t{image.width()} * image.height() * image.depth() * image.channels();
  if (image.pixels()->size() != bytes) {
    return check.fail(place, fmt::format("its pixels take {} bytes, not {}", image.pixels()->size(), bytes));
  }
  if (!check.charge(place, *image.pixels())) return false;
  return is_aligned(image.pixels()->data(), 16) || check.fail(place, "its pixels are not aligned");
}

bool check_texture(PackageCheck& check, const PackedTexture& texture, const Place& place) {
  if (!is_enumerator(texture.wrap_s()) || !is_enumerator(texture.wrap_t()) || !is_enumerator(texture.wrap_r()))
    return check.fail(place, "its wrap mode is unknown");
  // Only minification may use mipmaps.
  const bool good_filters = is_enumerator(texture.minification()) && texture.magnification() <= PackedFilter::linear;
  if (!good_filters) return check.fail(place, "its filter is unknown");
  return check.require_index(place, "image", texture.image(), check.package.images()->size());
}

}  // namespace plugc
