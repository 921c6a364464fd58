// What an Appearance says beside colours: how alpha counts, how wide lines and large points are, what of faces is filled
// (X3D 4.1, 12.4.1, 12.4.3, 12.4.4, 12.4.8); and the planes that cut shapes (11.4.1). Node fields that choose code, not values,
// keep what the scene says.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene/scene_context.h"

namespace plugc {
namespace {

/// Reports a style of the table that is drawn as another one.
void note_style(SceneContext& context, NodeId node, std::string_view field, std::string_view instead) {
  context.diagnostics.report(DiagnosticId::not_drawn, context.graph.field_span(node, field),
                             fmt::format("`{}` {} is drawn as {}", field, context.graph.integer(node, field), instead));
}

void read_lines(SceneContext& context, NodeId node, SceneStyle& style) {
  constexpr int kFirst = 1, kSolid = 1, kLast = 15;
  constexpr std::array<int, 6> kArrowsAndBreaks = {6, 7, 8, 9, 14, 15};
  if (!context.graph.is(node, "LineProperties") || !context.graph.boolean(node, "applied")) return;
  style.line_width = context.slots.slot(node, "linewidthScaleFactor");
  style.line_type = context.graph.integer(node, "linetype");
  const bool known = style.line_type >= kFirst && style.line_type <= kLast &&
                     std::ranges::find(kArrowsAndBreaks, style.line_type) == kArrowsAndBreaks.end();
  if (known) return;
  note_style(context, node, "linetype", "a solid line");
  style.line_type = kSolid;
}

void read_points(SceneContext& context, NodeId node, SceneStyle& style) {
  if (!context.graph.is(node, "PointProperties")) return;
  style.point_size = context.slots.slot(node, "pointSizeScaleFactor");
  style.point_least = context.slots.slot(node, "pointSizeMinValue");
  style.point_most = context.slots.slot(node, "pointSizeMaxValue");
  style.point_falloff = context.slots.slot(node, "attenuation");
}

void read_fill(SceneContext& context, NodeId node, SceneStyle& style) {
  constexpr int kFirst = 1, kLast = 6;
  if (!context.graph.is(node, "FillProperties")) return;
  style.filled = context.graph.boolean(node, "filled");
  if (!context.graph.boolean(node, "hatched")) return;
  style.hatch_color = context.slots.slot(node, "hatchColor");
  style.hatch = context.graph.integer(node, "hatchStyle");
  if (style.hatch >= kFirst && style.hatch <= kLast) return;
  note_style(context, node, "hatchStyle", "style 1, horizontal lines");
  style.hatch = kFirst;
}

AlphaMode read_alpha_mode(std::string_view name) {
  if (name == "OPAQUE") return AlphaMode::opaque;
  if (name == "MASK") return AlphaMode::mask;
  return name == "BLEND" ? AlphaMode::blend : AlphaMode::automatic;
}

/// The reference engine's older name of it, with words of its own.
AlphaMode read_alpha_channel(std::string_view name) {
  if (name == "NONE") return AlphaMode::opaque;
  if (name == "TEST") return AlphaMode::mask;
  return name == "BLENDING" ? AlphaMode::blend : AlphaMode::automatic;
}

/// Of the texture that the colour of the shape comes from; the first of several counts.
AlphaMode texture_alpha_channel(const NodeGraph& graph, NodeId appearance) {
  NodeId texture = graph.child(appearance, "texture");
  if (graph.is(texture, "MultiTexture") && !graph.children(texture, "texture").empty())
    texture = graph.children(texture, "texture").front();
  return graph.is(texture, "X3DTextureNode") ? read_alpha_channel(graph.string(texture, "alphaChannel")) : AlphaMode::automatic;
}

}  // namespace

void read_style(SceneContext& context, NodeId appearance, SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  shape.alpha_mode = read_alpha_mode(graph.string(appearance, "alphaMode"));
  if (shape.alpha_mode == AlphaMode::automatic) shape.alpha_mode = read_alpha_channel(graph.string(appearance, "alphaChannel"));
  if (shape.alpha_mode == AlphaMode::automatic) shape.alpha_mode = texture_alpha_channel(graph, appearance);
  if (shape.alpha_mode == AlphaMode::mask) shape.alpha_cutoff = context.slots.slot(appearance, "alphaCutoff");
  read_lines(context, graph.child(appearance, "lineProperties"), shape.style);
  read_points(context, graph.child(appearance, "pointProperties"), shape.style);
  read_fill(context, graph.child(appearance, "fillProperties"), shape.style);
}

int add_clip_plane(SceneContext& context, NodeId node, int transform) {
  if (!context.graph.boolean(node, "enabled") && !context.slots.may_change(node, "enabled")) return -1;
  context.scene.clip_planes.push_back({transform, context.slots.slot(node, "plane"), context.slots.slot(node, "enabled")});
  return static_cast<int>(context.scene.clip_planes.size() - 1);
}

}  // namespace plugc
