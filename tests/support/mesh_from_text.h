#pragma once
// One geometry node, written in the classic encoding, as a mesh with all that was said about it.

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

/// `geometry` stands on the second line of its file, from column 1.
inline MadeMesh make_mesh_from(const std::string& geometry) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const SourceId source = sources.add("test.x3dv", "#X3D V4.0 utf8\n" + geometry);
  MemoryFiles files;
  const NodeGraph graph = build_graph(read_document(source, sources, diagnostics), "test.x3dv", sources, files, diagnostics);
  MadeMesh result;
  for (const NodeId root : graph.roots())
    if (graph.is(root, "X3DGeometryNode")) result.mesh = make_mesh(graph, root, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const Position at = diagnostic.span.valid() ? sources.position(diagnostic.span.source, diagnostic.span.begin) : Position{};
    result.messages.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + " " + diagnostic.message + " [" +
                              std::string(diagnostic_kind(diagnostic.id).code) + "]");
  }
  return result;
}

/// The mesh of a node about which nothing may be said.
inline Mesh mesh_from(const std::string& geometry) {
  MadeMesh made = make_mesh_from(geometry);
  EXPECT_EQ(made.messages, std::vector<std::string>{});
  EXPECT_TRUE(made.mesh.has_value());
  return made.mesh.value_or(Mesh{});
}

}  // namespace plugc
