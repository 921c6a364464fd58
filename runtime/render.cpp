// A frame, top-down: place everything (only when a slot changed), draw the depth maps that are out of date, draw the
// picture with them.

#include "runtime/draw_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/backdrop.h"
#include "runtime/cube_map.h"
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
  scene.placed_for.reset();
}

/// Turns what has to face the viewer, and chooses levels of detail. True where something may stand elsewhere now, the camera
/// too.
bool place_for_viewer(LoadedScene& scene, const View& camera) {
  if (!depends_on_viewer(*scene.packed)) return false;
  const Viewer viewer{glm::dvec3(camera.eye_to_world[3]), glm::dvec3(camera.eye_to_world[1]),
                      glm::dvec3(camera.eye_to_world[2])};
  if (scene.placed_for == viewer) return false;
  scene.world = place(*scene.package, *scene.packed, scene.slots, &viewer);
  scene.placed_for = viewer;
  return true;
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

/// The casters that the pass sees, into the depth target that is bound.
void draw_casters(const gl::Functions& gl, LoadedScene& scene, Pass& pass, std::set<std::uint32_t>& programs,
                  FrameStatistics& statistics, Messages& messages) {
  std::uint32_t drawn = 0;
  for (const std::uint32_t shape : caster_order(scene, pass.view, pass.of_point_light))
    drawn += draw_shape(gl, scene, pass, shape, messages) ? 1 : 0;
  statistics.shadow_draw_calls += drawn;
  statistics.shadow_passes += drawn != 0 ? 1 : 0;  // without a caster the map is only cleared
  programs.merge(pass.programs);
}

/// The six faces of a point light's map; one that nobody looks into is only cleared.
void draw_cube_map(const gl::Functions& gl, LoadedScene& scene, std::uint32_t index, const glm::vec2& offset,
                   std::set<std::uint32_t>& programs, FrameStatistics& statistics, Messages& messages) {
  const ShadowMap& map = scene.shadow_maps[index];
  for (unsigned face = 0; face < kCubeFaceCount; ++face) {
    gl::begin_depth_pass(gl, map.faces[face], map.size, 0, 0, false);
    if (std::ranges::find(map.read_faces, face) == map.read_faces.end()) continue;
    const View view = cube_face(map.view, face);
    Pass pass{view, true, false, std::vector<View>(scene.shadow_maps.size()), {}};
    pass.of_point_light = true;
    pass.depth_range = depth_pass_range(map.view, double(offset.x), double(offset.y));
    draw_casters(gl, scene, pass, programs, statistics, messages);
  }
}

void draw_shadow_map(const gl::Functions& gl, LoadedScene& scene, std::uint32_t index, std::set<std::uint32_t>& programs,
                     FrameStatistics& statistics, Messages& messages) {
  const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
  const ShadowMap& map = scene.shadow_maps[index];
  const glm::vec2 offset(finite_offset(scene.slots.number(packed.scale(), 4)),
                         finite_offset(scene.slots.number(packed.bias(), 4) * map.fit.coarseness));
  if (map.view.all_around) return draw_cube_map(gl, scene, index, offset, programs, statistics, messages);
  gl::begin_depth_pass(gl, map.framebuffer, map.size, offset.x, offset.y, map.reversed);
  Pass pass{map.view, true, false, std::vector<View>(scene.shadow_maps.size()), {}};
  draw_casters(gl, scene, pass, programs, statistics, messages);
  make_moments(gl, scene, index, pass, statistics, messages);
}

void draw_shadow_maps(const gl::Functions& gl, LoadedScene& scene, const View& camera, std::set<std::uint32_t>& programs,
                      FrameStatistics& statistics, Messages& messages) {
  for (std::uint32_t i = 0; i < scene.shadow_maps.size(); ++i) {
    if (update_shadow_map(scene, i, camera, messages)) draw_shadow_map(gl, scene, i, programs, statistics, messages);
  }
}

struct Camera {
  View view;
  std::int32_t viewpoint = -1;  // as bound_viewpoint() says
};

void draw_picture(const gl::Functions& gl, LoadedScene& scene, const FrameTarget& target, const Camera& camera, bool shadows,
                  std::set<std::uint32_t>& programs, FrameStatistics& statistics, Messages& messages) {
  Pass pass{camera.view, false, shadows, {}, {}};
  for (const ShadowMap& map : scene.shadow_maps) {
    pass.shadow_views.push_back(map.view);
    if (!shadows || !map.in_use)
      pass.shadow_views.back().near = pass.shadow_views.back().far = 0;  // depth 0: before all moments
  }
  pass.bound_viewpoint = camera.viewpoint;
  pass.target_size = {target.width, target.height};
  gl::begin_color_pass(gl, target.framebuffer, target.width, target.height, background_of(scene));
  statistics.draw_calls += draw_backdrop(gl, scene, pass, messages);
  for (const std::uint32_t shape : draw_order(scene, camera.view)) {
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
  const auto look = [&] { return make_camera(*scene.packed, scene.slots, scene.world, options.viewpoint, aspect, messages); };
  Camera camera{look(), bound_viewpoint(*scene.packed, options.viewpoint)};
  if (place_for_viewer(scene, camera.view)) camera.view = look();
  if (options.shadows) {
    draw_shadow_maps(gl, scene, camera.view, programs, statistics, messages);
    trace_shadows(gl, scene, camera.view, target.width, target.height, messages);
  }
  draw_picture(gl, scene, target, camera, options.shadows, programs, statistics, messages);
  statistics.programs_used = static_cast<std::uint32_t>(programs.size());
  return statistics;
}

}  // namespace plugc
