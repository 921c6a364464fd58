// One node at a time.

#include "scene/scene_walk.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/scene_bindings.h"

namespace plugc {
namespace {

Role role_of(const NodeInfo& node) {
  static constexpr std::array<std::pair<std::string_view, Role>, 18> kRoles = {{{"Shape", Role::shape},
                                                                                {"Switch", Role::switch_},
                                                                                {"LOD", Role::lod},
                                                                                {"Transform", Role::transform},
                                                                                {"CADPart", Role::transform},
                                                                                {"HAnimHumanoid", Role::transform},
                                                                                {"HAnimJoint", Role::transform},
                                                                                {"HAnimSite", Role::transform},
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

Shading read_shading(SceneContext& context, NodeId shape) {
  const std::string_view shading = context.graph.string(shape, "shading");
  if (shading == "GOURAUD") return Shading::gouraud;
  if (shading == "WIREFRAME") return Shading::wireframe;
  return Shading::phong;
}

}  // namespace

bool SceneWalk::within_limits(NodeId node) {
  if (limit_reached_ || depth_ >= kMaxSceneDepth) return false;  // so deep a graph was cut, and reported, before
  if (context_.scene.shapes.size() >= kMaxShapeInstances) {
    report_limit(node, kMaxShapeInstances, "shapes");
  } else if (visited_ >= kMaxSceneNodes) {
    report_limit(node, kMaxSceneNodes, "nodes");
  }
  return !limit_reached_;
}

void SceneWalk::report_limit(NodeId node, std::uint32_t limit, std::string_view of) {
  if (std::exchange(limit_reached_, true)) return;
  context_.diagnostics.report(
      DiagnosticId::scene_limit, graph_[node].type_span,
      fmt::format("every `USE` counted, the scene holds more than {} {}; what follows is left out", limit, of));
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
    case Role::billboard: visit_billboard(node); break;
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
  read_vertex_fields(context_, geometry);
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
  } else if (graph_.is(node, "CADFace")) {
    const NodeId shape = graph_.child(node, "shape");
    visit_list({&shape, 1});
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
  note_bindable(context_, node, transform_, inlines_ == 0);
}

/// The first of its kind is bound; those of an Inline are no candidates (X3D 4.1, 7.2.2).
void SceneWalk::bind_if_first(NodeId node) {
  if (own_scene_of_ < 0) note_bindable(context_, node, transform_, inlines_ == 0);
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

}  // namespace plugc
