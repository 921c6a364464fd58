// The picture is copied into a texture; each effect draws over the whole of another target, and the last one over the caller's.

#include "runtime/draw_screen_effects.h"

#include <algorithm>

#include "runtime/gl/pass.h"

namespace plugc {
namespace {

/// Those whose program the driver has taken.
std::vector<const PackedScreenEffect*> effects_that_are_on(LoadedScene& scene, Messages& messages) {
  std::vector<const PackedScreenEffect*> on;
  if (scene.packed->screen_effects() == nullptr) return on;
  for (const PackedScreenEffect* effect : *scene.packed->screen_effects()) {
    const bool is_on = scene.slots.boolean(effect->enabled(), true) && scene.world.at(effect->transform()).visible;
    if (is_on && scene.programs.get(effect->program(), messages).program) on.push_back(effect);
  }
  return on;
}

/// Targets of that size, made anew only where another is asked for. False: the driver cannot give them.
bool prepare_targets(Frame& frame, const FrameTarget& target) {
  ScreenTargets& screen = frame.scene.screen;
  if (screen.width == target.width && screen.height == target.height) return bool(screen.copied);
  screen = {};
  screen.width = target.width;
  screen.height = target.height;
  const gl::TextureSettings texels{PackedWrap::clamp_to_edge, PackedWrap::clamp_to_edge, PackedFilter::nearest,
                                   PackedFilter::nearest, nullptr};  // as the reference engine looks them up, measured
  screen.depth = gl::make_depth_picture(frame.gl, target.width, target.height, texels);
  const gl::Texture no_depth;
  for (int i = 0; i < 2; ++i) {
    screen.colors[i] = gl::make_color_texture(frame.gl, GL_TEXTURE_2D, target.width, target.height, texels);
    screen.framebuffers[i] = gl::make_texture_target(frame.gl, screen.colors[i], no_depth);
  }
  screen.copied = gl::make_texture_target(frame.gl, screen.colors[0], screen.depth);
  const auto is_complete = [&](const gl::Framebuffer& framebuffer) { return gl::is_complete(frame.gl, framebuffer); };
  if (is_complete(screen.copied) && std::ranges::all_of(screen.framebuffers, is_complete)) return true;
  frame.messages.add("the driver cannot draw screen effects at " + std::to_string(target.width) + " by " +
                     std::to_string(target.height));
  screen.copied = {};
  return false;
}

}  // namespace

void draw_screen_effects(Frame& frame, const FrameTarget& target, const SceneView& view) {
  const std::vector<const PackedScreenEffect*> effects = effects_that_are_on(frame.scene, frame.messages);
  if (effects.empty() || !prepare_targets(frame, target)) return;
  ScreenTargets& screen = frame.scene.screen;
  const bool with_depth = std::ranges::any_of(effects, [](const PackedScreenEffect* each) { return each->needs_depth(); });
  gl::copy_target(frame.gl, target.framebuffer, screen.copied, target.width, target.height, with_depth);
  screen.shown = 0;
  Pass pass = color_pass(frame, target, view);
  for (const PackedScreenEffect* effect : effects) {
    const bool last = effect == effects.back();
    const gl::Framebuffer& drawn = last ? target.framebuffer : screen.framebuffers[1 - screen.shown];
    gl::begin_whole_pass(frame.gl, drawn, target.width, target.height);
    draw_over_target(frame.gl, frame.scene, pass, effect->program(), *effect->bindings(), frame.messages);
    ++frame.statistics.screen_passes;
    screen.shown = 1 - screen.shown;
  }
  frame.programs.merge(pass.programs);
}

}  // namespace plugc
