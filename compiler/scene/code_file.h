#pragma once
// Code that stands in a file of its own or in CDATA, for shaders and Scripts alike.

#include <filesystem>
#include <map>
#include <optional>

#include "base/file_access.h"
#include "scene/node_graph.h"

namespace plugc {

/// The files that a scene's code comes from. Each is read once, however many nodes name it: it counts once, and a mistake in
/// it is told once.
struct CodeFiles {
  SourceSet& sources;
  FileAccess& files;
  Diagnostics& diagnostics;
  std::map<std::filesystem::path, SourceId> known = {};  ///< As resolve_url() makes them.
};

/// The whole text of the file that a url of that node names. Where it cannot be read, `failures` says why; bytes that are no
/// text are reported to `from.diagnostics`.
std::optional<Span> read_code_file(CodeFiles& from, const NodeGraph& graph, NodeId node, const MappedText& url,
                                   Diagnostics& failures);

/// A node's CDATA; XML may divide a text, at a `]]>` for one.
MappedText joined_cdata(const NodeGraph& graph, NodeId node);

}  // namespace plugc
