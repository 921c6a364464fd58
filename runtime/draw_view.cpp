#include "runtime/draw_view.h"

#include <algorithm>
#include <array>

#include "runtime/backdrop.h"
#include "runtime/draw_shadow_maps.h"
#include "runtime/gl/pass.h"
#include "runtime/sight_limit.h"

namespace plugc {
namespace {

std::array<float, 3> background_of(const LoadedScene& scene, std::uint32_t slot) {
  const glm::dvec3 color = scene.slots.vector3(slot, glm::dvec3(0));
  std::array<float, 3> result{};
  for (int i = 0; i < 3; ++i) {
    result[static_cast<std::size_t>(i)] = color[i] >= 0 ? static_cast<float>(std::min(color[i], 1.0)) : 0.0F;
  }
  return result;
}

}  // namespace

void look_through(const LoadedScene& scene, const View& camera, SceneView& view) {
  view.camera = camera;
  const bool in_world = scene.placed_scene < 0;  // a texture's own scene has no viewer
  view.clips_depth = in_world && limit_sight(view.camera, sight_limit(*scene.packed, scene.slots));
}

Pass color_pass(const Frame& frame, const FrameTarget& target, const SceneView& view) {
  Pass pass{.view = view.camera, .shadows = frame.options.shadows};
  for (const ShadowMap& map : frame.scene.shadow_maps) {
    pass.shadow_views.push_back(map.view);
    if (!frame.options.shadows || !map.in_use)
      pass.shadow_views.back().near = pass.shadow_views.back().far = 0;  // depth 0: before all moments
  }
  pass.bound_viewpoint = view.viewpoint;
  pass.wearer = view.wearer;
  pass.target_size = {target.width, target.height};
  return pass;
}

void draw_view(Frame& frame, const FrameTarget& target, const SceneView& view) {
  for (const LiveMesh& live : frame.scene.live_meshes.list) frame.scene.resources.rewrite_mesh(live);
  if (frame.options.shadows) {
    draw_shadow_maps(frame, view.shadow_camera);
    trace_shadows(frame.gl, frame.scene, view.camera, view.clips_depth, target.width, target.height, frame.messages);
  }
  Pass pass = color_pass(frame, target, view);
  gl::begin_color_pass(frame.gl, target.framebuffer, target.width, target.height,
                       background_of(frame.scene, view.background_color));
  frame.statistics.draw_calls += draw_backdrop(frame.gl, frame.scene, pass, view.backdrop_of, frame.messages);
  if (view.clips_depth) gl::clip_depth(frame.gl, true);
  for (const std::uint32_t shape : draw_order(frame.scene, view.camera)) {
    if (static_cast<std::int32_t>(shape) == view.without_shape) continue;
    frame.statistics.draw_calls += draw_shape(frame.gl, frame.scene, pass, shape, frame.messages) ? 1 : 0;
  }
  frame.programs.merge(pass.programs);
}

}  // namespace plugc
