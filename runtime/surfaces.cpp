// Vertices are read from the package's vertex buffers by their streams. That a shape has an alpha test stands in the recipe of
// the program that it is seen with.

#include "runtime/surfaces.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "runtime/mesh_vertices.h"

namespace plugc {
namespace {

/// One value an index.
std::vector<glm::dvec3> read_corners(const MeshVertices& vertices, PackedSemantic semantic) {
  std::vector<glm::dvec3> values;
  const PackedStream* const stream = find_stream(vertices.mesh, semantic);
  if (stream == nullptr) return values;
  for (const std::uint32_t index : *vertices.mesh.indices()) values.emplace_back(read_vertex(vertices, *stream, index));
  return values;
}

bool tests_alpha(const PackedProgram& program) {
  const std::string_view recipe = program.recipe()->string_view();
  return recipe.substr(0, recipe.find(';')).find(" alpha_test") != std::string_view::npos;
}

std::optional<AlphaTest> find_alpha_test(const Package& package, const PackedShape& shape, const Slots& slots,
                                         const ShapePrograms& use) {
  if (!tests_alpha(*package.programs()->Get(use.program))) return std::nullopt;
  for (const PackedBinding* binding : *use.bindings) {
    if (binding->source() != PackedSource::texture) continue;
    const PackedTexture& texture = *package.textures()->Get(binding->a());
    const PackedImage& image = *package.images()->Get(texture.image());
    if (image.channels() == 2 || image.channels() == 4) {
      constexpr double kCutoff = 0.5;
      return AlphaTest{binding->a(), &texture, &image, slots.number(shape.alpha_cutoff(), kCutoff)};
    }
  }
  return std::nullopt;
}

/// The texel at a place that may be anywhere; out of reach of whole numbers, it is the first.
int texel_at(double place) {
  constexpr double kMost = 1e9;
  return std::abs(place) < kMost ? static_cast<int>(std::floor(place)) : 0;
}

/// -1: beyond the border.
int wrapped(int texel, int size, PackedWrap wrap) {
  if (wrap == PackedWrap::clamp_to_edge) return std::clamp(texel, 0, size - 1);
  if (wrap == PackedWrap::clamp_to_border) return texel < 0 || texel >= size ? -1 : texel;
  const int period = wrap == PackedWrap::repeat ? size : 2 * size;
  const int within = ((texel % period) + period) % period;
  return within < size ? within : period - 1 - within;
}

double texel_alpha(const AlphaTest& test, int x, int y) {
  const PackedImage& image = *test.image;
  const int width = static_cast<int>(image.width());
  const int column = wrapped(x, width, test.texture->wrap_s());
  const int row = wrapped(y, static_cast<int>(image.height()), test.texture->wrap_t());
  const PackedBorder* const border = test.texture->border();
  if (column < 0 || row < 0) return border == nullptr ? 0 : static_cast<double>(border->alpha());
  const auto at = static_cast<std::uint32_t>((row * width + column) * image.channels() + image.channels() - 1);
  return image.pixels()->Get(at) / 255.0;
}

}  // namespace

std::vector<Surface> read_surfaces(const Package& package, const PackedScene& scene, const Slots& slots, const World& world,
                                   const LiveMeshes& live) {
  std::vector<Surface> surfaces;
  const std::uint32_t count = scene.shapes()->size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const PackedShape& shape = *scene.shapes()->Get(i);
    const PackedMesh& mesh = *package.meshes()->Get(shape.mesh());
    if (shape.layer() != PackedLayer::world) continue;
    if (!world.shape_visible[i] || mesh.topology() != PackedTopology::triangles) continue;
    const ShapePrograms use = shape_programs(shape, world.shape_variant[i]);
    Surface surface;
    surface.shape = i;
    surface.to_world = world.at(shape.transform()).matrix;
    const MeshVertices vertices{mesh, vertex_bytes(mesh, live.find(shape.mesh()))};
    surface.points = read_corners(vertices, PackedSemantic::position);
    surface.alpha_test = find_alpha_test(package, shape, slots, use);
    if (surface.alpha_test) {
      for (const glm::dvec3& corner : read_corners(vertices, PackedSemantic::tex_coord))
        surface.tex_coords.emplace_back(corner);
    }
    if (surface.tex_coords.size() != surface.points.size()) surface.alpha_test.reset();  // there is no place to test
    surface.casts = use.casts();
    surface.may_move = !shape.bounds_known() || shape.bounds_min() != nullptr;
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

std::vector<Plane> world_planes(const Surface& surface) {
  std::vector<Plane> planes;
  const auto world = [&](std::size_t i) { return glm::dvec3(surface.to_world * glm::dvec4(surface.points[i], 1)); };
  for (std::size_t i = 0; i + 2 < surface.points.size(); i += 3) {
    const glm::dvec3 corner = world(i);
    const glm::dvec3 across = glm::cross(world(i + 1) - corner, world(i + 2) - corner);
    const double twice_area = glm::length(across);
    planes.push_back({corner, twice_area > 0 ? across / twice_area : glm::dvec3(0)});
  }
  return planes;
}

double alpha_at(const AlphaTest& test, const glm::dvec2& tex_coord) {
  const glm::dvec2 texel = tex_coord * glm::dvec2(test.image->width(), test.image->height());
  if (test.texture->magnification() == PackedFilter::nearest) {
    return texel_alpha(test, texel_at(texel.x), texel_at(texel.y));
  }
  const glm::dvec2 low = glm::floor(texel - 0.5);
  const glm::dvec2 part = texel - 0.5 - low;
  const int x = texel_at(low.x);
  const int y = texel_at(low.y);
  const double below = glm::mix(texel_alpha(test, x, y), texel_alpha(test, x + 1, y), part.x);
  const double above = glm::mix(texel_alpha(test, x, y + 1), texel_alpha(test, x + 1, y + 1), part.x);
  return glm::mix(below, above, part.y);
}

}  // namespace plugc
