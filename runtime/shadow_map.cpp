// Textures are made once, with the scene.

#include "runtime/shadow_map.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "base/limits.h"

namespace plugc {
namespace {

GLsizei usable_size(std::uint32_t wanted, GLsizei largest, Messages& messages) {
  const auto limit = std::min(kMaxShadowMapSide, static_cast<std::uint32_t>(largest));
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
  return std::any_of(bindings.begin(), bindings.end(), [map](const PackedBinding* binding) {
    const bool of_map = binding->source() == PackedSource::shadow_map || binding->source() == PackedSource::shadow_moments ||
                        binding->source() == PackedSource::projector_matrix;
    return of_map && binding->a() == map;
  });
}

/// Shapes that are seen from the light: shadowed by it, or with texture coordinates that it projects.
bool is_seen_from(const PackedShape& shape, std::uint32_t map, std::uint8_t variant) {
  return receives(shape, map) || reads(*shape_programs(shape, variant).bindings, map);
}

std::vector<MapReader> find_readers(const PackedScene& scene, std::uint32_t map) {
  std::vector<MapReader> readers;
  const std::uint32_t shape_count = scene.shapes()->size();
  for (std::uint32_t i = 0; i < shape_count; ++i) {
    const PackedShape& shape = *scene.shapes()->Get(i);
    for (std::uint32_t variant = 0; variant <= shape.variants()->size(); ++variant) {
      const auto number = static_cast<std::uint8_t>(variant);
      if (reads(*shape_programs(shape, number).bindings, map)) readers.push_back({i, number});
    }
  }
  return readers;
}

void add_moments(const gl::Functions& functions, PackedShadowMethod method, ShadowMap& map) {
  const bool two = method == PackedShadowMethod::vsm;
  map.unblurred = gl::make_float_texture(functions, map.size, two);
  map.unblurred_target = gl::make_float_target(functions, map.unblurred);
  map.moments = gl::make_float_texture(functions, map.size, two);
  map.moments_target = gl::make_float_target(functions, map.moments);
}

ShadowMap make_shadow_map(const gl::Functions& functions, const PackedShadowMap& packed, const PackedLight& light,
                          Messages& messages) {
  ShadowMap map;
  if (packed.update() == PackedShadowUpdate::none) return map;
  if (light.kind() == PackedLightKind::point) {
    messages.add("point lights cast no shadows yet: what the light `" + light.name()->str() + "` reaches stays lit");
    return map;
  }
  map.size = usable_size(packed.size(), gl::max_target_side(functions), messages);
  map.reversed = !packed.author_visible() && functions.ClipControl != nullptr;
  const GLint filter = packed.method() == PackedShadowMethod::hard ? GL_NEAREST : GL_LINEAR;
  map.texture = gl::make_depth_texture(functions, GL_TEXTURE_2D, map.size, map.reversed, filter);
  map.framebuffer = gl::make_depth_target(functions, map.texture);
  if (keeps_moments(packed.method())) add_moments(functions, packed.method(), map);
  return map;
}

}  // namespace

std::vector<ShadowMap> make_shadow_maps(const gl::Functions& functions, const PackedScene& scene, Messages& messages) {
  std::vector<ShadowMap> maps;
  const std::uint32_t count = scene.shadow_maps()->size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const PackedShadowMap& packed = *scene.shadow_maps()->Get(i);
    maps.push_back(make_shadow_map(functions, packed, *scene.lights()->Get(packed.light()), messages));
    maps.back().readers = find_readers(scene, i);
    maps.back().only_projects = packed.update() == PackedShadowUpdate::none && !maps.back().readers.empty();
  }
  return maps;
}

bool casts(const PackedScene& scene, const World& world, std::uint32_t shape) {
  return world.shape_visible[shape] &&
         shape_programs(*scene.shapes()->Get(shape), world.shape_variant[shape]).depth_program >= 0;
}

View shifted(const View& view, const ShadowMap& map) {
  if (map.shift == glm::dvec2(0)) return view;
  View moved = view;
  moved.projection = glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * map.shift / double(map.size), 0)) * view.projection;
  return moved;
}

FitInput fit_input(const Package& package, const PackedScene& scene, const World& world, std::uint32_t index) {
  FitInput input;
  const std::uint32_t shape_count = scene.shapes()->size();
  for (std::uint32_t i = 0; i < shape_count; ++i) {
    if (!world.shape_visible[i]) continue;
    const PackedShape& shape = *scene.shapes()->Get(i);
    const PlacedBox placed{mesh_bounds(*package.meshes()->Get(shape.mesh())), world.at(shape.transform()).matrix,
                           shape.bounds_known()};
    if (casts(scene, world, i)) input.casters.push_back(placed);
    if (is_seen_from(shape, index, world.shape_variant[i])) input.receivers.push_back(placed);
  }
  return input;
}

}  // namespace plugc
