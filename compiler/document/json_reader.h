#pragma once
// The grammar of the JSON encoding: one function a kind of object. The file, statements and nodes are in read_json.cpp,
// values in json_values.cpp.

#include <initializer_list>

#include "document/json_scanner.h"

namespace plugc {

/// Where a list of nodes stands: ROUTE, PROTO and their kind are statements everywhere, nodes in some places only.
enum class NodesAre : std::uint8_t { statements, values };

/// A key of an object and the name that it gives.
struct NamedKey {
  std::string_view key;
  Name* name;
};

class JsonReader {
 public:
  JsonReader(SourceId source, const SourceSet& sources, Diagnostics& diagnostics)
      : build_(source, Encoding::json, sources, diagnostics), scan_(build_) {}

  Document read();

 private:
  // The file
  void read_file();
  void read_x3d(const Name& owner);
  void read_head(const Name& owner);
  void read_head_entry(const Name& owner);
  void read_statements(const Name& owner);

  // Keys
  bool enter(JsonBracket& object, const Name& owner);
  template <typename Read>
  void for_each_object(const Name& owner, Read read);
  void pass_over(const Name& key, std::string_view expected);
  Name read_name(const Name& key);
  bool required(const Name& name, const Name& owner, std::string_view key);
  void read_names(const Name& owner, std::initializer_list<NamedKey> keys);
  Span span_of(const Name& key) const { return scan_.span_from(key.span.begin - 1); }

  // Statements
  bool read_declaration(const Name& key);
  void read_route(const Name& owner);
  void read_import(const Name& owner);
  void read_export(const Name& owner);
  void read_proto(const Name& owner);
  bool read_proto_members(const Name& owner, ProtoSyntax& proto);
  void read_externproto(const Name& owner);
  Range<MappedText> read_urls(const Name& key);
  Range<InterfaceSyntax> read_interfaces(const Name& owner);

  // Nodes
  bool read_nodes(NodesAre nodes, const Name& field);
  bool read_node_object(NodesAre nodes, const Name& field);
  NodeSyntax read_node(const Name& type);
  void read_node_member(const Name& key, NodeSyntax& node, NodeExtras& extras, bool is_instance);
  void read_attribute(const Name& name, NodeExtras& extras);
  void read_child_field(const Name& name);
  bool add_node(NodeSyntax node, NodesAre nodes, const Name& field);
  void add_elsewhere(const NodeSyntax& node);
  void read_source();
  void read_interface(const Name& owner);
  void read_field_value(const Name& owner);
  void read_connections(const Name& owner);

  // Values
  ValueSyntax read_value();
  ValueSyntax read_list();
  ValueSyntax read_node_value();
  bool accept_in_list(ValueSyntax& value, ValueKind kind);
  bool boolean_is_next() const { return scan_.peek_word() == "true" || scan_.peek_word() == "false"; }
  void take_boolean();
  void reject_value();

  DocumentBuilder build_;
  JsonScanner scan_;
  OpenLists<Connection> connections_;
  std::uint32_t depth_ = 0;
};

}  // namespace plugc
