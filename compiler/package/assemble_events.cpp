#include "package/assemble_events.h"

#include "package/pack_script.h"

namespace plugc {

void pack_events(const Scene& scene, SourceList& sources, PackedSceneT& packed) {
  for (const SceneEventNode& node : scene.event_nodes) {
    auto added = std::make_unique<PackedEventNodeT>();
    added->kind = static_cast<PackedEventKind>(node.kind);
    added->inputs = node.inputs;
    added->outputs = node.outputs;
    added->subject = node.subject;
    if (node.script) {
      added->script = pack_script(*node.script, [&](const Span& span) { return sources.origin(span).line(); });
      added->script->origin = std::make_unique<PackedLineOrigin>(sources.origin(node.script->span));
    }
    packed.event_nodes.push_back(std::move(added));
  }
  for (const SceneRoute& route : scene.routes) packed.routes.emplace_back(route.from, route.to);
}

}  // namespace plugc
