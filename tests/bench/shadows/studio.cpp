// OpenGL functions that the runtime itself does not call are asked for by name.

#include "shadows/studio.h"

#include <array>
#include <chrono>
#include <ctime>

#include "runtime/draw_frame.h"
#include "runtime/gl/pass.h"

namespace plugc {
namespace {

struct MeasuringTarget {
  gl::Framebuffer framebuffer;
  gl::Renderbuffer color;
  gl::Renderbuffer triangle;
  gl::Renderbuffer depth;
  GLsizei width = 0;
  GLsizei height = 0;
};

gl::Renderbuffer attach(const gl::Functions& gl, GLenum attachment, GLenum format, GLsizei width, GLsizei height) {
  gl::Renderbuffer buffer = gl::generate<gl::Renderbuffer>(gl, gl.GenRenderbuffers);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
  return buffer;
}

std::vector<glm::vec4> read_floats(const gl::Functions& gl, GLenum attachment, GLsizei width, GLsizei height) {
  std::vector<glm::vec4> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  gl.ReadBuffer(attachment);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, values.data());
  return values;
}

double processor_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace

struct Studio::State {
  std::unique_ptr<gl::Context> context;
  gl::Functions gl;
  PFNGLDRAWBUFFERSPROC draw_buffers = nullptr;
  PFNGLFINISHPROC finish = nullptr;
  MeasuringTarget target;
  gl::ColorTarget shown;
  Messages messages;
};

Studio::Studio() : state_(std::make_unique<State>()) {}

Studio::~Studio() {
  if (state_->context != nullptr) state_->context->make_current();
}

std::unique_ptr<Studio> Studio::make(const std::string& cache_folder, std::string& error) {
  std::unique_ptr<Studio> studio(new Studio());
  State& state = *studio->state_;
  state.context = gl::make_context({false, cache_folder}, error);
  if (state.context == nullptr || !state.context->make_current()) return nullptr;
  if (!gl::load_functions(*state.context, state.gl, error)) return nullptr;
  state.draw_buffers = reinterpret_cast<PFNGLDRAWBUFFERSPROC>(state.context->function("glDrawBuffers"));
  state.finish = reinterpret_cast<PFNGLFINISHPROC>(state.context->function("glFinish"));
  gl::set_context_defaults(state.gl);
  return studio;
}

LoadedScene Studio::load(const Package& package) {
  return load_scene(state_->gl, package, *package.scenes()->Get(0), state_->messages);
}

Shot Studio::shoot(LoadedScene& scene, const FrameOptions& options) {
  State& state = *state_;
  const auto width = static_cast<GLsizei>(options.width);
  const auto height = static_cast<GLsizei>(options.height);
  MeasuringTarget& target = state.target;
  if (target.width != width || target.height != height) {
    target = {};
    target.framebuffer = gl::generate<gl::Framebuffer>(state.gl, state.gl.GenFramebuffers);
    state.gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    target.color = attach(state.gl, GL_COLOR_ATTACHMENT0, GL_RGBA32F, width, height);
    target.triangle = attach(state.gl, GL_COLOR_ATTACHMENT1, GL_RGBA32F, width, height);
    target.depth = attach(state.gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height);
    constexpr std::array<GLenum, 2> both = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    state.draw_buffers(2, both.data());
    target.width = width;
    target.height = height;
  }
  draw_frame(state.gl, scene, {target.framebuffer, width, height}, options, state.messages);
  state.gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
  Shot shot{width, height, read_floats(state.gl, GL_COLOR_ATTACHMENT0, width, height),
            read_floats(state.gl, GL_COLOR_ATTACHMENT1, width, height)};
  for (const std::string& error : gl::take_errors(state.gl)) state.messages.add("OpenGL error " + error);
  return shot;
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
  state.finish();
  const auto start = std::chrono::steady_clock::now();
  const double processor_start = processor_milliseconds();
  draw_frame(state.gl, scene, {state.shown.framebuffer, width, height}, options, state.messages);
  state.finish();
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
