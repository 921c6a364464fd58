// First the scene is drawn with numbers in place of colours, which tells each pixel's triangle. A ray through the pixel cut
// with that triangle's plane is the place from which a second ray goes to the light: so no surface shadows itself by rounding.
// The tree of triangles is built when something has moved; rows of pixels are shared out among threads.

#include "runtime/traced_shadows.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include <glm/gtc/type_ptr.hpp>

#include "runtime/draw_shape.h"
#include "runtime/gl/pass.h"
#include "runtime/gl/texture.h"
#include "runtime/loaded_scene.h"

namespace plugc {
namespace {

constexpr unsigned kMostThreads = 8;
constexpr std::uint8_t kLit = 255;

/// What one light's rays need. Read by all threads.
struct Tracing {
  const TracedShadows& traced;
  const LoadedScene& scene;
  const std::vector<float>& triangles;
  CameraRays rays;
  LightSource light;
  int width = 0;
  int height = 0;
};

bool is_traced(const LoadedScene& scene, std::uint32_t map) {
  return scene.packed->shadow_maps()->Get(map)->method() == PackedShadowMethod::traced;
}

SurfaceKey key_of(const LoadedScene& scene, std::uint32_t index) {
  if (!scene.world.shape_visible[index]) return {};
  const PackedShape& shape = scene.shape(index);
  const LiveMesh* const live = scene.live_meshes.find(shape.mesh());
  return {true, scene.world.at(shape.transform()).matrix, scene.world.shape_variant[index],
          scene.slots.number(shape.alpha_cutoff(), 0), live == nullptr ? 0 : live->version};
}

/// Equal keys, equal geometry.
std::vector<SurfaceKey> surface_keys(const LoadedScene& scene) {
  std::vector<SurfaceKey> keys;
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) keys.push_back(key_of(scene, i));
  return keys;
}

void place_geometry(TracedShadows& traced, const LoadedScene& scene, Messages& messages) {
  std::vector<SurfaceKey> keys = surface_keys(scene);
  if (traced.placed && keys == traced.keys) return;
  traced.keys = std::move(keys);
  traced.placed = true;
  std::vector<Surface> surfaces = read_surfaces(*scene.package, *scene.packed, scene.slots, scene.world, scene.live_meshes);
  std::string error;
  traced.tracer = Tracer::make(surfaces, error);
  if (traced.tracer == nullptr) messages.add("shadows cannot be traced, so all is lit: " + error);
  traced.planes.clear();
  traced.surface_of.assign(scene.shape_count(), -1);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    traced.planes.push_back(world_planes(surfaces[i]));
    traced.surface_of[surfaces[i].shape] = static_cast<std::int32_t>(i);
  }
  traced.surfaces = std::move(surfaces);
}

GLuint alpha_texture(LoadedScene& scene, const Surface& surface, Messages& messages) {
  if (!surface.alpha_test) return scene.resources.stand_in(PackedUniformType::sampler2D).id();
  return scene.resources.texture(surface.alpha_test->texture_index, PackedUniformType::sampler2D, messages).id();
}

void draw_numbers(const gl::Functions& gl, LoadedScene& scene, const View& camera, Messages& messages) {
  const glm::mat4 projection(camera.projection);
  for (const std::uint32_t shape : draw_order(scene, camera)) {
    const std::int32_t index = scene.traced.surface_of[shape];
    if (index < 0 || scene.shape(shape).blended()) continue;
    const Surface& surface = scene.traced.surfaces[static_cast<std::size_t>(index)];
    if (surface.may_move) continue;  // it shows no traced shadow, and would hide what does where it is not
    const glm::mat4 model_view(camera.world_to_eye * surface.to_world);
    gl::TriangleDraw draw{glm::value_ptr(model_view), glm::value_ptr(projection), static_cast<float>(shape), 0, 0, {}};
    draw.alpha_texture = alpha_texture(scene, surface, messages);
    draw.cutoff = surface.alpha_test ? static_cast<float>(surface.alpha_test->cutoff) : 0.0F;
    draw.state = draw_state_of(scene.shape(shape), scene.slots, surface.to_world);
    gl::draw_triangles(gl, scene.traced.pass, scene.resources.mesh(scene.shape(shape).mesh()), draw);
  }
}

std::uint8_t trace_pixel(const Tracing& tracing, int x, int y) {
  const std::size_t at =
      2 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(tracing.width) + static_cast<std::size_t>(x));
  if (tracing.triangles[at] < 0) return kLit;
  const TriangleId id{static_cast<std::uint32_t>(tracing.triangles[at]), static_cast<std::uint32_t>(tracing.triangles[at + 1])};
  const auto surface = static_cast<std::size_t>(tracing.traced.surface_of[id.shape]);
  const std::vector<Plane>& planes = tracing.traced.planes[surface];
  if (id.triangle >= planes.size()) return kLit;  // a float rounds what is beyond 24 bits
  const glm::dvec3 point = tracing.rays.on_plane(x + 0.5, y + 0.5, planes[id.triangle]);
  if (!std::isfinite(point.x + point.y + point.z)) return kLit;
  return tracing.traced.tracer->shadowed(point, id, tracing.light) ? 0 : kLit;
}

std::vector<std::uint8_t> trace_picture(const Tracing& tracing) {
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(tracing.width) * static_cast<std::size_t>(tracing.height));
  const int thread_count = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads));
  const auto trace_rows = [&](int first) {
    for (int y = first; y < tracing.height; y += thread_count) {
      std::uint8_t* const row = mask.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(tracing.width);
      for (int x = 0; x < tracing.width; ++x) row[x] = trace_pixel(tracing, x, y);
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < thread_count; ++i) threads.emplace_back(trace_rows, i);
  trace_rows(0);
  for (std::thread& thread : threads) thread.join();
  return mask;
}

/// Those whose shadow may be seen. None is in use before it is traced.
std::vector<std::uint32_t> maps_to_trace(LoadedScene& scene) {
  std::vector<std::uint32_t> maps;
  for (std::uint32_t i = 0; i < scene.shadow_maps.size(); ++i) {
    if (!is_traced(scene, i)) continue;
    ShadowMap& map = scene.shadow_maps[i];
    map.in_use = false;
    const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(i);
    const bool shows = is_looked_into(map, scene.world) && shadow_shows(packed, *scene.packed, scene.slots, scene.world);
    if (shows) maps.push_back(i);
  }
  return maps;
}

}  // namespace

void trace_shadows(const gl::Functions& gl, LoadedScene& scene, const View& camera, bool clips_depth, GLsizei width,
                   GLsizei height, Messages& messages) {
  const std::vector<std::uint32_t> maps = maps_to_trace(scene);
  if (maps.empty()) return;
  place_geometry(scene.traced, scene, messages);
  if (scene.traced.tracer == nullptr) return;
  if (!gl::begin_triangle_pass(gl, scene.traced.pass, width, height)) {
    messages.add("shadows cannot be traced at " + std::to_string(width) + " by " + std::to_string(height) + ", so all is lit");
    return;
  }
  gl::clip_depth(gl, clips_depth);
  draw_numbers(gl, scene, camera, messages);
  const std::vector<float> triangles = gl::read_triangles(gl, scene.traced.pass);
  for (const std::uint32_t index : maps) {
    const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
    const Tracing tracing{scene.traced,
                          scene,
                          triangles,
                          CameraRays(camera, width, height),
                          light_source(*scene.packed, packed, scene.slots, scene.world),
                          width,
                          height};
    gl::set_mask(gl, scene.shadow_maps[index].texture, width, height, trace_picture(tracing));
    scene.shadow_maps[index].in_use = true;
  }
}

}  // namespace plugc
