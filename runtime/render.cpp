// A frame, top-down: place everything (only when a slot changed), draw the depth maps that are out of date, draw the
// picture with them, read it back. All of a scene's OpenGL objects live in its LoadedScene and die while the context is
// current; the context is a member of State that dies last.

#include "runtime/render.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/draw_shape.h"
#include "runtime/gl/context.h"
#include "runtime/gl/pass.h"
#include "runtime/gl/program.h"
#include "runtime/loaded_scene.h"
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

void draw_shadow_map(const gl::Functions& gl, LoadedScene& scene, std::uint32_t index, std::set<std::uint32_t>& programs,
                     FrameStatistics& statistics, Messages& messages) {
  const PackedShadowMap& packed = *scene.packed->shadow_maps()->Get(index);
  ShadowMap& map = scene.shadow_maps[index];
  map.view = fit_shadow_map(*scene.package, *scene.packed, scene.slots, scene.world, index, messages);
  map.drawn_revision = scene.slots.revision();
  gl::begin_depth_pass(gl, map.framebuffer, map.size, finite_offset(scene.slots.number(packed.scale(), 4)),
                       finite_offset(scene.slots.number(packed.bias(), 4)));
  Pass pass{map.view, true, false, std::vector<View>(scene.shadow_maps.size()), {}};
  std::uint32_t drawn = 0;
  for (const std::uint32_t shape : caster_order(scene, map.view)) drawn += draw_shape(gl, scene, pass, shape, messages) ? 1 : 0;
  statistics.shadow_draw_calls += drawn;
  statistics.shadow_passes += drawn != 0 ? 1 : 0;  // without a caster the map is only cleared
  programs.merge(pass.programs);
}

void draw_shadow_maps(const gl::Functions& gl, LoadedScene& scene, std::set<std::uint32_t>& programs,
                      FrameStatistics& statistics, Messages& messages) {
  for (std::uint32_t i = 0; i < scene.shadow_maps.size(); ++i) {
    if (must_be_fitted(scene.shadow_maps[i], scene.slots)) {
      scene.shadow_maps[i].view = fit_shadow_map(*scene.package, *scene.packed, scene.slots, scene.world, i, messages);
      scene.shadow_maps[i].drawn_revision = scene.slots.revision();
    }
    const PackedShadowUpdate update = scene.packed->shadow_maps()->Get(i)->update();
    if (!must_be_drawn(scene.shadow_maps[i], update, scene.slots, scene.world)) continue;
    draw_shadow_map(gl, scene, i, programs, statistics, messages);
  }
}

void draw_picture(const gl::Functions& gl, LoadedScene& scene, const gl::ColorTarget& target, const FrameOptions& options,
                  std::set<std::uint32_t>& programs, FrameStatistics& statistics, Messages& messages) {
  const double aspect = static_cast<double>(target.width) / target.height;
  const View camera = make_camera(*scene.packed, scene.slots, scene.world, options.viewpoint, aspect, messages);
  Pass pass{camera, false, options.shadows, {}, {}};
  for (const ShadowMap& map : scene.shadow_maps) pass.shadow_views.push_back(map.view);
  gl::begin_color_pass(gl, target.framebuffer, target.width, target.height, background_of(scene));
  for (const std::uint32_t shape : draw_order(scene, camera)) {
    statistics.draw_calls += draw_shape(gl, scene, pass, shape, messages) ? 1 : 0;
  }
  programs.merge(pass.programs);
}

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

/// What must not wait for the first frame: programs (their messages belong to loading) and geometry.
void upload(LoadedScene& scene, Messages& messages) {
  for (std::uint32_t i = 0; i < scene.shape_count(); ++i) {
    const PackedShape& shape = scene.shape(i);
    scene.resources.mesh(shape.mesh());
    for (std::uint32_t variant = 0; variant <= shape.variants()->size(); ++variant) {
      const ShapePrograms use = shape_programs(shape, static_cast<std::uint8_t>(variant));
      scene.programs.get(use.program, messages);
      if (use.depth_program >= 0) scene.programs.get(static_cast<std::uint32_t>(use.depth_program), messages);
    }
  }
}

}  // namespace

Renderer::Renderer() : state_(std::make_unique<State>()) {}

Renderer::~Renderer() {
  state_->context->make_current();
}

std::unique_ptr<Renderer> Renderer::make(const RendererOptions& options, std::string& error) {
  std::unique_ptr<gl::Context> context = gl::make_context({options.single_picture, options.cache_folder}, error);
  if (context == nullptr) return nullptr;
  gl::Functions functions;
  if (!context->make_current()) {
    error = "the OpenGL context cannot be made current";
    return nullptr;
  }
  if (!gl::load_functions(*context, functions, error)) return nullptr;
  std::unique_ptr<Renderer> renderer(new Renderer());
  renderer->state_->context = std::move(context);
  renderer->state_->gl = functions;
  gl::set_context_defaults(renderer->state_->gl);
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
  state.scene = LoadedScene{&package,
                            &packed,
                            Slots(packed),
                            {},
                            0,
                            ProgramPool(state.gl, package),
                            ResourcePool(state.gl, package),
                            make_shadow_maps(state.gl, packed, state.messages)};
  upload(state.scene, state.messages);
  report_gl_errors(state.gl, "loading", state.messages);
  return true;
}

void Renderer::set_slot(std::uint32_t slot, const std::vector<double>& values) {
  if (state_->scene.slots.set(slot, values)) return;
  state_->messages.add("slot " + std::to_string(slot) + " does not hold " + std::to_string(values.size()) +
                       " values: it keeps what it had");
}

bool Renderer::set_field(std::string_view name, const std::vector<double>& values, std::string& error) {
  LoadedScene& scene = state_->scene;
  bool found = false;
  if (scene.packed != nullptr) {
    for (const PackedSlotName* slot : *scene.packed->slot_names()) {
      if (slot->name()->string_view() != name || !slot->dynamic()) continue;
      found = true;
      if (scene.slots.set(slot->slot(), values)) continue;
      error = "`" + std::string(name) + "` holds " + std::to_string(scene.slots.values(slot->slot()).size()) +
              " numbers, not " + std::to_string(values.size());
      return false;
    }
  }
  if (!found)
    error = "the package does not let a host change `" + std::string(name) + "`: build it with `--dynamic " +
            std::string(name) + "`";
  return found;
}

Picture Renderer::draw(const FrameOptions& options) {
  State& state = *state_;
  state.statistics = {};
  if (state.scene.packed == nullptr) return {};
  state.context->make_current();
  if (!prepare_target(state.gl, state.target, options, state.messages)) return {};
  place_scene(state.scene);
  std::set<std::uint32_t> programs;
  if (options.shadows) draw_shadow_maps(state.gl, state.scene, programs, state.statistics, state.messages);
  draw_picture(state.gl, state.scene, state.target, options, programs, state.statistics, state.messages);
  state.statistics.programs_used = static_cast<std::uint32_t>(programs.size());
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
