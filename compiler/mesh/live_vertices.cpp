// Every list has one way in which vertices name its elements; a feed is that, list by list.

#include "mesh/live_vertices.h"

#include <algorithm>
#include <numeric>

namespace plugc {
namespace {

ListSlot list_slot(const GeometrySource& source, NodeId node, std::string_view field, std::uint32_t width) {
  if (!node.valid() || !source.graph.has_field(node, field)) return {};
  const VertexField* const list = find_vertex_field(source.changing, node, field);
  if (list == nullptr) return {};
  return {list->slot, width, static_cast<std::uint32_t>(list->start.size() / width)};
}

ListSlot tex_unit_slot(const GeometrySource& source, NodeId node) {
  if (source.graph.is(node, "TextureCoordinate")) return list_slot(source, node, "point", 2);
  if (source.graph.is(node, "TextureCoordinate3D")) return list_slot(source, node, "point", 3);
  if (source.graph.is(node, "TextureCoordinate4D")) return list_slot(source, node, "point", 4);
  return {};
}

std::vector<ListSlot> tex_unit_slots(const GeometrySource& source) {
  const NodeId tex_coord = source.graph.child(source.node, "texCoord");
  if (!source.graph.is(tex_coord, "MultiTextureCoordinate")) return {tex_unit_slot(source, tex_coord)};
  std::vector<ListSlot> units;
  for (const NodeId unit : source.graph.children(tex_coord, "texCoord")) units.push_back(tex_unit_slot(source, unit));
  return units;
}

std::uint32_t attribute_width(const NodeGraph& graph, NodeId node) {
  if (graph.is(node, "Matrix3VertexAttribute")) return 9;
  if (graph.is(node, "Matrix4VertexAttribute")) return 16;
  return static_cast<std::uint32_t>(std::clamp(graph.integer(node, "numComponents"), 1, 4));
}

ListSlot child_slot(const GeometrySource& source, std::string_view child, std::string_view field, std::uint32_t width) {
  return source.graph.has_field(source.node, child) ? list_slot(source, source.graph.child(source.node, child), field, width)
                                                    : ListSlot();
}

/// Of a list with fewer elements than there are vertices, what lies behind its end.
enum class Missing : std::uint8_t { keeps_its_own, takes_the_last };

class FeedMaker {
 public:
  FeedMaker(std::span<const VertexPlaces> vertices, std::vector<VertexFeed>& feeds) : vertices_(vertices), feeds_(feeds) {}

  void add(VertexPart part, unsigned number, const ListSlot& list, std::uint32_t VertexPlaces::*place,
           Missing missing = Missing::keeps_its_own) {
    if (!list.changes()) return;
    VertexFeed feed{part, number, list.slot, list.width, {}};
    feed.elements.reserve(vertices_.size());
    for (const VertexPlaces& vertex : vertices_) {
      const std::uint32_t element = vertex.*place;
      const bool takes_last = missing == Missing::takes_the_last && list.count != 0;
      feed.elements.push_back(element < list.count ? element : takes_last ? list.count - 1 : kKeepsItsOwn);
    }
    feeds_.push_back(std::move(feed));
  }

 private:
  std::span<const VertexPlaces> vertices_;
  std::vector<VertexFeed>& feeds_;
};

}  // namespace

std::span<const double> list_numbers(const GeometrySource& source, NodeId node, std::string_view field) {
  const VertexField* const changing = find_vertex_field(source.changing, node, field);
  return changing != nullptr ? changing->start : source.graph.field(node, field).numbers;
}

std::shared_ptr<const LiveVertices> make_live_points(const GeometrySource& source, std::string_view field,
                                                     std::size_t vertex_count) {
  const ListSlot list = list_slot(source, source.node, field, 2);
  if (!list.changes()) return nullptr;
  auto live = std::make_shared<LiveVertices>();
  live->feeds.push_back({VertexPart::position, 0, list.slot, list.width, std::vector<std::uint32_t>(vertex_count)});
  std::iota(live->feeds[0].elements.begin(), live->feeds[0].elements.end(), 0U);
  live->box_coords = {VertexCoord::bounds_2d};
  return live;
}

bool positions_move(const Mesh& mesh) {
  return mesh.live != nullptr &&
         std::ranges::find(mesh.live->feeds, VertexPart::position, &VertexFeed::part) != mesh.live->feeds.end();
}

std::uint32_t fed_width(const Mesh& mesh, unsigned unit) {
  if (mesh.live == nullptr) return 0;
  for (const VertexFeed& feed : mesh.live->feeds) {
    if (feed.part == VertexPart::tex_coord && feed.number == unit) return feed.width;
  }
  return 0;
}

bool ListSlots::any() const {
  const auto changes = [](const ListSlot& list) { return list.changes(); };
  return coord.changes() || normal.changes() || color.changes() || fog_coord.changes() ||
         std::ranges::any_of(tex_units, changes) ||
         std::ranges::any_of(attributes, [](const auto& named) { return named.second.changes(); });
}

ListSlots read_list_slots(const GeometrySource& source) {
  ListSlots slots;
  if (source.changing.empty()) return slots;
  const NodeGraph& graph = source.graph;
  slots.coord = child_slot(source, "coord", "point", 3);
  slots.normal = child_slot(source, "normal", "vector", 3);
  const bool has_color = graph.has_field(source.node, "color");
  const bool has_alpha = has_color && graph.is(graph.child(source.node, "color"), "ColorRGBA");
  slots.color = child_slot(source, "color", "color", has_alpha ? 4 : 3);
  slots.fog_coord = child_slot(source, "fogCoord", "depth", 1);
  if (graph.has_field(source.node, "texCoord")) slots.tex_units = tex_unit_slots(source);
  if (!graph.has_field(source.node, "attrib")) return slots;
  for (const NodeId node : graph.children(source.node, "attrib")) {
    if (graph.is(node, "X3DVertexAttributeNode"))
      slots.attributes.emplace_back(graph.string(node, "name"), list_slot(source, node, "value", attribute_width(graph, node)));
  }
  return slots;
}

std::vector<VertexFeed> make_feeds(const ListSlots& slots, const Mesh& mesh, std::span<const VertexPlaces> vertices) {
  std::vector<VertexFeed> feeds;
  FeedMaker maker(vertices, feeds);
  maker.add(VertexPart::position, 0, slots.coord, &VertexPlaces::coord);
  if (!mesh.normals.empty()) maker.add(VertexPart::normal, 0, slots.normal, &VertexPlaces::normal);
  if (!mesh.colors.empty()) maker.add(VertexPart::color, 0, slots.color, &VertexPlaces::color);
  for (unsigned unit = 0; unit < std::min(slots.tex_units.size(), mesh.tex_coords.size()); ++unit)
    maker.add(VertexPart::tex_coord, unit, slots.tex_units[unit], &VertexPlaces::tex);
  if (!mesh.fog_coords.empty())
    maker.add(VertexPart::fog_coord, 0, slots.fog_coord, &VertexPlaces::coord, Missing::takes_the_last);
  for (unsigned i = 0; i < mesh.attributes.size(); ++i) {
    const auto named = std::ranges::find(slots.attributes, mesh.attributes[i].name, [](const auto& one) { return one.first; });
    if (named != slots.attributes.end()) maker.add(VertexPart::attribute, i, named->second, &VertexPlaces::coord);
  }
  return feeds;
}

}  // namespace plugc
