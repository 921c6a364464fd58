// The walk, and what can be said only when all is visited: which global lights shine, which fog and background are bound.

#include "scene/library_effects.h"
#include "scene/scene_bindings.h"
#include "scene/scene_events.h"
#include "scene/scene_walk.h"

namespace plugc {
namespace {

/// Without a Background the standard leaves the colour to the browser: the dark grey of the reference engine's viewer,
/// measured.
constexpr double kDefaultSky = 26.0 / 255.0;

/// The reference engine adds this much of each material's ambient colour (OpenGL's default light model), measured.
constexpr double kGlobalAmbient = 0.2;

std::uint32_t default_sky(SceneContext& context) {
  return context.slots.constant(SlotType::vec3, {kDefaultSky, kDefaultSky, kDefaultSky});
}

/// A host may write what it has announced, even where nothing of the scene reads it.
void add_dynamic_slots(SceneContext& context) {
  for (const DynamicField& field : context.dynamic) context.slots.declared_slot(field.node, field.name);
}

}  // namespace

void SceneWalk::run() {
  const bool alone = context_.options.alone.valid();
  const std::vector<NodeId> stage = alone ? library_stage_roots(graph_) : std::vector<NodeId>();
  const std::span<const NodeId> roots = alone ? std::span<const NodeId>(stage) : graph_.roots();
  check_top(roots);
  find_changing_stacks(context_);
  visit_list(roots);
  finish_bindings();
  context_.scene.visibility_limit = visibility_limit(context_, navigation_info_);
  add_background();
  if (context_.options.all_branches) add_unreached_effects();
  separate_mirrors(context_.scene, context_.own_backgrounds);
  lend_own_fogs(context_, bound_fog_);
  finish_shapes(0);
  context_.scene.global_ambient = context_.slots.constant(SlotType::vec3, {kGlobalAmbient, kGlobalAmbient, kGlobalAmbient});
  if (context_.scene.background_color == kSceneNoSlot) context_.scene.background_color = default_sky(context_);
  visit_own_scenes();
  sort_rendered_textures(context_);
  finish_lights(context_, appearances_);
  finish_projections(context_);
  if (alone) place_alone(context_);
}

/// What events bind, other than Backgrounds.
void SceneWalk::finish_bindings() {
  if (stack(BindKind::viewpoint).changes) context_.scene.bound_viewpoint_now = bound_index(context_, BindKind::viewpoint);
  const BindStack& fogs = stack(BindKind::fog);
  if (fogs.changes && !fogs.nodes.empty()) bound_fog_ = add_changing_fog(context_);
}

/// Its shapes stand behind those of the world.
void SceneWalk::add_background() {
  if (stack(BindKind::background).changes)
    add_changing_background();
  else if (background_.valid())
    add_backdrop(context_, background_, background_transform_);
  appearances_.resize(context_.scene.shapes.size());
}

/// Backgrounds come behind the walk, which counted none of their shapes. False where there was no room left, which is reported.
bool SceneWalk::add_backdrop_within_limits(const BoundBackground& background) {
  if (context_.scene.shapes.size() >= kMaxShapeInstances) {
    report_limit(background.node, kMaxShapeInstances, "shapes");
    return false;
  }
  add_backdrop(context_, background.node, background.transform);
  return true;
}

/// Of all that can be bound, each for its number.
void SceneWalk::add_changing_background() {
  const BindStack& backgrounds = stack(BindKind::background);
  std::vector<SceneShape>& shapes = context_.scene.shapes;
  context_.scene.bound_background = bound_index(context_, BindKind::background);
  context_.scene.background_color = bound_sky_color(context_, default_sky(context_));
  for (std::size_t i = 0; i < backgrounds.nodes.size(); ++i) {
    const std::size_t first = shapes.size();
    if (!add_backdrop_within_limits({backgrounds.nodes[i], backgrounds.transforms[i]})) return;
    for (std::size_t k = first; k < shapes.size(); ++k) shapes[k].background = static_cast<int>(i);
  }
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
  if (own_scene_of_ < 0 && stack(BindKind::navigation_info).changes)
    add_changing_headlight(context_);
  else
    add_headlight(context_, navigation_info_);
  if (context_.scene.lights.size() > headlight) global_lights_.push_back(static_cast<int>(headlight));
  for (std::size_t i = first; i < context_.scene.shapes.size(); ++i) {
    SceneShape& shape = context_.scene.shapes[i];
    if (shape.part != ScenePart::world) continue;
    shape.lights.insert(shape.lights.end(), global_lights_.begin(), global_lights_.end());
    if (shape.fog == kBoundFog) shape.fog = bound_fog_.value_or(-1);
  }
}

/// Nothing of the world reaches into it.
void SceneWalk::visit_own_scene(int texture) {
  const NodeId node = context_.scene.rendered_textures[static_cast<std::size_t>(texture)].node;
  own_scene_of_ = texture;
  navigation_info_ = {};
  bound_fog_.reset();
  if (const NodeId fog = graph_.child(node, "fog"); graph_.is(fog, "Fog")) bound_fog_ = add_fog(context_, fog, -1);
  global_lights_.clear();
  const std::size_t first = context_.scene.shapes.size();
  const NodeId root = graph_.child(node, "scene");
  visit_list({&root, 1});
  finish_shapes(first);
}

/// What is around the view of a rendered texture that has a Background of its own.
void SceneWalk::add_own_background(int texture) {
  const auto found = context_.own_backgrounds.find(texture);
  if (found == context_.own_backgrounds.end()) return;
  const std::size_t first = context_.scene.shapes.size();
  if (!add_backdrop_within_limits(found->second)) return;
  for (std::size_t i = first; i < context_.scene.shapes.size(); ++i) context_.scene.shapes[i].own_scene_of = texture;
  appearances_.resize(context_.scene.shapes.size());
}

/// The scenes and backgrounds that rendered textures have of their own. They may add textures.
void SceneWalk::visit_own_scenes() {
  const auto& textures = context_.scene.rendered_textures;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (textures[i].own_scene) visit_own_scene(static_cast<int>(i));
    add_own_background(static_cast<int>(i));
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
  viewpoint.direction = context.slots.slot_if_used(node, "direction");
  viewpoint.up = context.slots.slot_if_used(node, "up");
  viewpoint.field_is_vertical = !viewpoint.orthographic && context.graph.boolean(node, "fieldOfViewForceVertical");
  return viewpoint;
}

Scene build_scene(const NodeGraph& graph, SourceSet& sources, FileAccess& files, const SceneOptions& options,
                  Diagnostics& diagnostics) {
  SceneContext context(graph, sources, files, options, diagnostics);
  SceneWalk(context).run();
  for (const auto& [node, field] : context.vertex_fields) context.scene.vertex_fields.push_back(field);
  report_events_to_gradients(context);
  add_dynamic_slots(context);
  read_events(context);
  report_ignored_events(graph, diagnostics);
  return std::move(context.scene);
}

}  // namespace plugc
