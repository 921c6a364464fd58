// Walks the tree from its roots. Each group first looks at its own children for what acts on their siblings too (effects,
// lights that are not global, clip planes), then visits them; global lights are handed to every shape at the end. The walk
// follows each USE anew, since a shape under two parents is two shapes; limits stop what grows without bound.

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/library_effects.h"
#include "scene/scene_context.h"
#include "scene/scene_events.h"

namespace plugc {
namespace {

/// Without a Background the standard leaves the colour to the browser: the dark grey of the reference engine's viewer,
/// measured.
constexpr double kDefaultSky = 26.0 / 255.0;

/// The reference engine adds this much of each material's ambient colour (OpenGL's default light model), measured.
constexpr double kGlobalAmbient = 0.2;

/// A shape without a LocalFog above it is in the fog of the scene, which is known when all is visited.
constexpr int kBoundFog = -2;

/// How the walk treats a node.
enum class Role : std::uint8_t {
  other,
  shape,
  switch_,
  lod,
  transform,
  billboard,
  group,
  inlined,
  effect,
  light,
  local_fog,
  clip_plane,
  matrix_transform
};

Role role_of(const NodeInfo& node) {
  static constexpr std::array<std::pair<std::string_view, Role>, 14> kRoles = {{{"Shape", Role::shape},
                                                                                {"Switch", Role::switch_},
                                                                                {"LOD", Role::lod},
                                                                                {"Transform", Role::transform},
                                                                                {"Billboard", Role::billboard},
                                                                                {"Inline", Role::inlined},
                                                                                {"MatrixTransform", Role::matrix_transform},
                                                                                {"X3DGroupingNode", Role::group},
                                                                                {"Effect", Role::effect},
                                                                                {"DirectionalLight", Role::light},
                                                                                {"PointLight", Role::light},
                                                                                {"SpotLight", Role::light},
                                                                                {"LocalFog", Role::local_fog},
                                                                                {"ClipPlane", Role::clip_plane}}};
  for (const auto& [type, role] : kRoles) {
    if (is_a(node, type)) return role;
  }
  return Role::other;
}

/// What the walk must know of a type.
struct TypeUse {
  Role role = Role::other;
  bool has_visible = false;
};

enum class Visibility : std::uint8_t { shown, hidden, changing };

class SceneWalk {
 public:
  explicit SceneWalk(SceneContext& context) : context_(context), graph_(context.graph) {}

  void run() {
    const bool alone = context_.options.alone.valid();
    const std::vector<NodeId> stage = alone ? library_stage_roots(graph_) : std::vector<NodeId>();
    const std::span<const NodeId> roots = alone ? std::span<const NodeId>(stage) : graph_.roots();
    check_top(roots);
    visit_list(roots);
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

 private:
  void visit_list(std::span<const NodeId> nodes);
  int add_transform(const SceneTransform& transform);
  void visit_below(const SceneTransform& transform, std::span<const NodeId> nodes);
  void act_on_siblings(NodeId node);
  void check_top(std::span<const NodeId> nodes);
  void visit(NodeId node);
  void visit_switch(NodeId node);
  void visit_lod(NodeId node);
  void visit_inline(NodeId node);
  void visit_transform(NodeId node);
  void visit_shape(NodeId node);
  void visit_other(NodeId node);
  void visit_viewpoint(NodeId node);
  void bind_if_first(NodeId node);
  void add_background();
  void finish_shapes(std::size_t first);
  void visit_own_scenes();
  void add_unreached_effects();
  bool within_limits(NodeId node);
  Role role(NodeId node) { return use_of(node).role; }
  const TypeUse& use_of(NodeId node);
  Visibility visibility(NodeId node);
  SceneTransform condition(NodeId node, std::string_view field, int value);

  SceneContext& context_;
  const NodeGraph& graph_;
  NodeId navigation_info_;
  NodeId background_;
  int background_transform_ = -1;
  std::optional<int> bound_fog_;
  std::vector<int> global_lights_;
  std::vector<NodeId> appearances_;  // per shape; not valid where it has none
  int own_scene_of_ = -1;            // the rendered texture whose scene this is; -1: the world

  // What the next shape inherits from the groups above it.
  int transform_ = -1;
  std::vector<int> effects_;  // from the outermost in
  std::vector<int> lights_;   // not global
  int fog_ = kBoundFog;       // the nearest LocalFog; -1: one that lets everything through
  std::vector<int> clip_planes_;

  std::uint32_t hidden_ = 0;  // nodes above that are not visible, for good

  std::unordered_map<const NodeInfo*, TypeUse> uses_;
  std::uint32_t visited_ = 0;
  std::uint32_t depth_ = 0;
  std::uint32_t inlines_ = 0;  // around what is visited
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

/// A type's bases are looked up once: the walk meets the same few types again and again.
const TypeUse& SceneWalk::use_of(NodeId node) {
  const NodeInfo* info = graph_[node].info;
  const auto [known, is_new] = uses_.try_emplace(info);
  if (is_new) known->second = {role_of(*info), graph_.has_field(node, "visible")};
  return known->second;
}

/// X3D 4.1, 10.3.1: `visible FALSE` hides, and does nothing else.
Visibility SceneWalk::visibility(NodeId node) {
  if (!use_of(node).has_visible || context_.options.all_branches) return Visibility::shown;
  if (context_.slots.may_change(node, "visible")) return Visibility::changing;
  return graph_.boolean(node, "visible") ? Visibility::shown : Visibility::hidden;
}

/// The current transform, but only while the field of that node has that value.
SceneTransform SceneWalk::condition(NodeId node, std::string_view field, int value) {
  SceneTransform transform;
  transform.parent = transform_;
  transform.switch_slot = context_.slots.slot(node, field);
  transform.choice = value;
  return transform;
}

void SceneWalk::visit_list(std::span<const NodeId> nodes) {
  const std::size_t effects = effects_.size(), lights = lights_.size(), planes = clip_planes_.size();
  const int fog = fog_;
  for (const NodeId node : nodes) {
    if (node.valid()) act_on_siblings(node);
  }
  for (const NodeId node : nodes) {
    if (node.valid() && within_limits(node)) visit(node);
  }
  effects_.resize(effects);
  lights_.resize(lights);
  clip_planes_.resize(planes);
  fog_ = fog;
}

void SceneWalk::act_on_siblings(NodeId node) {
  if (role(node) == Role::effect) {
    if (const int effect = effect_index(context_, node); effect >= 0) effects_.push_back(effect);
  } else if (role(node) == Role::light) {
    const bool off_for_good = !graph_.boolean(node, "on") && !context_.slots.may_change(node, "on");
    if (off_for_good || hidden_ > 0) return;
    (graph_.boolean(node, "global") ? global_lights_ : lights_).push_back(add_light(context_, node, transform_));
  } else if (role(node) == Role::local_fog && graph_.boolean(node, "enabled")) {
    fog_ = add_fog(context_, node, transform_);
  } else if (role(node) == Role::clip_plane) {
    if (const int plane = add_clip_plane(context_, node, transform_); plane >= 0) clip_planes_.push_back(plane);
  }
}

/// X3D 4.1 part 1, 4.3.2: the nodes at the top of a file are children, or layers. Its metadata often stands there too.
void SceneWalk::check_top(std::span<const NodeId> nodes) {
  for (const NodeId node : nodes) {
    const auto is = [&](std::string_view type) { return graph_.is(node, type); };
    if (role(node) != Role::other || is("X3DChildNode") || is("LayerSet") || is("X3DMetadataObject")) continue;
    context_.diagnostics.report(DiagnosticId::node_misplaced, graph_[node].type_span,
                                fmt::format("`{}` stands at the top of the file, where only children of groups count; it is "
                                            "not drawn",
                                            graph_[node].info->name));
  }
}

void SceneWalk::visit(NodeId node) {
  ++visited_;
  ++depth_;
  const int outer = transform_;
  const Visibility visible = visibility(node);
  if (visible == Visibility::changing) transform_ = add_transform(condition(node, "visible", 1));
  if (visible == Visibility::hidden) ++hidden_;
  switch (role(node)) {
    case Role::shape: visit_shape(node); break;
    case Role::switch_: visit_switch(node); break;
    case Role::lod: visit_lod(node); break;
    case Role::transform: visit_transform(node); break;
    case Role::billboard: {
      SceneTransform transform;
      transform.parent = transform_;
      transform.billboard_axis = context_.slots.slot(node, "axisOfRotation");
      visit_below(transform, graph_.children(node, "children"));
      break;
    }
    case Role::matrix_transform:
      visit_below(read_matrix_transform(context_, node, transform_), graph_.children(node, "children"));
      break;
    case Role::group: visit_list(graph_.children(node, "children")); break;
    case Role::inlined: visit_inline(node); break;
    case Role::other: visit_other(node); break;
    case Role::effect:
    case Role::light:
    case Role::local_fog:
    case Role::clip_plane: break;  // they acted on their siblings
  }
  if (visible == Visibility::hidden) --hidden_;
  transform_ = outer;
  --depth_;
}

int SceneWalk::add_transform(const SceneTransform& transform) {
  context_.scene.transforms.push_back(transform);
  return static_cast<int>(context_.scene.transforms.size() - 1);
}

void SceneWalk::visit_below(const SceneTransform& transform, std::span<const NodeId> nodes) {
  const int outer = std::exchange(transform_, add_transform(transform));
  visit_list(nodes);
  transform_ = outer;
}

void SceneWalk::visit_transform(NodeId node) {
  SceneTransform transform;
  transform.parent = transform_;
  transform.translation = context_.slots.slot_if_used(node, "translation");
  transform.rotation = context_.slots.slot_if_used(node, "rotation");
  transform.scale = context_.slots.slot_if_used(node, "scale");
  transform.scale_orientation = context_.slots.slot_if_used(node, "scaleOrientation");
  transform.center = context_.slots.slot_if_used(node, "center");
  visit_below(transform, graph_.children(node, "children"));
}

/// A Switch that nothing can change is its chosen child; one that a ROUTE drives keeps them all, each under a condition.
void SceneWalk::visit_switch(NodeId node) {
  const auto children = graph_.children(node, "children");
  if (!context_.slots.may_change(node, "whichChoice") && !context_.options.all_branches) {
    const int choice = graph_.integer(node, "whichChoice");
    if (choice >= 0 && static_cast<std::size_t>(choice) < children.size()) {
      visit_list(children.subspan(static_cast<std::size_t>(choice), 1));
    }
    return;
  }
  for (std::size_t i = 0; i < children.size(); ++i) {
    visit_below(condition(node, "whichChoice", static_cast<int>(i)), children.subspan(i, 1));
  }
}

/// Each level under a condition of its own (X3D 4.1, 23.4.3). Ranges that do not grow count as the largest so far.
void SceneWalk::visit_lod(NodeId node) {
  const auto ranges = graph_.field(node, "range").numbers;
  const auto all = graph_.children(node, "children");
  const auto levels = all.subspan(0, std::min(all.size(), ranges.size() + 1));
  if (levels.size() <= 1) return visit_list(levels);
  double from = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    SceneTransform transform;
    transform.parent = transform_;
    transform.lod_center = context_.slots.slot(node, "center");
    transform.lod_from = from;
    const bool is_last = i + 1 == levels.size();
    from = is_last ? std::numeric_limits<double>::infinity() : ranges[i] > from ? ranges[i] : from;
    transform.lod_to = from;
    visit_below(transform, levels.subspan(i, 1));
  }
}

void SceneWalk::visit_inline(NodeId node) {
  check_top(graph_.children(node, "children"));
  ++inlines_;
  visit_list(graph_.children(node, "children"));
  --inlines_;
}

Shading read_shading(SceneContext& context, NodeId shape) {
  const std::string_view shading = context.graph.string(shape, "shading");
  if (shading == "GOURAUD") return Shading::gouraud;
  if (shading == "WIREFRAME") return Shading::wireframe;
  return Shading::phong;
}

void SceneWalk::visit_shape(NodeId node) {
  const NodeId geometry = graph_.child(node, "geometry");
  if (hidden_ > 0) return;
  if (!geometry.valid() || (!graph_.boolean(node, "render") && !context_.options.all_branches)) return;
  SceneShape shape;
  shape.node = node;
  shape.geometry = geometry;
  shape.name = graph_[node].def.empty() ? std::string(graph_[geometry].info->name) : std::string(graph_[node].def);
  shape.transform = transform_;
  shape.lights = lights_;
  shape.fog = fog_;
  shape.clip_planes = clip_planes_;
  shape.own_scene_of = own_scene_of_;
  shape.shading = read_shading(context_, node);
  const glm::dvec3 size = graph_.vec3(node, "bboxSize");
  const glm::dvec3 center = graph_.vec3(node, "bboxCenter");
  if (size.x >= 0 && size.y >= 0 && size.z >= 0) shape.bounds = Box{center - 0.5 * size, center + 0.5 * size};
  const NodeId appearance = graph_.child(node, "appearance");
  read_appearance(context_, appearance, shape);
  read_texture_coordinates(context_, shape);
  shape.effects.insert(shape.effects.end(), effects_.begin(), effects_.end());
  shape.casts_shadow = shape.casts_shadow && graph_.boolean(node, "castShadow");
  appearances_.push_back(graph_.is(appearance, "Appearance") ? appearance : NodeId());
  context_.scene.shapes.push_back(std::move(shape));
}

void SceneWalk::visit_other(NodeId node) {
  if (own_scene_of_ >= 0 && bind_in_own_scene(context_, node, transform_, own_scene_of_)) return;
  if (graph_.is(node, "X3DViewpointNode")) {
    visit_viewpoint(node);
  } else if (graph_.is(node, "ViewpointGroup") || graph_.is(node, "StaticGroup")) {  // no X3DGroupingNode, either of them
    visit_list(graph_.children(node, "children"));
  } else if (graph_.is(node, "ProximitySensor")) {
    context_.sensor_transforms.try_emplace(node, transform_);
  } else if (graph_.is(node, "ScreenEffect")) {
    add_screen_effect(context_, node, transform_);
  } else {
    bind_if_first(node);
  }
}

void SceneWalk::visit_viewpoint(NodeId node) {
  if (!graph_.is(node, "Viewpoint") && !graph_.is(node, "OrthoViewpoint")) return;
  Scene& scene = context_.scene;
  if (inlines_ == 0 && scene.bound_viewpoint < 0) scene.bound_viewpoint = static_cast<int>(scene.viewpoints.size());
  scene.viewpoints.push_back(read_viewpoint(context_, node, transform_));
}

/// The first of its kind is bound; those of an Inline are no candidates (X3D 4.1, 7.2.2).
void SceneWalk::bind_if_first(NodeId node) {
  if (inlines_ > 0) return;
  if (graph_.is(node, "X3DBackgroundNode") && !background_.valid()) {
    background_ = node;
    background_transform_ = transform_;
    context_.scene.background_color = context_.slots.slot(node, "skyColor");
  } else if ((graph_.is(node, "NavigationInfo") || graph_.is(node, "KambiNavigationInfo")) && !navigation_info_.valid()) {
    navigation_info_ = node;
  } else if (graph_.is(node, "Fog") && !bound_fog_) {
    bound_fog_ = add_fog(context_, node, transform_);
  }
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

/// A host may write what it has announced, even where nothing of the scene reads it.
void add_dynamic_slots(SceneContext& context) {
  for (const DynamicField& field : context.dynamic) context.slots.declared_slot(field.node, field.name);
}

}  // namespace

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
