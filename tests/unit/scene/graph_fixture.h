#pragma once
// A graph built from texts in memory, with what was said about them.

#include <memory>
#include <string>

#include "base/file_access.h"
#include "document/read_document.h"
#include "scene/node_graph.h"

namespace plugc {

struct BuiltGraph {
  SourceSet sources;
  MemoryFiles files;
  Diagnostics diagnostics{sources};
  NodeGraph graph;

  /// `file:line:column: message [code]`, one a line.
  std::string said() const {
    std::string text;
    for (const Diagnostic& one : diagnostics.all()) {
      const std::string whole = to_text(one, sources);
      text += whole.substr(0, whole.find('\n') + 1);
    }
    return text;
  }
  std::string dump() const { return dump_graph(graph, sources); }
  NodeId root(std::size_t i = 0) const { return i < graph.roots().size() ? graph.roots()[i] : NodeId(); }
};

/// `text` is the file `scene`; it may name `files`.
inline std::unique_ptr<BuiltGraph> build(const std::string& text, std::map<std::string, std::string> files = {},
                                         const std::string& scene = "scene.x3dv") {
  auto built = std::make_unique<BuiltGraph>();
  built->files.files = std::move(files);
  const SourceId source = built->sources.add(scene, text);
  Document document = read_document(source, built->sources, built->diagnostics);
  built->graph = build_graph(std::move(document), scene, built->sources, built->files, built->diagnostics);
  return built;
}

/// A classic scene whose statements start in line 2.
inline std::unique_ptr<BuiltGraph> build_classic(const std::string& statements, std::map<std::string, std::string> files = {}) {
  return build("#X3D V3.2 utf8\n" + statements, std::move(files));
}

}  // namespace plugc
