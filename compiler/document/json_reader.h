#pragma once
// The grammar of the JSON encoding: one function a kind of object. The file and its keys are in read_json.cpp;
// json_statements.cpp, json_nodes.cpp and json_values.cpp hold what their names say.

#include <initializer_list>

#include <fmt/format.h>

#include "document/json_scanner.h"

namespace plugc {

/// Where a list of nodes stands: ROUTE, PROTO and their kind are statements everywhere, nodes in some places only.
enum class NodesAre : std::uint8_t { statements, values };

/// A key of an object and the name that it gives.
struct NamedKey {
  std::string_view key;
  Name* name;
};

inline char first_of(const Name& key) {
  return key.empty() ? '\0' : key.text.front();
}

/// `size` of `@size`.
inline Name behind_mark(const Name& key) {
  return {key.text.substr(1), {key.span.source, std::min(key.span.begin + 1, key.span.end), key.span.end}};
}

/// What an encoding as text needs and a scene does not: `#comment`, `$schema`, `JSON schema`, `encoding`.
inline bool is_remark(const Name& key) {
  return first_of(key) == '#' || first_of(key) == '$' || key.text == "JSON schema" || key.text == "encoding";
}

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
  void take_number();
  void take_boolean();
  void reject_value();

  DocumentBuilder build_;
  JsonScanner scan_;
  OpenLists<Connection> connections_;
  std::uint32_t depth_ = 0;
};

/// Reads the owner's value: an object, or each object of a list.
template <typename Read>
void JsonReader::for_each_object(const Name& owner, Read read) {
  if (scan_.next() != '[') return read();
  for (JsonBracket list = scan_.open(); scan_.next_item(list);) {
    if (scan_.next() == '{') {
      read();
    } else {
      scan_.mistake(scan_.next_span(), fmt::format("`{}` holds objects, found {}", shown(owner.text), scan_.describe_next()));
      scan_.skip_value();
    }
  }
}

}  // namespace plugc
