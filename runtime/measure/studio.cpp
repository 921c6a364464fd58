#include "runtime/measure/studio.h"

#include <chrono>
#include <ctime>

#include "runtime/draw_frame.h"
#include "runtime/gl/measuring_target.h"

namespace plugc {
namespace {

double processor_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace

struct Studio::State {
  std::unique_ptr<gl::Context> context;
  gl::Functions gl;
  gl::MeasuringTarget target;
  gl::ColorTarget shown;
  Messages messages;
};

Studio::Studio() : state_(std::make_unique<State>()) {}

Studio::~Studio() {
  if (state_->context != nullptr) state_->context->make_current();
}

std::unique_ptr<Studio> Studio::make(const std::string& cache_folder, std::string& error, bool single_picture) {
  std::unique_ptr<Studio> studio(new Studio());
  State& state = *studio->state_;
  state.context = gl::make_current_context({single_picture, cache_folder}, state.gl, error);
  if (state.context == nullptr) return nullptr;
  return studio;
}

LoadedScene Studio::load(const Package& package) {
  return load_scene(state_->gl, package, *package.scenes()->Get(0), state_->messages);
}

Shot Studio::shoot(LoadedScene& scene, const FrameOptions& options) {
  State& state = *state_;
  const auto width = static_cast<GLsizei>(options.width);
  const auto height = static_cast<GLsizei>(options.height);
  gl::MeasuringTarget& target = state.target;
  if (target.width != width || target.height != height) {
    target = {};  // the old one's memory goes first
    target = gl::make_measuring_target(state.gl, width, height);
  }
  draw_frame(state.gl, scene, {target.framebuffer, width, height, false}, options, state.messages);
  Shot shot{width, height, gl::read_output(state.gl, target, 0), gl::read_output(state.gl, target, 1)};
  for (const std::string& error : gl::take_errors(state.gl)) state.messages.add("OpenGL error " + error);
  return shot;
}

void Studio::resize_map(LoadedScene& scene, std::uint32_t map, std::uint32_t size) {
  if (static_cast<std::uint32_t>(scene.shadow_maps[map].size) == size) return;
  resize_shadow_map(state_->gl, *scene.packed, map, size, scene.shadow_maps[map], state_->messages);
}

FrameTime Studio::time_frame(LoadedScene& scene, const FrameOptions& options, bool draw_maps) {
  State& state = *state_;
  const auto width = static_cast<GLsizei>(options.width);
  const auto height = static_cast<GLsizei>(options.height);
  if (state.shown.width != width || state.shown.height != height) {
    state.shown = {};
    state.shown = gl::make_color_target(state.gl, width, height, 1);
  }
  if (draw_maps) forget_maps(scene);
  state.gl.Finish();
  const auto start = std::chrono::steady_clock::now();
  const double processor_start = processor_milliseconds();
  draw_frame(state.gl, scene, {state.shown.framebuffer, width, height, false}, options, state.messages);
  state.gl.Finish();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(),
          processor_milliseconds() - processor_start};
}

std::vector<std::string> Studio::take_messages() {
  std::vector<std::string> messages = state_->messages.list();
  state_->messages = {};
  return messages;
}

void forget_maps(LoadedScene& scene) {
  for (ShadowMap& map : scene.shadow_maps) {
    map.drawn_revision = 0;
    map.memory = {};
  }
}

}  // namespace plugc
