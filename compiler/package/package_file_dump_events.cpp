// What changes while a scene of a dump is drawn: its event graph, vertices, what is bound.

#include "package/package_file_dump.h"

namespace plugc {
namespace {

/// Without lines, which are others in each encoding of a scene.
void dump_script(Text& text, const PackedScript& script) {
  for (flatbuffers::uoffset_t i = 0; i < script.variables()->size(); ++i) {
    const PackedScriptVariable& variable = *script.variables()->Get(i);
    const double* const first = script.values()->data() + variable.first();
    line(text, "    variable {}, field {}: {}", i, variable.field(), fmt::join(first, first + variable.count(), " "));
  }
  for (const PackedScriptFunction* function : *script.functions())
    line(text, "    function of field {}: steps {} to {}, value {}, time {}", function->field(), function->begin(),
         function->end(), slot(function->value()), slot(function->time()));
  for (flatbuffers::uoffset_t i = 0; i < script.steps()->size(); ++i) {
    const PackedScriptStep& step = *script.steps()->Get(i);
    line(text, "    step {}: {} {}", i, EnumNamePackedScriptOp(step.op()), step.operand());
  }
}

}  // namespace

void dump_events(Text& text, const PackedScene& scene) {
  for (flatbuffers::uoffset_t i = 0; scene.event_nodes() != nullptr && i < scene.event_nodes()->size(); ++i) {
    const PackedEventNode& node = *scene.event_nodes()->Get(i);
    line(text, "  event node {} {}:{} ->{}{}", i, EnumNamePackedEventKind(node.kind()), slots(*node.inputs()),
         slots(*node.outputs()), node.subject() < 0 ? "" : fmt::format(", subject {}", node.subject()));
    if (node.script() != nullptr) dump_script(text, *node.script());
  }
  if (scene.routes() == nullptr) return;
  for (const PackedRoute* route : *scene.routes()) line(text, "  route slot {} to slot {}", route->from(), route->to());
}

void dump_live_mesh(Text& text, const PackedLiveMesh& live) {
  line(text, "  live mesh {}{}", live.mesh(), live.normals() == nullptr ? "" : ", normals are made");
  for (const PackedVertexFeed* feed : *live.feeds()) {
    line(text, "    {} {} from slot {}, {} numbers each, elements: {}", EnumNamePackedSemantic(feed->semantic()), feed->unit(),
         feed->slot(), feed->width(), sized(*feed->elements(), "numbers"));
  }
  if (const PackedMadeNormals* made = live.normals())
    line(text, "    {} faces{}, least cosine {:g}, corners: {}", made->face_ends()->size(),
         made->clockwise() ? ", clockwise" : "", made->least_cosine(), sized(*made->corners(), "numbers"));
  for (flatbuffers::uoffset_t i = 0; live.box_coords() != nullptr && i < live.box_coords()->size(); ++i)
    line(text, "    coordinates {} lie over the box: {}", live.box_coords()->Get(i)->unit(),
         EnumNamePackedBoxLayout(live.box_coords()->Get(i)->layout()));
  if (live.tangent_unit() >= 0) line(text, "    tangents run along coordinates {}", live.tangent_unit());
}

void dump_bindings_now(Text& text, const PackedScene& scene) {
  if (scene.bound_viewpoint_now() != kNoSlot) line(text, "  slot {} is the bound viewpoint", scene.bound_viewpoint_now());
  if (scene.bound_background() != kNoSlot) line(text, "  slot {} is the bound background", scene.bound_background());
}

}  // namespace plugc
