// The walk, and what can be said only when all is visited: which global lights shine, which fog and background are bound.

#include "scene/library_effects.h"
#include "scene/scene_events.h"
#include "scene/scene_walk.h"

namespace plugc {
namespace {

/// Without a Background the standard leaves the colour to the browser: the dark grey of the reference engine's viewer,
/// measured.
constexpr double kDefaultSky = 26.0 / 255.0;

/// The reference engine adds this much of each material's ambient colour (OpenGL's default light model), measured.
constexpr double kGlobalAmbient = 0.2;

/// A host may write what it has announced, even where nothing of the scene reads it.
void add_dynamic_slots(SceneContext& context) {
  for (const DynamicField& field : context.dynamic) context.slots.declared_slot(field.node, field.name);
}

bool limits_sight(const SceneContext& context, NodeId navigation_info) {
  return context.graph.number(navigation_info, "visibilityLimit") > 0 ||
         context.slots.may_change(navigation_info, "visibilityLimit");
}

}  // namespace

void SceneWalk::run() {
  const bool alone = context_.options.alone.valid();
  const std::vector<NodeId> stage = alone ? library_stage_roots(graph_) : std::vector<NodeId>();
  const std::span<const NodeId> roots = alone ? std::span<const NodeId>(stage) : graph_.roots();
  check_top(roots);
  visit_list(roots);
  if (navigation_info_.valid() && limits_sight(context_, navigation_info_))
    context_.scene.visibility_limit = context_.slots.slot(navigation_info_, "visibilityLimit");
  add_background();
  if (context_.options.all_branches) add_unreached_effects();
  finish_shapes(0);
  context_.scene.global_ambient = context_.slots.constant(SlotType::vec3, {kGlobalAmbient, kGlobalAmbient, kGlobalAmbient});
  if (!background_.valid())
    context_.scene.background_color = context_.slots.constant(SlotType::vec3, {kDefaultSky, kDefaultSky, kDefaultSky});
  visit_own_scenes();
  sort_rendered_textures(context_);
  finish_lights(context_, appearances_);
  finish_projections(context_);
  if (alone) place_alone(context_);
}

/// Its shapes stand behind those of the world.
void SceneWalk::add_background() {
  if (background_.valid()) add_backdrop(context_, background_, background_transform_);
  appearances_.resize(context_.scene.shapes.size());
}

/// Effects that no shape shows (in an unused prototype, say) are tried on a copy of the first shape.
void SceneWalk::add_unreached_effects() {
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    const NodeId node{i};
    if (graph_.is(node, "ScreenEffect") && !context_.screen_effects.contains(node)) add_screen_effect(context_, node, -1);
  }
  if (!has_world_shapes(context_.scene)) return;
  const SceneShape bare = [&] {
    SceneShape shape = context_.scene.shapes.front();
    shape.effects.clear();
    shape.shader = -1;
    return shape;
  }();
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    const NodeId node{i};
    if (!graph_.is(node, "Effect") || context_.effects.contains(node)) continue;
    const int effect = effect_index(context_, node);
    if (effect < 0) continue;
    SceneShape shape = bare;
    shape.effects.push_back(effect);
    context_.scene.shapes.push_back(std::move(shape));
    appearances_.emplace_back();
  }
}

/// Gives the shapes of the scene that ends here, from `first` on, what all of them have.
void SceneWalk::finish_shapes(std::size_t first) {
  const std::size_t headlight = context_.scene.lights.size();
  add_headlight(context_, navigation_info_);
  if (context_.scene.lights.size() > headlight) global_lights_.push_back(static_cast<int>(headlight));
  for (std::size_t i = first; i < context_.scene.shapes.size(); ++i) {
    SceneShape& shape = context_.scene.shapes[i];
    if (shape.part != ScenePart::world) continue;
    shape.lights.insert(shape.lights.end(), global_lights_.begin(), global_lights_.end());
    if (shape.fog == kBoundFog) shape.fog = bound_fog_.value_or(-1);
  }
}

/// The scenes that rendered textures have of their own: nothing of the world reaches into them. They may add textures.
void SceneWalk::visit_own_scenes() {
  const auto& textures = context_.scene.rendered_textures;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (!textures[i].own_scene) continue;
    own_scene_of_ = static_cast<int>(i);
    navigation_info_ = {};
    bound_fog_.reset();
    global_lights_.clear();
    const std::size_t first = context_.scene.shapes.size();
    const NodeId root = graph_.child(textures[i].node, "scene");
    visit_list({&root, 1});
    finish_shapes(first);
  }
}

SceneViewpoint read_viewpoint(SceneContext& context, NodeId node, int transform) {
  SceneViewpoint viewpoint;
  viewpoint.node = node;
  viewpoint.name = context.graph[node].def;
  viewpoint.description = context.graph.string(node, "description");
  viewpoint.transform = transform;
  viewpoint.orthographic = context.graph.is(node, "OrthoViewpoint");
  viewpoint.position = context.slots.slot(node, "position");
  viewpoint.orientation = context.slots.slot(node, "orientation");
  viewpoint.field_of_view = context.slots.slot(node, "fieldOfView");
  viewpoint.field_is_vertical = !viewpoint.orthographic && context.graph.boolean(node, "fieldOfViewForceVertical");
  return viewpoint;
}

Scene build_scene(const NodeGraph& graph, SourceSet& sources, FileAccess& files, const SceneOptions& options,
                  Diagnostics& diagnostics) {
  SceneContext context(graph, sources, files, options, diagnostics);
  SceneWalk(context).run();
  add_dynamic_slots(context);
  read_events(context);
  report_ignored_events(graph, diagnostics);
  return std::move(context.scene);
}

}  // namespace plugc
