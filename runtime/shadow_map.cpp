// Textures are made once, with the scene.

#include "runtime/shadow_map.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "base/limits.h"
#include "runtime/cube_map.h"

namespace plugc {
namespace {

constexpr GLsizei kMaxCubeMapSide = 4096;  // six faces: 384 MiB

GLsizei usable_size(std::uint32_t wanted, GLsizei largest, Messages& messages) {
  const auto limit = std::min(kMaxShadowMapSide, static_cast<std::uint32_t>(std::max(largest, 1)));
  const std::uint32_t size = std::clamp(wanted, 1U, limit);
  if (size != wanted) {
    messages.add("a shadow map cannot have the size " + std::to_string(wanted) + ": it gets " + std::to_string(size));
  }
  return static_cast<GLsizei>(size);
}

bool receives(const PackedShape& shape, std::uint32_t map) {
  return std::find(shape.receives()->begin(), shape.receives()->end(), map) != shape.receives()->end();
}

bool reads(const flatbuffers::Vector<const PackedBinding*>& bindings, std::uint32_t map) {
  return std::any_of(bindings.begin(), bindings.end(),
                     [map](const PackedBinding* binding) { return reads_map(*binding) && binding->a() == map; });
}

/// The shape's programs look into the map, or its light projects their texture coordinates.
bool reads(const PackedShape& shape, std::uint32_t map, std::uint8_t variant) {
  const auto* coords = shape.projected_coords();
  return reads(*shape_programs(shape, variant).bindings, map) || (coords != nullptr && reads(*coords, map));
}

/// Shapes that are seen from the light: shadowed by it, or with texture coordinates that it projects.
bool is_seen_from(const PackedShape& shape, std::uint32_t map, std::uint8_t variant) {
  return receives(shape, map) || reads(shape, map, variant);
}

void add_moments(const gl::Functions& functions, PackedShadowMethod method, ShadowMap& map) {
  const bool two = method == PackedShadowMethod::vsm;
  map.unblurred = gl::make_float_texture(functions, map.size, two);
  map.unblurred_target = gl::make_float_target(functions, map.unblurred);
  map.moments = gl::make_float_texture(functions, map.size, two);
  map.moments_target = gl::make_float_target(functions, map.moments);
}

void make_cube(const gl::Functions& functions, GLint filter, ShadowMap& map) {
  map.texture = gl::make_depth_texture(functions, GL_TEXTURE_CUBE_MAP, map.size, false, filter);
  for (GLenum face = 0; face < kCubeFaceCount; ++face)
    map.faces.push_back(gl::make_depth_target(functions, map.texture, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face));
}

void make_flat(const gl::Functions& functions, const PackedShadowMap& packed, GLint filter, ShadowMap& map) {
  map.reversed = !packed.author_visible() && functions.ClipControl != nullptr;
  map.texture = gl::make_depth_texture(functions, GL_TEXTURE_2D, map.size, map.reversed, filter);
  map.framebuffer = gl::make_depth_target(functions, map.texture);
  if (keeps_moments(packed.method())) add_moments(functions, packed.method(), map);
}

/// Of its depths, and of its moments, which are kept twice.
std::uint64_t bytes_of(const PackedShadowMap& packed, bool cube, GLsizei size) {
  constexpr std::uint64_t kDepth = 4, kTwoMoments = 8, kFourMoments = 16;
  const std::uint64_t texels = static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(size);
  if (cube) return texels * kDepth * kCubeFaceCount;
  const std::uint64_t moments = packed.method() == PackedShadowMethod::vsm ? kTwoMoments : kFourMoments;
  return texels * (kDepth + (keeps_moments(packed.method()) ? 2 * moments : 0));
}

bool is_complete(const gl::Functions& gl, const ShadowMap& map) {
  const auto drawn = [&gl](const gl::Framebuffer& target) { return !target || gl::is_complete(gl, target); };
  return drawn(map.framebuffer) && drawn(map.unblurred_target) && drawn(map.moments_target) &&
         std::ranges::all_of(map.faces, drawn);
}

/// Takes its bytes from those that are left.
ShadowMap make_shadow_map(const gl::Functions& functions, const PackedScene& scene, const PackedShadowMap& packed,
                          std::uint32_t size, std::uint64_t& bytes_left, Messages& messages) {
  ShadowMap map;
  if (packed.update() == PackedShadowUpdate::none || packed.method() == PackedShadowMethod::traced) return map;
  const bool cube = is_cube(scene, packed);
  const GLint filter = packed.method() == PackedShadowMethod::hard ? GL_NEAREST : GL_LINEAR;
  const GLsizei largest = cube ? std::min(gl::max_cube_map_side(functions), kMaxCubeMapSide) : gl::max_target_side(functions);
  map.size = usable_size(size, largest, messages);
  const std::uint64_t bytes = bytes_of(packed, cube, map.size);
  if (bytes > bytes_left) {
    messages.add("the scene's shadow maps need more memory than they get: the shadows of the last are missing");
    return {};
  }
  bytes_left -= bytes;
  cube ? make_cube(functions, filter, map) : make_flat(functions, packed, filter, map);
  if (is_complete(functions, map)) return map;
  messages.add("the driver cannot draw a shadow map of " + std::to_string(map.size) +
               " texels a side: its shadows are missing");
  return {};
}

}  // namespace

std::vector<ShadowMap> make_shadow_maps(const gl::Functions& functions, const PackedScene& scene,
                                        std::vector<std::vector<MapReader>> readers, Messages& messages,
                                        std::uint64_t bytes_left) {
  std::vector<ShadowMap> maps;
  for (std::uint32_t i = 0; i < readers.size(); ++i) {
    const PackedShadowMap& packed = *scene.shadow_maps()->Get(i);
    const bool of_use = !readers[i].empty();
    ShadowMap& map = maps.emplace_back();
    if (of_use) map = make_shadow_map(functions, scene, packed, packed.size(), bytes_left, messages);
    map.readers = std::move(readers[i]);
    map.only_projects = of_use && !map.texture && packed.method() != PackedShadowMethod::traced;
  }
  return maps;
}

bool is_cube(const PackedScene& scene, const PackedShadowMap& map) {
  return scene.lights()->Get(map.light())->kind() == PackedLightKind::point;
}

bool is_looked_into(const ShadowMap& map, const World& world) {
  return std::ranges::any_of(map.readers, [&world](const MapReader& reader) {
    return world.shape_visible[reader.shape] && world.shape_variant[reader.shape] == reader.variant;
  });
}

std::uint32_t largest_map_size(const PackedScene& scene, std::uint32_t index) {
  const PackedShadowMap& map = *scene.shadow_maps()->Get(index);
  if (keeps_moments(map.method())) return kMaxMomentMapSide;
  return is_cube(scene, map) ? static_cast<std::uint32_t>(kMaxCubeMapSide) : kMaxShadowMapSide;
}

void resize_shadow_map(const gl::Functions& functions, const PackedScene& scene, std::uint32_t index, std::uint32_t size,
                       ShadowMap& map, Messages& messages) {
  const PackedShadowMap& packed = *scene.shadow_maps()->Get(index);
  std::vector<MapReader> readers = std::move(map.readers);
  map = ShadowMap();  // the old one's memory goes first
  std::uint64_t bytes_left = kMaxShadowMapBytes;
  if (!readers.empty()) map = make_shadow_map(functions, scene, packed, size, bytes_left, messages);
  map.readers = std::move(readers);
}

std::int32_t depth_program(const ShapePrograms& use, bool of_point_light) {
  return of_point_light ? use.point_depth_program : use.depth_program;
}

const flatbuffers::Vector<const PackedBinding*>& depth_bindings(const ShapePrograms& use, bool of_point_light) {
  return of_point_light ? *use.point_depth_bindings : *use.depth_bindings;
}

View shifted(const View& view, const ShadowMap& map) {
  if (map.shift == glm::dvec2(0) || view.all_around) return view;
  View moved = view;
  moved.projection = glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * map.shift / double(map.size), 0)) * view.projection;
  return moved;
}

std::vector<std::uint32_t> maps_in_one_frustum(const PackedScene& scene, std::uint32_t index) {
  const PackedShadowMap& map = *scene.shadow_maps()->Get(index);
  if (!map.author_visible()) return {index};
  std::vector<std::uint32_t> maps;
  for (std::uint32_t i = 0; i < scene.shadow_maps()->size(); ++i) {
    const PackedShadowMap& other = *scene.shadow_maps()->Get(i);
    if (other.light() == map.light() && other.author_visible()) maps.push_back(i);
  }
  return maps;
}

FitInput fit_input(const PackedScene& scene, const World& world, std::uint32_t index) {
  const std::vector<std::uint32_t> maps = maps_in_one_frustum(scene, index);
  FitInput input;
  const bool of_point_light = is_cube(scene, *scene.shadow_maps()->Get(index));
  const std::uint32_t shape_count = scene.shapes()->size();
  for (std::uint32_t i = 0; i < shape_count; ++i) {
    if (!world.shape_visible[i]) continue;
    const PackedShape& shape = *scene.shapes()->Get(i);
    const PlacedBox placed{world.object_bounds[i], world.at(shape.transform()).matrix, shape.bounds_known()};
    const ShapePrograms use = shape_programs(shape, world.shape_variant[i]);
    if (depth_program(use, of_point_light) >= 0) input.casters.push_back(placed);
    const bool receives =
        std::ranges::any_of(maps, [&](std::uint32_t map) { return is_seen_from(shape, map, world.shape_variant[i]); });
    if (receives) input.receivers.push_back(placed);
  }
  return input;
}

}  // namespace plugc
