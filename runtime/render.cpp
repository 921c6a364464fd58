// A frame, top-down: place everything (only when a slot changed), draw the depth maps that are out of date, draw the
// picture with them.

#include "runtime/draw_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/draw_shape.h"
#include "runtime/gl/pass.h"
#include "runtime/update_shadow_map.h"

namespace plugc {
namespace {

/// glPolygonOffset takes any float but NaN and infinity.
float finite_offset(double value) {
  return std::isfinite(value) ? static_cast<float>(std::clamp(value, -1e6, 1e6)) : 0.0F;
}

std::array<float, 3> background_of(const LoadedScene& scene) {
  const glm::dvec3 color = scene.slots.vector3(scene.packed->background_color(), glm::dvec3(0));
  std::array<float, 3> result{};
  for (int i = 0; i < 3; ++i) {
    result[static_cast<std::size_t>(i)] = color[i] >= 0 ? static_cast<float>(std::min(color[i], 1.0)) : 0.0F;
  }
  return result;
}

void place_scene(LoadedScene& scene) {
  if (scene.placed_revision == scene.slots.revision()) return;
  scene.world = place(*scene.package, *scene.packed, scene.slots);
  scene.placed_revision = scene.slots.revision();
}

/// Turns the map's depths into moments, and blurs them along rows and then along columns.
void make_moments(const gl::Functions& gl, LoadedScene& scene, std::uint32_t index, Pass& pass, FrameStatistics& statistics,
                  Messages& messages) {
  const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
  const ShadowMap& map = scene.shadow_maps[index];
  if (!map.moments) return;
  gl::begin_whole_pass(gl, map.unblurred_target, map.size);
  draw_over_map(gl, scene, pass, static_cast<std::uint32_t>(packed.moments_program()), *packed.moments_bindings(), messages);
  gl::begin_whole_pass(gl, map.moments_target, map.size);
  draw_over_map(gl, scene, pass, static_cast<std::uint32_t>(packed.blur_program()), *packed.blur_bindings(), messages);
  statistics.shadow_filter_passes += 2;
}

void draw_shadow_map(const gl::Functions& gl, LoadedScene& scene, std::uint32_t index, std::set<std::uint32_t>& programs,
                     FrameStatistics& statistics, Messages& messages) {
  const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
  const ShadowMap& map = scene.shadow_maps[index];
  gl::begin_depth_pass(gl, map.framebuffer, map.size, finite_offset(scene.slots.number(packed.scale(), 4)),
                       finite_offset(scene.slots.number(packed.bias(), 4) * map.fit.coarseness), map.reversed);
  Pass pass{map.view, true, false, std::vector<View>(scene.shadow_maps.size()), {}};
  std::uint32_t drawn = 0;
  for (const std::uint32_t shape : caster_order(scene, map.view)) drawn += draw_shape(gl, scene, pass, shape, messages) ? 1 : 0;
  make_moments(gl, scene, index, pass, statistics, messages);
  statistics.shadow_draw_calls += drawn;
  statistics.shadow_passes += drawn != 0 ? 1 : 0;  // without a caster the map is only cleared
  programs.merge(pass.programs);
}

void draw_shadow_maps(const gl::Functions& gl, LoadedScene& scene, const View& camera, std::set<std::uint32_t>& programs,
                      FrameStatistics& statistics, Messages& messages) {
  for (std::uint32_t i = 0; i < scene.shadow_maps.size(); ++i) {
    if (update_shadow_map(scene, i, camera, messages)) draw_shadow_map(gl, scene, i, programs, statistics, messages);
  }
}

void draw_picture(const gl::Functions& gl, LoadedScene& scene, const FrameTarget& target, const View& camera, bool shadows,
                  std::set<std::uint32_t>& programs, FrameStatistics& statistics, Messages& messages) {
  Pass pass{camera, false, shadows, {}, {}};
  for (const ShadowMap& map : scene.shadow_maps) {
    pass.shadow_views.push_back(map.view);
    if (!shadows || !map.in_use)
      pass.shadow_views.back().near = pass.shadow_views.back().far = 0;  // depth 0: before all moments
  }
  gl::begin_color_pass(gl, target.framebuffer, target.width, target.height, background_of(scene));
  for (const std::uint32_t shape : draw_order(scene, camera)) {
    statistics.draw_calls += draw_shape(gl, scene, pass, shape, messages) ? 1 : 0;
  }
  programs.merge(pass.programs);
}

}  // namespace

FrameStatistics draw_frame(const gl::Functions& gl, LoadedScene& scene, const FrameTarget& target, const FrameOptions& options,
                           Messages& messages) {
  FrameStatistics statistics;
  place_scene(scene);
  std::set<std::uint32_t> programs;
  const double aspect = static_cast<double>(target.width) / target.height;
  const View camera = make_camera(*scene.packed, scene.slots, scene.world, options.viewpoint, aspect, messages);
  if (options.shadows) draw_shadow_maps(gl, scene, camera, programs, statistics, messages);
  draw_picture(gl, scene, target, camera, options.shadows, programs, statistics, messages);
  statistics.programs_used = static_cast<std::uint32_t>(programs.size());
  return statistics;
}

}  // namespace plugc
