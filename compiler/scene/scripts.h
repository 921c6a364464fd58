#pragma once
// Scripts that plugc runs, as nodes of the event graph. Those in other languages stay what they are: nodes that send nothing.

#include <map>
#include <string_view>
#include <vector>

#include "scene/code_file.h"
#include "scene/event_kinds.h"

namespace plugc {

/// A Script in CastleScript, with at least one function.
struct SceneScript {
  ScriptProgram program;
  std::vector<std::string_view> inputs, outputs;  ///< By field: its name where it receives, and where it sends; else "".
  EventNodeInfo info;                             ///< Of these.
};
using Scripts = std::map<NodeId, SceneScript>;

/// Compiles the code of all Scripts: the first url that is in CastleScript. Mistakes are reported; so are what has too many
/// fields and what lies beyond kMaxSceneScriptSize, which do not run.
Scripts read_scripts(const NodeGraph& graph, CodeFiles& files, Diagnostics& diagnostics);

/// Whether code stores to the field when the scene is loaded.
bool sends_at_start(const Scripts& scripts, NodeId node, std::string_view field);

/// What a node reads and sends, by its type or its code. Null for one that makes no events, or only through somebody's hand.
const EventNodeInfo* find_event_node(const NodeGraph& graph, const Scripts& scripts, NodeId node);

}  // namespace plugc
