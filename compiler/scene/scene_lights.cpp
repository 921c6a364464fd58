// Lights, and which shapes show whose shadow. A light is an instance: the node where it stands. Lights are numbered as
// effects see them: headlight, directional lights, then the others, each in document order.

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "scene/scene_context.h"
#include "scene/shadow_volumes.h"

namespace plugc {
namespace {

LightKind light_kind(const NodeGraph& graph, NodeId light) {
  if (graph.is(light, "SpotLight")) return LightKind::spot;
  return graph.is(light, "PointLight") ? LightKind::point : LightKind::directional;
}

void read_projection(SceneContext& context, const SceneLight& light, SceneShadowMap& map) {
  SlotTable& slots = context.slots;
  map.near = slots.slot(light.node, "projectionNear");
  map.far = slots.slot(light.node, "projectionFar");
  map.up = slots.slot(light.node, "up");
  if (light.kind == LightKind::spot) map.angle = slots.slot(light.node, "projectionAngle");
  if (light.kind == LightKind::directional) {
    map.rectangle = slots.slot(light.node, "projectionRectangle");
    map.location = slots.slot(light.node, "projectionLocation");
  }
}

/// A projection that cannot be is reported here, where its line is known; the runtime computes it instead.
void check_projection(SceneContext& context, const SceneLight& light) {
  const NodeGraph& graph = context.graph;
  const double near = graph.number(light.node, "projectionNear");
  const double far = graph.number(light.node, "projectionFar");
  const auto report = [&](std::string_view field, std::string message) {
    context.diagnostics.report(DiagnosticId::projection_invalid, graph.field_span(light.node, field), std::move(message));
  };
  if (far > 0 && far <= near) {
    report("projectionFar",
           fmt::format("`projectionFar` {} is not beyond `projectionNear` {}; it is computed instead", far, near));
  }
  if (light.kind != LightKind::directional) return;
  const glm::dvec4 rectangle = graph.vec4(light.node, "projectionRectangle");  // left bottom right top
  if (rectangle != glm::dvec4(0) && (rectangle.x >= rectangle.z || rectangle.y >= rectangle.w)) {
    report("projectionRectangle", "`projectionRectangle` is empty (left bottom right top); it is computed instead");
  }
}

ShadowUpdate read_update(SceneContext& context, NodeId map) {
  const std::string_view update = context.graph.string(map, "update");
  if (update == "ALWAYS") return ShadowUpdate::always;
  if (update == "NEXT_FRAME_ONLY") return ShadowUpdate::next_frame_only;
  return ShadowUpdate::none;
}

void report_never_drawn(SceneContext& context, NodeId map) {
  context.diagnostics.report(
      DiagnosticId::shadow_map_update_none, context.graph.field_span(map, "update"),
      "a shadow map with `update \"NONE\"` is never drawn, so this light casts no shadow; write `update \"ALWAYS\"`");
}

/// False, with a message, for a light that has no map.
bool can_have_map(SceneContext& context, const SceneLight& light) {
  if (!light.headlight) return true;
  if (light.node.valid()) {
    context.diagnostics.report(DiagnosticId::shadow_unsupported, context.graph[light.node].type_span,
                               "a headlight casts no shadow: it hangs on the camera, which sees none of it");
  }
  return false;
}

/// Whether the field of a map has a value that somebody chose.
bool is_chosen(SceneContext& context, NodeId map, std::string_view field) {
  return context.graph.is_written(map, field) || context.slots.may_change(map, field);
}

/// `wanted`: where the map does not write it; 0: the field's default.
std::uint32_t read_size(SceneContext& context, NodeId written, std::uint32_t wanted) {
  if (wanted != 0 && !context.graph.is_written(written, "size")) return wanted;
  const int size = context.graph.integer(written, "size");
  const auto usable = static_cast<std::uint32_t>(std::clamp(size, 1, static_cast<int>(kMaxShadowMapSide)));
  if (size > static_cast<int>(usable)) {
    context.diagnostics.report(DiagnosticId::field_range, context.graph.field_span(written, "size"),
                               fmt::format("a shadow map of size {} cannot be; {} is used", size, usable));
  }
  return usable;
}

/// What a GeneratedShadowMap node says; false when such a map is never drawn.
bool read_written_map(SceneContext& context, NodeId written, std::uint32_t wanted_size, SceneShadowMap& map) {
  const NodeGraph& graph = context.graph;
  map.update = read_update(context, written);
  if (map.update == ShadowUpdate::none) {
    if (graph.string(written, "update") == "NONE") report_never_drawn(context, written);
    return false;
  }
  map.size = read_size(context, written, wanted_size);
  map.size_written = graph.is_written(written, "size");
  const auto method = shadow_method_named(graph.string(written, "method"));
  map.method = method.value_or(map.method);
  map.method_written = method.has_value();
  map.scale_written = is_chosen(context, written, "scale");
  map.bias_written = is_chosen(context, written, "bias");
  if (map.scale_written) map.scale = context.slots.slot(written, "scale");
  if (map.bias_written) map.bias = context.slots.slot(written, "bias");
  return true;
}

/// A map of moments is not as large as one of depths may be. `written` may be no node.
void limit_moment_map(SceneContext& context, NodeId written, SceneShadowMap& map) {
  if (!keeps_moments(map.method) || map.size <= kMaxMomentMapSide) return;
  if (written.valid() && context.graph.is_written(written, "size")) {
    context.diagnostics.report(DiagnosticId::field_range, context.graph.field_span(written, "size"),
                               fmt::format("a shadow map of size {} cannot hold moments (method {}); {} is used", map.size,
                                           to_text(map.method), kMaxMomentMapSide));
  }
  map.size = kMaxMomentMapSide;
}

/// Cube maps are looked up by some methods only; of pcf3_taps nothing is said, for a cube's pcf3 is made of taps anyway.
void choose_cube_method(SceneContext& context, const SceneLight& light, NodeId written, SceneShadowMap& map) {
  const ShadowMethod wanted = std::exchange(map.method, method_for_cube(map.method));
  if (map.method == wanted || wanted == ShadowMethod::pcf3_taps) return;
  const bool by_map = written.valid() && context.graph.is_written(written, "method");
  context.diagnostics.report(DiagnosticId::shadow_method_replaced,
                             by_map ? context.graph.field_span(written, "method") : context.graph[light.node].type_span,
                             fmt::format("the map of a point light is not looked up by `{}`; `{}` takes its place",
                                         to_text(wanted), to_text(map.method)));
}

/// What the map that is added next gets where nothing is written.
void take_choice(SceneContext& context, ShadowDefaults& defaults, SceneShadowMap& map) {
  for (const ShadowChoice& choice : context.options.choices) {
    if (choice.map != context.scene.shadow_maps.size()) continue;
    map.choice = choice;
    defaults = {choice.method, choice.size};
  }
}

void report_missed_budget(SceneContext& context, const SceneLight& light, const SceneShadowMap& map) {
  if (!map.choice || map.choice->error <= map.choice->budget) return;
  context.diagnostics.report(
      DiagnosticId::shadow_error_missed, context.graph[light.node].type_span,
      fmt::format(
          "this light's shadow cannot be within {:.3g} % of wrong pixels; the nearest is {:.3g} %, by `{}` with {} texels",
          100 * map.choice->budget, 100 * map.choice->error, to_text(map.method), map.size));
}

double slope_scale(const SceneShadowMap& map) {
  return map.choice && map.choice->scale > 0 ? map.choice->scale : automatic_slope_scale(map.method);
}

/// The map of a light as `written` says, or as nobody says; its index, or -1.
int add_shadow_map(SceneContext& context, int light_index, NodeId written) {
  const SceneLight& light = context.scene.lights[static_cast<std::size_t>(light_index)];
  if (!can_have_map(context, light)) return -1;
  SceneShadowMap map;
  map.light = light_index;
  ShadowDefaults defaults = context.options.shadows;
  take_choice(context, defaults, map);
  map.method = defaults.method;
  if (defaults.size != 0) map.size = defaults.size;
  if (written.valid() && !read_written_map(context, written, defaults.size, map)) return -1;
  if (light.kind == LightKind::point) choose_cube_method(context, light, written, map);
  limit_moment_map(context, written, map);
  if (!map.scale_written) map.scale = context.slots.constant(SlotType::float_, {slope_scale(map)});
  if (!map.bias_written) map.bias = context.slots.constant(SlotType::float_, {kAutomaticDepthBias});
  report_missed_budget(context, light, map);
  check_projection(context, light);
  read_projection(context, light, map);
  context.scene.shadow_maps.push_back(map);
  return static_cast<int>(context.scene.shadow_maps.size() - 1);
}

/// The map of a light that some shape receives; -1 when it has none that can be drawn.
int make_shadow_map(SceneContext& context, int light_index) {
  const NodeId light = context.scene.lights[static_cast<std::size_t>(light_index)].node;
  const NodeId written = light.valid() ? context.graph.child(light, "defaultShadowMap") : NodeId();
  return written.valid() ? shadow_map_of_node(context, written, light_index) : add_shadow_map(context, light_index, {});
}

/// Order of lights as effects number them; a stable sort keeps document order within a kind.
std::vector<int> numbering(const std::vector<SceneLight>& lights) {
  const auto rank = [&](int index) {
    const SceneLight& light = lights[static_cast<std::size_t>(index)];
    return light.headlight ? 0 : light.kind == LightKind::directional ? 1 : 2;
  };
  std::vector<int> order(lights.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
  return order;
}

void renumber_lights(Scene& scene) {
  const std::vector<int> order = numbering(scene.lights);
  std::vector<int> new_index(order.size());
  std::vector<SceneLight> lights;
  for (const int old : order) {
    new_index[static_cast<std::size_t>(old)] = static_cast<int>(lights.size());
    lights.push_back(std::move(scene.lights[static_cast<std::size_t>(old)]));
  }
  scene.lights = std::move(lights);
  for (SceneShape& shape : scene.shapes) {
    for (int& light : shape.lights) light = new_index[static_cast<std::size_t>(light)];
    std::sort(shape.lights.begin(), shape.lights.end());
  }
}

std::span<const NodeId> named_lights(const NodeGraph& graph, NodeId appearance) {
  return appearance.valid() ? graph.children(appearance, "receiveShadows") : std::span<const NodeId>();
}

bool receives_from(const SceneLight& light, std::span<const NodeId> named) {
  return light.casts_on_all || (light.node.valid() && std::ranges::find(named, light.node) != named.end());
}

/// Whether the light stands in the scene, or would if it were on.
bool may_shine(const SceneContext& context, NodeId light) {
  const bool off_for_good = !context.graph.boolean(light, "on") && !context.slots.may_change(light, "on");
  return off_for_good || std::ranges::find(context.scene.lights, light, &SceneLight::node) != context.scene.lights.end();
}

/// A light that an Appearance names and that stands nowhere casts no shadow: it does not shine.
void report_absent_lights(SceneContext& context, const std::vector<NodeId>& appearances) {
  for (const NodeId appearance : std::set<NodeId>(appearances.begin(), appearances.end())) {
    for (const NodeId light : named_lights(context.graph, appearance)) {
      if (!context.graph.is(light, "X3DLightNode") || may_shine(context, light)) continue;
      context.diagnostics.report(
          DiagnosticId::shadow_without_light, context.graph.field_span(appearance, "receiveShadows"),
          fmt::format("`receiveShadows` names `{}`, which stands in no group that is drawn: it does not shine, so it casts no "
                      "shadow",
                      node_label(context.graph, light)));
    }
  }
}

}  // namespace

int add_light(SceneContext& context, NodeId node, int transform) {
  const NodeGraph& graph = context.graph;
  SlotTable& slots = context.slots;
  SceneLight light;
  light.kind = light_kind(graph, node);
  light.node = node;
  light.label = node_label(graph, node);
  light.transform = transform;
  light.on = slots.slot(node, "on");
  light.color = slots.slot(node, "color");
  light.intensity = slots.slot(node, "intensity");
  light.ambient_intensity = slots.slot(node, "ambientIntensity");
  light.shadow_intensity = slots.slot(node, "shadowIntensity");
  if (light.kind != LightKind::point) light.direction = slots.slot(node, "direction");
  if (light.kind != LightKind::directional) {
    light.location = slots.slot(node, "location");
    light.attenuation = slots.slot(node, "attenuation");
    light.radius = slots.slot(node, "radius");
  }
  if (light.kind == LightKind::spot) {
    light.cut_off_angle = slots.slot(node, "cutOffAngle");
    light.beam_width = slots.slot(node, "beamWidth");
  }
  light.effects = effect_list(context, node);
  light.casts_on_all = graph.boolean(node, "shadows");
  context.scene.lights.push_back(std::move(light));
  return static_cast<int>(context.scene.lights.size() - 1);
}

void add_headlight(SceneContext& context, NodeId navigation_info) {
  const NodeGraph& graph = context.graph;
  if (navigation_info.valid()) {
    const bool switched = context.slots.may_change(navigation_info, "headlight");
    if (!graph.boolean(navigation_info, "headlight") && !switched) return;
    if (const NodeId node = graph.child(navigation_info, "headlightNode"); graph.is(node, "X3DLightNode")) {
      if (!graph.boolean(node, "on") && !context.slots.may_change(node, "on")) return;
      SceneLight& light = context.scene.lights[static_cast<std::size_t>(add_light(context, node, -1))];
      light.headlight = true;
      if (switched && !context.slots.may_change(node, "on")) light.on = context.slots.slot(navigation_info, "headlight");
      return;
    }
  }
  SlotTable& slots = context.slots;
  SceneLight light;
  light.headlight = true;
  light.label = "headlight";
  light.on = navigation_info.valid() ? slots.slot(navigation_info, "headlight") : slots.constant(SlotType::bool_, {1});
  light.color = slots.constant(SlotType::vec3, {1, 1, 1});
  light.intensity = slots.constant(SlotType::float_, {1});
  light.ambient_intensity = slots.constant(SlotType::float_, {0});
  light.direction = slots.constant(SlotType::vec3, {0, 0, -1});
  light.shadow_intensity = slots.constant(SlotType::float_, {1});
  context.scene.lights.push_back(std::move(light));
}

int shadow_map_of_node(SceneContext& context, NodeId map, int index) {
  const auto [found, added] = context.shadow_maps.try_emplace({map, index}, -1);
  if (added) found->second = add_shadow_map(context, index, map);
  return found->second;
}

int projection_of_light(SceneContext& context, int index) {
  // all maps of a light that authors see have one projection; its own for all shapes stays the renderer's
  const int own = context.scene.lights[static_cast<std::size_t>(index)].shadow_map;
  for (std::size_t i = 0; i < context.scene.shadow_maps.size(); ++i) {
    if (context.scene.shadow_maps[i].light == index && static_cast<int>(i) != own) return static_cast<int>(i);
  }
  const int map = add_shadow_map(context, index, {});
  if (map < 0) return map;
  SceneShadowMap& made = context.scene.shadow_maps[static_cast<std::size_t>(map)];
  made.update = ShadowUpdate::none;
  made.method = kDefaultShadowMethod;  // it has no texels
  return map;
}

void finish_lights(SceneContext& context, const std::vector<NodeId>& appearances) {
  Scene& scene = context.scene;
  cast_for_volumes(context.graph, scene);
  renumber_lights(scene);
  report_absent_lights(context, appearances);
  std::vector<bool> tried(scene.lights.size(), false);
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    SceneShape& shape = scene.shapes[i];
    const auto named = named_lights(context.graph, appearances[i]);
    for (const int index : shape.lights) {
      SceneLight& light = scene.lights[static_cast<std::size_t>(index)];
      if (!receives_from(light, named)) continue;
      if (!tried[static_cast<std::size_t>(index)]) light.shadow_map = make_shadow_map(context, index);
      tried[static_cast<std::size_t>(index)] = true;
      if (light.shadow_map >= 0) shape.receives.push_back({index, light.shadow_map});
    }
  }
}

}  // namespace plugc
