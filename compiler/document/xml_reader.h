#pragma once
// The grammar of the XML encoding: one function a kind of element. The file and its head are in read_xml.cpp, statements in
// xml_statements.cpp, nodes in xml_nodes.cpp.

#include <initializer_list>

#include "document/document_builder.h"
#include "document/xml_scanner.h"

namespace plugc {

/// An attribute that an element may have, and where it goes: as a name, or as it is written.
struct KnownAttribute {
  std::string_view key;
  Name* name = nullptr;
  XmlAttribute* written = nullptr;
};

/// Each function that reads an element is called behind its tag's name and takes it up to its end.
class XmlReader {
 public:
  XmlReader(SourceId source, const SourceSet& sources, Diagnostics& diagnostics)
      : build_(source, Encoding::xml, sources, diagnostics), scan_(build_) {}

  Document read();

 private:
  // The file
  void read_file();
  bool read_root();
  void read_behind_root();
  void read_x3d();
  void read_x3d_child(bool& found, bool& misplaced);
  void read_head();
  void read_head_entry();
  void read_scene();

  // Attributes and text
  Name name_of(const XmlAttribute& attribute);
  void read_attributes(std::initializer_list<KnownAttribute> known);
  bool required(const Name& name, const Name& element, std::string_view attribute);
  void given_twice(const XmlAttribute& attribute);
  ValueSyntax lexical_value(const XmlAttribute& attribute);
  void reject_text(std::string_view because);
  Span element_span(const Name& tag) const { return scan_.span_from(tag.span.begin - 1); }

  // Statements
  void read_statement(XmlItem item);
  bool read_declaration();
  void read_route();
  void read_import();
  void read_export();
  void read_proto();
  void read_proto_parts(const Name& tag, ProtoSyntax& proto);
  void read_externproto();
  Range<InterfaceSyntax> read_interfaces();

  // Nodes
  NodeSyntax read_node();
  void read_attributes_of_node(NodeExtras& extras);
  void read_attributes_of_instance(NodeSyntax& node, NodeExtras& extras);
  void read_body();
  void read_code(XmlItem item);
  void read_child_node();
  void read_field_value();
  void read_interface();
  void read_value_children(const Name& tag, ValueSyntax& value);
  void read_connections();

  DocumentBuilder build_;
  XmlScanner scan_;
  std::vector<Connection> connections_;  // of the nodes that are open
  std::uint32_t depth_ = 0;
};

}  // namespace plugc
