#pragma once
// What the documents mean as a graph: every USE resolved, every prototype expanded, every Inline loaded, every value typed.

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "document/document.h"
#include "scene/node_table.h"

namespace plugc {

/// Names a node of a NodeGraph. The default value is NULL.
struct NodeId {
  std::uint32_t value = UINT32_MAX;
  bool valid() const { return value != UINT32_MAX; }
  friend auto operator<=>(NodeId, NodeId) = default;
};

/// One typed value. What it views is owned by the graph. Numbers are doubles whatever the type (0 and 1 for booleans,
/// width height components pixels... for images); `numbers` holds component_count(type) per element.
struct FieldValue {
  FieldType type = FieldType::unknown;
  Span span;  ///< Not valid when the value is the table's default.
  std::span<const double> numbers;
  std::span<const MappedText> strings;
  std::span<const NodeId> nodes;
};

/// A field that a node declares itself (Effect, ComposedShader, Script).
struct InterfaceField {
  AccessType access = AccessType::initialize_only;
  FieldType type = FieldType::unknown;
  std::string_view name;
  Span name_span;
  bool has_value = false;
  FieldValue value;
};

struct WrittenField {
  const FieldInfo* info = nullptr;
  FieldValue value;
};

/// Nodes in one field, in order. Most lists hold one node, and then need no memory of their own.
class NodeList {
 public:
  void push_back(NodeId id);
  bool empty() const { return ids().empty(); }
  std::size_t size() const { return ids().size(); }
  std::span<const NodeId> ids() const {
    if (many_) return *many_;
    return {&one_, one_.valid() ? std::size_t{1} : 0};
  }

 private:
  NodeId one_;
  std::unique_ptr<std::vector<NodeId>> many_;
};

/// What few nodes have: fields of their own, and code.
struct OwnDeclarations {
  std::vector<InterfaceField> interface;
  std::span<const MappedText> cdata;
};

/// One node. A node that USE names again is the same GraphNode: one set of field values, many places.
struct GraphNode {
  const NodeInfo* info = nullptr;  ///< Never null: unknown nodes do not enter the graph.
  std::string_view def;
  Span span;  ///< In the file that wrote it (an Inline's or a PROTO body's too).
  Span type_span;
  std::vector<WrittenField> fields;  ///< Only those written; at most one of a name.
  std::uint32_t document = 0;        ///< Index of the file that its urls are relative to.
  std::unique_ptr<OwnDeclarations> own;

  std::span<const InterfaceField> interface() const;
  std::span<const MappedText> cdata() const;  ///< Text directly inside (shader code).
};

struct GraphRoute {
  NodeId from, to;
  std::string_view from_field, to_field;  ///< As in the table or the interface (without `set_` / `_changed`).
  Span span;
};

/// The graph of one scene with all that it includes. Owns its documents and values, which its nodes point into: it moves,
/// but has no copy. No node contains itself, and no path through it is longer than kMaxSceneDepth.
/// The nodes of a file that an Inline loaded are the Inline's `children`. A prototype's instance is the first node of its
/// body; the other nodes of the body are in the graph (their routes work) but in no list.
class NodeGraph {
 public:
  NodeGraph() = default;
  NodeGraph(NodeGraph&&) = default;
  NodeGraph& operator=(NodeGraph&&) = default;

  std::span<const NodeId> roots() const { return roots_; }
  std::span<const GraphRoute> routes() const { return routes_; }
  std::size_t size() const { return nodes_.size(); }
  const GraphNode& operator[](NodeId id) const;
  /// The file that a node's urls are relative to.
  const std::filesystem::path& base_path(NodeId id) const;

  bool is(NodeId id, std::string_view type) const;         ///< False for NULL. `type` may be abstract.
  bool has_field(NodeId id, std::string_view name) const;  ///< The node's type has it, whether or not somebody wrote it.
  /// The value as written or the table's default. The node's type must have the field (checked).
  const FieldValue& field(NodeId id, std::string_view name) const;
  bool is_written(NodeId id, std::string_view name) const;
  Span field_span(NodeId id, std::string_view name) const;  ///< Of the value, or of the node's type when not written.

  bool boolean(NodeId id, std::string_view name) const;
  double number(NodeId id, std::string_view name) const;
  int integer(NodeId id, std::string_view name) const;
  glm::dvec2 vec2(NodeId id, std::string_view name) const;
  glm::dvec3 vec3(NodeId id, std::string_view name) const;  ///< Colours too.
  glm::dvec4 vec4(NodeId id, std::string_view name) const;  ///< Rotations too.
  std::string_view string(NodeId id, std::string_view name) const;
  NodeId child(NodeId id, std::string_view name) const;  ///< SFNode, or NULL.
  std::span<const NodeId> children(NodeId id, std::string_view name) const;

 private:
  friend class GraphBuilder;
  const WrittenField* find_written(NodeId id, std::string_view name) const;
  std::vector<GraphNode> nodes_;
  std::vector<NodeId> roots_;
  std::vector<GraphRoute> routes_;
  std::deque<Document> documents_;
  std::vector<std::filesystem::path> document_paths_;
  std::deque<std::vector<double>> numbers_;  // values that no document holds: XML attributes, defaults
  std::deque<std::vector<MappedText>> strings_;
  std::deque<NodeList> node_lists_;
};

/// Reads the documents that `document` includes (Inline, EXTERNPROTO) through `files` and resolves everything.
/// Mistakes are reported; what is wrong is left out, the rest stays.
/// The roots of `appended`, if there is one, stand behind the scene's own; its names are its own.
NodeGraph build_graph(Document document, const std::filesystem::path& path, SourceSet& sources, FileAccess& files,
                      Diagnostics& diagnostics, std::optional<Document> appended = std::nullopt);

/// `plugc inspect --dump scene`, first half: one line a node, with typed values.
std::string dump_graph(const NodeGraph& graph, const SourceSet& sources);

}  // namespace plugc
