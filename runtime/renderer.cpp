// The door of the runtime: a context, one scene on it, pictures of it. All of a scene's OpenGL objects live in its
// LoadedScene and die while the context is current; the context is a member of State that dies last.

#include "runtime/render.h"

#include <algorithm>

#include "runtime/draw_frame.h"
#include "runtime/gl/context.h"
#include "runtime/gl/program.h"
#include "runtime/readback.h"

namespace plugc {

struct Renderer::State {
  std::unique_ptr<gl::Context> context;
  gl::Functions gl;
  gl::ColorTarget target;
  LoadedScene scene;
  Messages messages;
  FrameStatistics statistics;
};

namespace {

/// The target in that size, remade only when the size changes. Sides are at least 1 and at most what the driver has.
bool prepare_target(const gl::Functions& gl, gl::ColorTarget& target, const FrameOptions& options, Messages& messages) {
  const auto largest = static_cast<std::uint32_t>(gl::max_target_side(gl));
  const auto width = static_cast<GLsizei>(std::clamp(options.width, 1U, largest));
  const auto height = static_cast<GLsizei>(std::clamp(options.height, 1U, largest));
  if (options.width > largest || options.height > largest) {
    messages.add("the driver draws pictures of at most " + std::to_string(largest) + " pixels along a side");
  }
  const auto samples = static_cast<GLsizei>(std::clamp(options.samples, 1U, 4U));
  if (target.framebuffer && target.width == width && target.height == height && target.samples == samples) return true;
  target = {};
  target = gl::make_color_target(gl, width, height, samples);
  if (target.framebuffer) return true;
  messages.add("the driver cannot draw a picture of " + std::to_string(width) + " by " + std::to_string(height));
  return false;
}

void report_gl_errors(const gl::Functions& functions, const char* during, Messages& messages) {
  for (const std::string& error : gl::take_errors(functions)) messages.add("OpenGL error " + error + " while " + during);
}

/// Those of the field in every node of that name.
std::vector<std::uint32_t> dynamic_slots(const LoadedScene& scene, std::string_view name) {
  std::vector<std::uint32_t> slots;
  if (scene.packed == nullptr) return slots;
  for (const PackedSlotName* slot : *scene.packed->slot_names()) {
    if (slot->dynamic() && slot->name()->string_view() == name) slots.push_back(slot->slot());
  }
  return slots;
}

}  // namespace

Renderer::Renderer() : state_(std::make_unique<State>()) {}

Renderer::~Renderer() {
  state_->context->make_current();
}

std::unique_ptr<Renderer> Renderer::make(const RendererOptions& options, std::string& error) {
  gl::Functions functions;
  auto context = gl::make_current_context({options.single_picture, options.cache_folder}, functions, error);
  if (context == nullptr) return nullptr;
  std::unique_ptr<Renderer> renderer(new Renderer());
  renderer->state_->context = std::move(context);
  renderer->state_->gl = functions;
  gl::warm_up_compiler(renderer->state_->gl);  // here, as the package is often still being made
  return renderer;
}

bool Renderer::load(const Package& package, std::uint32_t scene, std::string& error) {
  State& state = *state_;
  if (scene >= package.scenes()->size()) {
    error = "the package has no scene " + std::to_string(scene);
    return false;
  }
  state.context->make_current();
  const PackedScene& packed = *package.scenes()->Get(scene);
  state.scene = load_scene(state.gl, package, packed, state.messages);
  report_gl_errors(state.gl, "loading", state.messages);
  return true;
}

void Renderer::set_slot(std::uint32_t slot, const std::vector<double>& values) {
  if (send_from_outside(state_->scene.events, state_->scene.slots, slot, values)) return;
  state_->messages.add("slot " + std::to_string(slot) + " does not hold " + std::to_string(values.size()) +
                       " values: it keeps what it had");
}

bool Renderer::set_field(std::string_view name, const std::vector<double>& values, std::string& error) {
  LoadedScene& scene = state_->scene;
  const std::vector<std::uint32_t> slots = dynamic_slots(scene, name);
  if (slots.empty()) {
    error = "the package does not let a host change `" + std::string(name) + "`: build it with `--dynamic " +
            std::string(name) + "`";
    return false;
  }
  for (const std::uint32_t slot : slots) {
    const std::size_t size = scene.slots.values(slot).size();
    if (size == values.size()) continue;
    error = "`" + std::string(name) + "` holds " + std::to_string(size) + " numbers, not " + std::to_string(values.size());
    return false;
  }
  for (const std::uint32_t slot : slots) send_from_outside(scene.events, scene.slots, slot, values);
  return true;
}

std::vector<double> Renderer::field(std::string_view name) const {
  const LoadedScene& scene = state_->scene;
  if (scene.packed == nullptr) return {};
  for (const PackedSlotName* slot : *scene.packed->slot_names()) {
    if (slot->name()->string_view() != name) continue;
    const std::span<const double> values = scene.slots.values(slot->slot());
    return {values.begin(), values.end()};
  }
  return {};
}

Picture Renderer::draw(const FrameOptions& options) {
  State& state = *state_;
  state.statistics = {};
  if (state.scene.packed == nullptr) return {};
  state.context->make_current();
  if (!prepare_target(state.gl, state.target, options, state.messages)) return {};
  const FrameTarget target{state.target.framebuffer, state.target.width, state.target.height};
  state.statistics = draw_frame(state.gl, state.scene, target, options, state.messages);
  Picture picture = read_back(state.gl, state.target);
  report_gl_errors(state.gl, "drawing", state.messages);
  return picture;
}

const FrameStatistics& Renderer::statistics() const {
  return state_->statistics;
}

const std::vector<std::string>& Renderer::messages() const {
  return state_->messages.list();
}

}  // namespace plugc
