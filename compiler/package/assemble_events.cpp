#include "package/assemble_events.h"

namespace plugc {
namespace {

static_assert(static_cast<int>(ScriptOp::slerp) == static_cast<int>(PackedScriptOp::slerp), "the same list");

std::unique_ptr<PackedScriptT> pack_script(const ScriptProgram& program, SourceList& sources) {
  auto packed = std::make_unique<PackedScriptT>();
  packed->origin = std::make_unique<PackedLineOrigin>(sources.origin(program.span));
  for (const ScriptVariable& variable : program.variables) {
    packed->variables.emplace_back(static_cast<std::uint32_t>(packed->values.size()),
                                   static_cast<std::uint32_t>(variable.initial.size()), variable.field);
    packed->values.insert(packed->values.end(), variable.initial.begin(), variable.initial.end());
  }
  for (const ScriptFunction& function : program.functions)
    packed->functions.emplace_back(function.field, function.value.value_or(kNoSlot), function.time.value_or(kNoSlot),
                                   function.begin, function.end);
  for (const ScriptStep& step : program.steps)
    packed->steps.emplace_back(step.operand, sources.origin(step.span).line(), static_cast<PackedScriptOp>(step.op));
  return packed;
}

}  // namespace

void pack_events(const Scene& scene, SourceList& sources, PackedSceneT& packed) {
  for (const SceneEventNode& node : scene.event_nodes) {
    auto added = std::make_unique<PackedEventNodeT>();
    added->kind = static_cast<PackedEventKind>(node.kind);
    added->inputs = node.inputs;
    added->outputs = node.outputs;
    added->subject = node.subject;
    if (node.script) added->script = pack_script(*node.script, sources);
    packed.event_nodes.push_back(std::move(added));
  }
  for (const SceneRoute& route : scene.routes) packed.routes.emplace_back(route.from, route.to);
}

}  // namespace plugc
