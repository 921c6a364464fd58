// RenderedTexture (X3D 4.1, 18.4.6, and the fields that the reference engine has beside it) and GeneratedCubeMapTexture
// (34.4.2).

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "base/rendered_limits.h"
#include "scene/scene_context.h"

namespace plugc {
namespace {

constexpr double kDefaultSide = 128;

ShadowUpdate read_update(SceneContext& context, NodeId node) {
  const std::string_view update = context.graph.string(node, "update");
  if (update == "ALWAYS") return ShadowUpdate::always;
  if (update == "NEXT_FRAME_ONLY") return ShadowUpdate::next_frame_only;
  context.diagnostics.report(
      DiagnosticId::not_drawn,
      context.graph.is_written(node, "update") ? context.graph.field_span(node, "update") : context.graph[node].type_span,
      fmt::format("a `{}` with `update \"NONE\"` is never drawn, and a white texel stands for it; write `update \"ALWAYS\"`",
                  context.graph[node].info->name));
  return ShadowUpdate::none;
}

/// A side in texels, as the field says it.
std::uint32_t read_side(SceneContext& context, NodeId node, std::string_view field, double written, std::uint32_t largest) {
  const auto side = static_cast<std::uint32_t>(std::clamp(written, 1.0, static_cast<double>(largest)));
  if (written != static_cast<double>(side))
    context.diagnostics.report(DiagnosticId::field_range, context.graph.field_span(node, field),
                               fmt::format("a rendered texture cannot have {} texels along a side; {} is used", written, side));
  return side;
}

/// `dimensions` (width, height, and what needs not be known), else `width` and `height`.
void read_sides(SceneContext& context, NodeId node, SceneRenderedTexture& texture) {
  const NodeGraph& graph = context.graph;
  const auto written = graph.field(node, "dimensions").numbers;
  const bool by_dimensions = graph.is_written(node, "dimensions");
  const auto side = [&](std::string_view field, std::size_t index) {
    if (!by_dimensions) return read_side(context, node, field, graph.integer(node, field), kMaxRenderedSide);
    return read_side(context, node, "dimensions", index < written.size() ? written[index] : kDefaultSide, kMaxRenderedSide);
  };
  texture.width = side("width", 0);
  texture.height = side("height", 1);
}

/// The fields to which ROUTEs lead from an output of the texture.
std::vector<std::uint32_t> slots_behind(SceneContext& context, NodeId node, std::string_view output) {
  std::vector<std::uint32_t> slots;
  for (const GraphRoute& route : context.graph.routes()) {
    if (route.from != node || route.from_field != output) continue;
    if (const std::uint32_t slot = context.slots.declared_slot(route.to, route.to_field); slot != kSceneNoSlot)
      slots.push_back(slot);
  }
  std::ranges::sort(slots);
  return slots;
}

SceneRenderedTexture read_picture(SceneContext& context, NodeId node) {
  const NodeGraph& graph = context.graph;
  SceneRenderedTexture texture;
  read_sides(context, node, texture);
  const auto depth = graph.field(node, "depthMap").numbers;
  if (!depth.empty() && depth.front() != 0) texture.kind = RenderedKind::depth;
  const NodeId viewpoint = graph.child(node, "viewpoint");
  if (graph.is(viewpoint, "X3DViewpointNode")) texture.viewpoint = projector_index(context, viewpoint);
  texture.in_mirror = graph.is(viewpoint, "ViewpointMirror");
  if (texture.in_mirror) texture.distance_from_shape = context.slots.slot(viewpoint, "distanceFromShape");
  texture.own_scene = graph.child(node, "scene").valid();
  const NodeId background = graph.child(node, "background");
  const bool own_background = graph.is(background, "X3DBackgroundNode");
  if (own_background) texture.background_color = context.slots.slot(background, "skyColor");
  texture.own_backdrop = texture.own_scene || own_background;
  texture.rendering_slots = slots_behind(context, node, "rendering");
  texture.viewing_slots = slots_behind(context, node, "viewing");
  texture.projection_slots = slots_behind(context, node, "projection");
  return texture;
}

SceneRenderedTexture read_cube(SceneContext& context, NodeId node) {
  SceneRenderedTexture texture;
  texture.kind = RenderedKind::cube;
  texture.width = read_side(context, node, "size", context.graph.integer(node, "size"), kMaxRenderedCubeSide);
  texture.height = texture.width;
  return texture;
}

}  // namespace

int rendered_texture_index(SceneContext& context, NodeId node) {
  const bool cube = context.graph.is(node, "GeneratedCubeMapTexture");
  if (!cube && !context.graph.is(node, "RenderedTexture")) return -1;
  SceneRenderedTexture texture = cube ? read_cube(context, node) : read_picture(context, node);
  texture.node = node;
  texture.update = read_update(context, node);
  context.scene.rendered_textures.push_back(std::move(texture));
  const int index = static_cast<int>(context.scene.rendered_textures.size() - 1);
  const NodeId background = cube ? NodeId() : context.graph.child(node, "background");
  if (context.graph.is(background, "X3DBackgroundNode"))
    context.own_backgrounds.emplace(index, BoundBackground{background, -1});
  return index;
}

bool bind_in_own_scene(SceneContext& context, NodeId node, int transform, int index) {
  SceneRenderedTexture& texture = context.scene.rendered_textures[static_cast<std::size_t>(index)];
  if (context.graph.is(node, "X3DViewpointNode")) {
    if (texture.viewpoint >= 0) return true;
    context.own_viewpoints.emplace(node, transform);
    texture.viewpoint = projector_index(context, node);
  } else if (context.graph.is(node, "X3DBackgroundNode")) {
    if (!context.own_backgrounds.try_emplace(index, BoundBackground{node, transform}).second) return true;
    texture.background_color = context.slots.slot(node, "skyColor");
  } else if (context.graph.is(node, "ScreenEffect")) {
    context.diagnostics.report(DiagnosticId::not_drawn, context.graph[node].type_span,
                               "a `ScreenEffect` acts on the picture, not on a rendered texture; it is left out");
  } else {
    return false;
  }
  return true;
}

namespace {

/// Another texture that shows the same, whatever that is in another shape.
int copy_of(Scene& scene, int texture, std::map<int, BoundBackground>& own_backgrounds) {
  SceneTexture copy = scene.textures[static_cast<std::size_t>(texture)];
  SceneRenderedTexture rendered = scene.rendered_textures[static_cast<std::size_t>(copy.rendered)];
  const auto background = own_backgrounds.find(copy.rendered);
  copy.rendered = static_cast<int>(scene.rendered_textures.size());
  if (background != own_backgrounds.end()) own_backgrounds.emplace(copy.rendered, background->second);
  scene.rendered_textures.push_back(std::move(rendered));
  scene.textures.push_back(std::move(copy));
  return static_cast<int>(scene.textures.size() - 1);
}

}  // namespace

void separate_mirrors(Scene& scene, std::map<int, BoundBackground>& own_backgrounds) {
  std::set<int> taken;  // textures
  for (SceneShape& shape : scene.shapes) {
    for (TextureUse& use : shape.textures) {
      const int rendered = scene.textures[static_cast<std::size_t>(use.texture)].rendered;
      if (rendered < 0 || !scene.rendered_textures[static_cast<std::size_t>(rendered)].in_mirror) continue;
      if (!taken.insert(use.texture).second) use.texture = copy_of(scene, use.texture, own_backgrounds);
    }
  }
}

namespace {

/// By rendered texture: how deep in one another's scenes it stands.
std::vector<int> nesting_depths(const Scene& scene) {
  std::vector<int> depths(scene.rendered_textures.size(), 0);
  for (const SceneShape& shape : scene.shapes) {  // an outer scene's come before those of the scenes in it
    if (shape.own_scene_of < 0) continue;
    const int outer = depths[static_cast<std::size_t>(shape.own_scene_of)];
    for (const TextureUse& use : shape.textures) {
      const int inner = scene.textures[static_cast<std::size_t>(use.texture)].rendered;
      if (inner > shape.own_scene_of) depths[static_cast<std::size_t>(inner)] = outer + 1;
    }
  }
  return depths;
}

}  // namespace

void sort_rendered_textures(SceneContext& context) {
  Scene& scene = context.scene;
  const std::vector<int> depths = nesting_depths(scene);
  std::vector<std::size_t> order(depths.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return depths[a] > depths[b]; });
  std::vector<SceneRenderedTexture> sorted;
  std::vector<int> places(depths.size());
  for (const std::size_t from : order) {
    places[from] = static_cast<int>(sorted.size());
    sorted.push_back(std::move(scene.rendered_textures[from]));
  }
  scene.rendered_textures = std::move(sorted);
  const auto renumber = [&](int& index) {
    if (index >= 0) index = places[static_cast<std::size_t>(index)];
  };
  for (SceneTexture& texture : scene.textures) renumber(texture.rendered);
  for (SceneShape& shape : scene.shapes) renumber(shape.own_scene_of);
}

}  // namespace plugc
