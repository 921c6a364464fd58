// A frame, top-down: let happen what happens until then and place everything (only when a slot changed), draw the textures that
// are out of date, draw the picture, and let the screen effects change it.

#include "runtime/draw_frame.h"
#include "runtime/draw_rendered_textures.h"
#include "runtime/draw_screen_effects.h"
#include "runtime/draw_view.h"
#include "runtime/place_scene.h"
#include "runtime/scene_time.h"
#include "runtime/script_node.h"

namespace plugc {
namespace {

View look(Frame& frame, const FrameTarget& target) {
  const double aspect = static_cast<double>(target.width) / target.height;
  const LoadedScene& scene = frame.scene;
  return make_camera(*scene.packed, scene.slots, scene.world, frame.options.viewpoint, aspect, frame.messages);
}

SceneView picture_view(Frame& frame, const FrameTarget& target) {
  LoadedScene& scene = frame.scene;
  SceneView view;
  look_through(scene, settled_camera(scene, [&] { return look(frame, target); }), view);
  view.shadow_camera = view.camera;
  view.viewpoint = bound_viewpoint(*scene.packed, scene.slots, frame.options.viewpoint);
  view.background_color = scene.packed->background_color();
  return view;
}

}  // namespace

FrameStatistics draw_frame(const gl::Functions& gl, LoadedScene& scene, const FrameTarget& target, const FrameOptions& options,
                           Messages& messages) {
  Frame frame{gl, scene, messages, options};
  reach_time(scene, options.time, options.viewpoint, [&] { return look(frame, target); });
  report_scripts(*scene.package, *scene.packed, scene.events.memory, messages);
  if (!scene.rendered_textures.empty()) {
    frame.viewer = picture_view(frame, target).camera;
    draw_rendered_textures(frame);
    place_scene(scene);
  }
  const SceneView view = picture_view(frame, target);
  draw_view(frame, target, view);
  if (target.screen_effects) draw_screen_effects(frame, target, view);
  frame.statistics.programs_used = static_cast<std::uint32_t>(frame.programs.size());
  return frame.statistics;
}

}  // namespace plugc
