// ScreenEffect: which shader it has, and when it acts.

#include <fmt/format.h>

#include "scene/scene_context.h"

namespace plugc {

void add_screen_effect(SceneContext& context, NodeId node, int transform) {
  const NodeGraph& graph = context.graph;
  context.screen_effects.insert(node);
  const bool switchable = context.slots.may_change(node, "enabled");
  if (!switchable && !context.options.all_branches && !graph.boolean(node, "enabled")) return;
  SceneScreenEffect effect;
  effect.node = node;
  effect.transform = transform;
  effect.shader = usable_shader(context, node);
  if (effect.shader < 0) {
    context.diagnostics.report(DiagnosticId::not_drawn, graph[node].type_span,
                               "this `ScreenEffect` has no `ComposedShader` that can be used, so it changes nothing");
    return;
  }
  effect.label = graph[node].def.empty() ? context.scene.shaders[static_cast<std::size_t>(effect.shader)].label
                                         : std::string(graph[node].def);
  effect.needs_depth = graph.boolean(node, "needsDepth");
  if (switchable) effect.enabled = context.slots.slot(node, "enabled");
  context.scene.screen_effects.push_back(std::move(effect));
}

}  // namespace plugc
