#pragma once
// One geometry node or Background, written in the classic encoding, as a mesh with all that was said about it.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "document/read_document.h"
#include "mesh/mesh.h"

namespace plugc {

struct MadeMesh {
  std::optional<Mesh> mesh;
  std::vector<std::string> messages;  ///< "line:column message [code]"
};

/// The last node of that type at the top of the text, which stands on the second line of its file, from column 1.
/// `make(graph, node, diagnostics)` makes its mesh.
template <typename Make>
MadeMesh make_mesh_from(const std::string& text, std::string_view type, Make make) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const SourceId source = sources.add("test.x3dv", "#X3D V4.0 utf8\n" + text);
  MemoryFiles files;
  const NodeGraph graph = build_graph(read_document(source, sources, diagnostics), "test.x3dv", sources, files, diagnostics);
  MadeMesh result;
  for (const NodeId root : graph.roots())
    if (graph.is(root, type)) result.mesh = make(graph, root, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const Position at = diagnostic.span.valid() ? sources.position(diagnostic.span.source, diagnostic.span.begin) : Position{};
    result.messages.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + " " + diagnostic.message + " [" +
                              std::string(diagnostic_kind(diagnostic.id).code) + "]");
  }
  return result;
}

/// Of a geometry node.
inline MadeMesh make_mesh_from(const std::string& geometry) {
  return make_mesh_from(geometry, "X3DGeometryNode", [](const NodeGraph& graph, NodeId node, Diagnostics& diagnostics) {
    return make_mesh(graph, node, diagnostics);
  });
}

/// The mesh of a node about which nothing may be said.
inline Mesh mesh_from(const std::string& geometry) {
  MadeMesh made = make_mesh_from(geometry);
  EXPECT_EQ(made.messages, std::vector<std::string>{});
  EXPECT_TRUE(made.mesh.has_value());
  return made.mesh.value_or(Mesh{});
}

}  // namespace plugc
