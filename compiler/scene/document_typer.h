#pragma once
// The state of type_document(), shared by the files that it is divided into. Nothing else includes this header.

#include <deque>
#include <unordered_map>
#include <vector>

#include "document/document.h"
#include "scene/node_table.h"

namespace plugc {

struct PrototypeFields {
  std::unordered_map<std::string_view, FieldType> types;
  std::string_view first_for_nodes;
};

/// What a node is: one of the table, an instance of a prototype, or (both null) unknown.
struct NodeKind {
  const NodeInfo* info = nullptr;
  const PrototypeFields* prototype = nullptr;
  const NodeInfo* stands_for = nullptr;  // of an instance: the first node of the body, where that is known
};

/// A field while its node is typed: the children that stand in it, and where `nodes` is used, instead of the value's range.
struct TypedField {
  FieldSyntax field;
  std::vector<std::uint32_t> nodes;
};

struct Defined {
  std::string_view type;
  NodeKind kind;
};

struct NameSpace {
  const NameSpace* outer = nullptr;
  std::unordered_map<std::string_view, NodeKind> prototypes;
  std::unordered_map<std::string_view, Defined> definitions;
  std::vector<StatementSyntax> hoisted;  // IMPORT and EXPORT from inside the statement before
};

class DocumentTyper {
 public:
  explicit DocumentTyper(Document& document) : document_(document) {}
  void type();

 private:
  Range<StatementSyntax> type_statements(Range<StatementSyntax> range, NameSpace& names);
  Range<StatementSyntax> type_body_statements(Range<StatementSyntax> range, NameSpace& names);
  void type_prototype(std::uint32_t index, bool external, NameSpace& names);
  NodeKind prototype_kind(const ProtoSyntax& prototype, const NameSpace& body);
  void type_interfaces(Range<InterfaceSyntax> range, bool of_prototype, bool defaults, NameSpace& names);
  NodeKind type_node(std::uint32_t index, NameSpace& names);
  NodeKind identify(NodeSyntax& node, const NameSpace& names) const;
  void type_fields(NodeSyntax& node, NodeExtras& extras, const NodeKind& kind, NameSpace& names);
  void type_children(Range<NodeSyntax> nodes, const NodeKind& holder, std::vector<TypedField>& fields,
                     std::unordered_map<std::string_view, std::size_t>& containers, NameSpace& names);
  void type_named_field(FieldSyntax& field, const NodeKind& holder, NameSpace& names);
  void type_nodes(const ValueSyntax& value, NameSpace& names);
  void set_container(std::uint32_t node, const Name& field);
  void set_extras(NodeSyntax& node, const NodeExtras& extras);
  void name_container(std::uint32_t node, const NodeKind& kind, const NodeKind& holder, std::string_view field);
  std::string_view container_of(const NodeKind& holder, const NodeKind& node, std::string_view written) const;
  FieldType identify(Name& field, bool is, const NodeKind& holder) const;
  void gather_nodes(TypedField& typed, const NodeKind& holder);
  void join_code(NodeExtras& extras);
  void lift_code(const NodeSyntax& node, NodeExtras& extras, std::vector<TypedField>& fields);
  template <typename T>
  static Range<T> append(std::vector<T>& pool, const std::vector<T>& items);

  Document& document_;
  std::deque<PrototypeFields> prototypes_;
};

template <typename T>
Range<T> DocumentTyper::append(std::vector<T>& pool, const std::vector<T>& items) {
  const Range<T> range{static_cast<std::uint32_t>(pool.size()), static_cast<std::uint32_t>(items.size())};
  pool.insert(pool.end(), items.begin(), items.end());
  return range;
}

}  // namespace plugc
