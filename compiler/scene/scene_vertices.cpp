// The lists that vertices take their numbers from are nodes of their own below a geometry. Those that some event may change get
// slots; all others are part of a mesh.

#include <algorithm>
#include <array>

#include "scene/scene_context.h"

namespace plugc {
namespace {

/// A node below a geometry, or a geometry, and its list.
struct ListField {
  std::string_view type, field;
};

constexpr std::array<ListField, 12> kLists = {{{"Polypoint2D", "point"},
                                               {"TriangleSet2D", "vertices"},
                                               {"Coordinate", "point"},
                                               {"CoordinateDouble", "point"},
                                               {"Normal", "vector"},
                                               {"Color", "color"},
                                               {"ColorRGBA", "color"},
                                               {"FogCoordinate", "depth"},
                                               {"X3DVertexAttributeNode", "value"},
                                               {"TextureCoordinate", "point"},
                                               {"TextureCoordinate3D", "point"},
                                               {"TextureCoordinate4D", "point"}}};

/// Geometry whose vertices are elements of lists; of other nodes a list is at most something to lay a picture by.
bool has_lists(const NodeGraph& graph, NodeId geometry) {
  constexpr std::array<std::string_view, 5> kTypes = {"X3DComposedGeometryNode", "ElevationGrid", "IndexedLineSet", "LineSet",
                                                      "PointSet"};
  return std::ranges::any_of(kTypes, [&](std::string_view type) { return graph.is(geometry, type); });
}

/// An interpolator's first key, where it alone decides of a list that nobody wrote.
std::span<const double> first_key_sent(const SceneContext& context, NodeId node, std::string_view field) {
  const NodeGraph& graph = context.graph;
  for (const auto& [sender, output] : context.slots.senders(node, field)) {
    if (output != "value_changed" || !graph.is(sender, "X3DInterpolatorNode")) continue;
    const std::span<const double> values = graph.field(sender, "keyValue").numbers;
    const std::size_t keys = graph.field(sender, "key").numbers.size();
    return keys == 0 ? std::span<const double>() : values.first(values.size() / keys);
  }
  return {};
}

void read_list(SceneContext& context, NodeId node, std::string_view field) {
  const NodeGraph& graph = context.graph;
  if (!context.live.contains({node, field})) return;
  if (context.vertex_fields.contains(node)) return;  // a node has one list
  std::span<const double> start = graph.field(node, field).numbers;
  if (start.empty()) start = first_key_sent(context, node, field);
  const std::uint32_t slot = context.slots.slot_of_values(node, field, start);
  if (slot != kSceneNoSlot) context.vertex_fields.emplace(node, VertexField{node, field, slot, start});
}

void read_child(SceneContext& context, NodeId child) {
  if (!child.valid()) return;
  if (context.graph.is(child, "MultiTextureCoordinate")) {
    for (const NodeId unit : context.graph.children(child, "texCoord")) read_child(context, unit);
    return;
  }
  const auto list = std::ranges::find_if(kLists, [&](const ListField& one) { return context.graph.is(child, one.type); });
  if (list != kLists.end()) read_list(context, child, list->field);
}

}  // namespace

void read_vertex_fields(SceneContext& context, NodeId geometry) {
  if (context.live.empty()) return;
  read_child(context, geometry);  // a figure in a plane may be a list itself
  if (!has_lists(context.graph, geometry)) return;
  for (const std::string_view name : {"coord", "normal", "color", "fogCoord", "texCoord", "attrib"}) {
    if (!context.graph.has_field(geometry, name)) continue;
    for (const NodeId child : context.graph.children(geometry, name)) read_child(context, child);
  }
}

}  // namespace plugc
