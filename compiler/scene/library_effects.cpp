// The stage is the last document of the graph, and known by the name of its Switch.

#include "scene/library_effects.h"

#include <algorithm>

#include "scene/library_stage.h"

namespace plugc {
namespace {

/// The index of the stage's document; one that no node has where there is no stage.
std::uint32_t stage_document(const NodeGraph& graph) {
  const auto roots = graph.roots();
  const auto stage =
      std::find_if(roots.rbegin(), roots.rend(), [&](NodeId root) { return root.valid() && graph[root].def == kLibraryStage; });
  return stage == roots.rend() ? UINT32_MAX : graph[*stage].document;
}

/// Where an effect stands: in a light or a texture, or else somewhere that makes it one of shapes.
NodeId find_holder(const NodeGraph& graph, NodeId effect) {
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const NodeId node{i};
    if (!graph.is(node, "X3DLightNode") && !graph.is(node, "X3DTextureNode")) continue;
    const auto effects = graph.children(node, "effects");
    if (std::ranges::find(effects, effect) != effects.end()) return node;
  }
  return {};
}

}  // namespace

std::vector<NodeId> library_effects(const NodeGraph& graph) {
  std::vector<NodeId> effects;
  const std::uint32_t stage = stage_document(graph);
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const NodeId node{i};
    if (graph.is(node, "Effect") && graph[node].document != stage) effects.push_back(node);
  }
  return effects;
}

std::vector<NodeId> library_stage_roots(const NodeGraph& graph) {
  std::vector<NodeId> roots;
  const std::uint32_t stage = stage_document(graph);
  for (const NodeId root : graph.roots()) {
    if (root.valid() && graph[root].document == stage) roots.push_back(root);
  }
  return roots;
}

void place_alone(SceneContext& context) {
  Scene& scene = context.scene;
  const int effect = effect_index(context, context.options.alone);
  if (effect < 0) return;
  scene.effects[static_cast<std::size_t>(effect)].enabled = kSceneNoSlot;  // what may switch it is no matter here
  const NodeGraph& graph = context.graph;
  const NodeId holder = find_holder(graph, context.options.alone);
  if (graph.is(holder, "X3DLightNode")) {
    for (SceneLight& light : scene.lights) {
      if (light.label == kLibraryLight) light.effects = {effect};
    }
  } else if (graph.is(holder, "X3DTextureNode")) {
    for (SceneTexture& texture : scene.textures) {
      if (graph[texture.node].def == kLibraryTexture) texture.effects = {effect};
    }
  } else {
    for (SceneShape& shape : scene.shapes) {
      const bool on_stage =
          shape.transform >= 0 && scene.transforms[static_cast<std::size_t>(shape.transform)].switch_slot != kSceneNoSlot;
      if (on_stage) shape.effects = {effect};
    }
  }
}

}  // namespace plugc
