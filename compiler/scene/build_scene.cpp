// Walks the tree from its roots. Each group first looks at its own children for what acts on their siblings too (effects,
// lights that are not global), then visits them; global lights are handed to every shape at the end. The walk follows
// each USE anew, since a shape under two parents is two shapes; limits stop what grows without bound.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/scene_context.h"

namespace plugc {
namespace {

/// Without a Background the standard leaves the colour to the browser: the dark grey of the reference engine's viewer,
/// measured.
constexpr double kDefaultSky = 26.0 / 255.0;

/// The reference engine adds this much of each material's ambient colour (OpenGL's default light model), measured.
constexpr double kGlobalAmbient = 0.2;

/// What a shape inherits from the groups above it.
struct Scope {
  int transform = -1;
  std::vector<int> effects;  // of groups, from the outermost in
  std::vector<int> lights;   // not global
};

class SceneWalk {
 public:
  explicit SceneWalk(SceneContext& context) : context_(context), graph_(context.graph) {}

  void run() {
    visit_list(graph_.roots(), Scope());
    if (context_.options.all_branches) add_unreached_effects();
    add_headlight(context_, navigation_info_);
    context_.scene.global_ambient = context_.slots.constant(SlotType::vec3, {kGlobalAmbient, kGlobalAmbient, kGlobalAmbient});
    if (!has_background_)
      context_.scene.background_color = context_.slots.constant(SlotType::vec3, {kDefaultSky, kDefaultSky, kDefaultSky});
    for (SceneShape& shape : context_.scene.shapes) add_global_lights(shape);
    finish_lights(context_, receives_);
  }

 private:
  void visit_list(std::span<const NodeId> nodes, Scope scope);
  void visit(NodeId node, const Scope& scope);
  void visit_switch(NodeId node, const Scope& scope);
  void visit_transform(NodeId node, const Scope& scope);
  void visit_shape(NodeId node, const Scope& scope);
  void visit_viewpoint(NodeId node, const Scope& scope);
  void visit_bindable(NodeId node, const Scope& scope);
  void add_global_lights(SceneShape& shape);
  void add_unreached_effects();
  int add_transform(const SceneTransform& transform);
  bool within_limits(NodeId node);

  SceneContext& context_;
  const NodeGraph& graph_;
  NodeId navigation_info_;
  bool has_background_ = false;
  std::vector<int> global_lights_;
  std::vector<std::vector<NodeId>> receives_;  // per shape: lights that its Appearance names
  std::uint32_t visited_ = 0;
  std::uint32_t depth_ = 0;
  bool limit_reached_ = false;
};

bool SceneWalk::within_limits(NodeId node) {
  if (limit_reached_ || depth_ >= kMaxSceneDepth) return false;  // so deep a graph was cut, and reported, before
  std::string reached;
  if (context_.scene.shapes.size() >= kMaxShapeInstances) {
    reached = fmt::format("{} shapes", kMaxShapeInstances);
  } else if (visited_ >= kMaxSceneNodes) {
    reached = fmt::format("{} nodes", kMaxSceneNodes);
  }
  if (reached.empty()) return true;
  limit_reached_ = true;
  context_.diagnostics.report(
      DiagnosticId::scene_limit, graph_[node].type_span,
      fmt::format("every `USE` counted, the scene holds more than {}; what follows is left out", reached));
  return false;
}

void SceneWalk::visit_list(std::span<const NodeId> nodes, Scope scope) {
  for (const NodeId node : nodes) {
    if (!node.valid()) continue;
    if (graph_.is(node, "Effect")) {
      if (const int effect = effect_index(context_, node); effect >= 0) scope.effects.push_back(effect);
    } else if (graph_.is(node, "DirectionalLight") || graph_.is(node, "PointLight") || graph_.is(node, "SpotLight")) {
      const bool off_for_good = !graph_.boolean(node, "on") && !context_.slots.may_change(node, "on");
      if (off_for_good) continue;
      (graph_.boolean(node, "global") ? global_lights_ : scope.lights).push_back(add_light(context_, node, scope.transform));
    }
  }
  for (const NodeId node : nodes) {
    if (node.valid() && within_limits(node)) visit(node, scope);
  }
}

void SceneWalk::visit(NodeId node, const Scope& scope) {
  ++visited_;
  ++depth_;
  if (graph_.is(node, "Shape")) {
    visit_shape(node, scope);
  } else if (graph_.is(node, "Switch")) {
    visit_switch(node, scope);
  } else if (graph_.is(node, "LOD")) {
    const auto levels = graph_.children(node, "children");
    visit_list(levels.subspan(0, std::min<std::size_t>(levels.size(), 1)), scope);
  } else if (graph_.is(node, "Transform")) {
    visit_transform(node, scope);
  } else if (graph_.is(node, "X3DGroupingNode") || graph_.is(node, "Inline")) {
    visit_list(graph_.children(node, "children"), scope);
  } else {
    visit_bindable(node, scope);
  }
  --depth_;
}

int SceneWalk::add_transform(const SceneTransform& transform) {
  context_.scene.transforms.push_back(transform);
  return static_cast<int>(context_.scene.transforms.size() - 1);
}

void SceneWalk::visit_transform(NodeId node, const Scope& scope) {
  SceneTransform transform;
  transform.parent = scope.transform;
  transform.translation = context_.slots.slot_if_used(node, "translation");
  transform.rotation = context_.slots.slot_if_used(node, "rotation");
  transform.scale = context_.slots.slot_if_used(node, "scale");
  transform.scale_orientation = context_.slots.slot_if_used(node, "scaleOrientation");
  transform.center = context_.slots.slot_if_used(node, "center");
  Scope inner = scope;
  inner.transform = add_transform(transform);
  visit_list(graph_.children(node, "children"), std::move(inner));
}

/// A Switch that nothing can change is its chosen child; one that a ROUTE drives keeps them all, each under a condition.
void SceneWalk::visit_switch(NodeId node, const Scope& scope) {
  const auto children = graph_.children(node, "children");
  if (!context_.slots.may_change(node, "whichChoice") && !context_.options.all_branches) {
    const int choice = graph_.integer(node, "whichChoice");
    if (choice >= 0 && static_cast<std::size_t>(choice) < children.size()) {
      visit_list(children.subspan(static_cast<std::size_t>(choice), 1), scope);
    }
    return;
  }
  for (std::size_t i = 0; i < children.size(); ++i) {
    SceneTransform transform;
    transform.parent = scope.transform;
    transform.switch_slot = context_.slots.slot(node, "whichChoice");
    transform.choice = static_cast<int>(i);
    Scope inner = scope;
    inner.transform = add_transform(transform);
    visit_list(children.subspan(i, 1), std::move(inner));
  }
}

Shading read_shading(SceneContext& context, NodeId shape) {
  const std::string_view shading = context.graph.string(shape, "shading");
  if (shading == "GOURAUD") return Shading::gouraud;
  if (shading == "WIREFRAME") return Shading::wireframe;
  return Shading::phong;
}

void SceneWalk::visit_shape(NodeId node, const Scope& scope) {
  const NodeId geometry = graph_.child(node, "geometry");
  if (!geometry.valid() || (!graph_.boolean(node, "render") && !context_.options.all_branches)) return;
  SceneShape shape;
  shape.node = node;
  shape.geometry = geometry;
  shape.name = graph_[node].def.empty() ? std::string(graph_[geometry].info->name) : std::string(graph_[node].def);
  shape.transform = scope.transform;
  shape.lights = scope.lights;
  shape.shading = read_shading(context_, node);
  const NodeId appearance = graph_.child(node, "appearance");
  read_appearance(context_, appearance, shape);
  shape.effects.insert(shape.effects.end(), scope.effects.begin(), scope.effects.end());
  shape.casts_shadow = shape.casts_shadow && graph_.boolean(node, "castShadow");
  std::vector<NodeId> named;
  if (graph_.is(appearance, "Appearance")) {
    const auto lights = graph_.children(appearance, "receiveShadows");
    named.assign(lights.begin(), lights.end());
  }
  receives_.push_back(std::move(named));
  context_.scene.shapes.push_back(std::move(shape));
}

void SceneWalk::visit_viewpoint(NodeId node, const Scope& scope) {
  SceneViewpoint viewpoint;
  viewpoint.name = graph_[node].def;
  viewpoint.description = graph_.string(node, "description");
  viewpoint.transform = scope.transform;
  viewpoint.orthographic = graph_.is(node, "OrthoViewpoint");
  viewpoint.position = context_.slots.slot(node, "position");
  viewpoint.orientation = context_.slots.slot(node, "orientation");
  viewpoint.field_of_view = context_.slots.slot(node, "fieldOfView");
  context_.scene.viewpoints.push_back(std::move(viewpoint));
}

void SceneWalk::visit_bindable(NodeId node, const Scope& scope) {
  if (graph_.is(node, "Viewpoint") || graph_.is(node, "OrthoViewpoint")) {
    visit_viewpoint(node, scope);
  } else if (graph_.is(node, "X3DBackgroundNode") && !has_background_) {
    has_background_ = true;
    context_.scene.background_color = context_.slots.slot(node, "skyColor");
  } else if ((graph_.is(node, "NavigationInfo") || graph_.is(node, "KambiNavigationInfo")) && !navigation_info_.valid()) {
    navigation_info_ = node;
  } else if (graph_.is(node, "X3DFogObject") || graph_.is(node, "ScreenEffect")) {
    context_.diagnostics.report(DiagnosticId::not_drawn, graph_[node].type_span,
                                fmt::format("a `{}` is not drawn yet", graph_[node].info->name));
  }
}

/// Effects that no shape shows (in an unused prototype, say) are tried on a copy of the first shape.
void SceneWalk::add_unreached_effects() {
  if (context_.scene.shapes.empty()) return;
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
    receives_.emplace_back();
  }
}

void SceneWalk::add_global_lights(SceneShape& shape) {
  shape.lights.insert(shape.lights.end(), global_lights_.begin(), global_lights_.end());
  const auto& lights = context_.scene.lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (lights[i].headlight) shape.lights.push_back(static_cast<int>(i));
  }
}

/// A host may write what it has announced, even where nothing of the scene reads it.
void add_dynamic_slots(SceneContext& context) {
  for (const DynamicField& field : context.dynamic) {
    const std::span<const InterfaceField> own = context.graph[field.node].interface();
    const auto declared = std::ranges::find(own, field.name, &InterfaceField::name);
    declared == own.end() ? context.slots.slot(field.node, field.name) : context.slots.interface_slot(field.node, *declared);
  }
}

}  // namespace

Scene build_scene(const NodeGraph& graph, SourceSet& sources, FileAccess& files, const SceneOptions& options,
                  Diagnostics& diagnostics) {
  SceneContext context(graph, sources, files, options, diagnostics);
  SceneWalk(context).run();
  add_dynamic_slots(context);
  report_ignored_events(graph, diagnostics);
  return std::move(context.scene);
}

}  // namespace plugc
