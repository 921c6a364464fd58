// A side has one set of texture coordinates, which all its textures read unless they bring others.

#include "prepare_backdrop.h"

#include <memory>
#include <utility>
#include <vector>

#include "mesh/backdrop.h"
#include "mesh/unit_coords.h"

namespace plugc {
namespace {

std::optional<Mesh> make_part(const NodeGraph& graph, const SceneShape& shape, Diagnostics& diagnostics) {
  if (shape.part == ScenePart::gradient) return make_backdrop_mesh(graph, shape.geometry, shape.part, diagnostics);
  if (shape.textures.empty()) return std::nullopt;
  std::vector<UnitCoords> units;
  for (const TextureUse& use : shape.textures) units.push_back({use.coord, 0});
  const auto side = make_backdrop_mesh(graph, shape.geometry, shape.part, diagnostics);
  return side && !are_plain(units) ? with_unit_coords(*side, units) : side;
}

}  // namespace

void prepare_backdrop(const NodeGraph& graph, SceneParts& parts, VertexBudget& budget, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < parts.shapes.size(); ++i) {
    const SceneShape& shape = parts.scene.shapes[i];
    if (shape.part == ScenePart::world) continue;
    auto mesh = make_part(graph, shape, diagnostics);
    if (mesh && take_vertices(budget, mesh->positions.size(), graph[shape.geometry].type_span, diagnostics))
      parts.shapes[i].mesh = std::make_shared<const Mesh>(std::move(*mesh));
  }
}

}  // namespace plugc
