// Nodes, their fields and interfaces. An attribute is a field, a child element a node in a field that only the scene room can
// name, and text between them is code.

#include <fmt/format.h>

#include "base/limits.h"
#include "document/xml_reader.h"
#include "document/xml_text.h"

namespace plugc {
namespace {

/// Attributes for pages of the web, namespaces and schemas mean nothing to a scene.
bool is_remark(std::string_view attribute) {
  return attribute == "class" || attribute == "id" || attribute == "xmlns" || attribute.find(':') != std::string_view::npos;
}

}  // namespace

NodeSyntax XmlReader::read_node() {
  NodeSyntax node;
  const Name tag = scan_.tag();
  node.type = tag;
  if (depth_ >= kMaxNesting) {
    build_.too_deep(tag.span);
    scan_.skip_element();
    node.span = element_span(tag);
    return node;
  }
  ++depth_;
  NodeExtras extras;
  const OpenBody body = build_.open_body();
  const std::size_t outer_connections = connections_.size();
  if (tag.text == "ProtoInstance") {
    read_attributes_of_instance(node, extras);
  } else {
    read_attributes_of_node(extras);
  }
  read_body();
  if (connections_.size() > outer_connections) {
    build_.add_connections(body, std::span(connections_).subspan(outer_connections));
    connections_.resize(outer_connections);
  }
  build_.close_body(body, node, extras);
  node.span = element_span(tag);
  --depth_;
  return node;
}

void XmlReader::read_attributes_of_node(NodeExtras& extras) {
  for (XmlAttribute attribute; scan_.next_attribute(attribute);) {
    const std::string_view name = attribute.name.text;
    Name* const own = name == "DEF"              ? &extras.def
                      : name == "USE"            ? &extras.use
                      : name == "containerField" ? &extras.container_field
                                                 : nullptr;
    if (own != nullptr) {
      if (own->span.valid()) given_twice(attribute);
      *own = name_of(attribute);
    } else if (!is_remark(name)) {
      build_.add_field({attribute.name, lexical_value(attribute)}, attribute.name.span);
    }
  }
}

void XmlReader::read_attributes_of_instance(NodeSyntax& node, NodeExtras& extras) {
  const Name tag = node.type;
  node.type = {};
  node.is_instance = true;
  read_attributes(
      {{"name", &node.type}, {"DEF", &extras.def}, {"USE", &extras.use}, {"containerField", &extras.container_field}});
  if (extras.use.empty()) required(node.type, tag, "name");
}

void XmlReader::read_body() {
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    if (item != XmlItem::element) {
      read_code(item);
      continue;
    }
    const std::string_view name = scan_.tag().text;
    if (name == "field") {
      read_interface();
    } else if (name == "fieldValue") {
      read_field_value();
    } else if (name == "IS") {
      read_connections();
    } else if (!read_declaration()) {
      read_child_node();
    }
  }
}

void XmlReader::read_code(XmlItem item) {
  const Span span = scan_.text();
  MappedText code;
  if (item == XmlItem::cdata) {
    append_with_line_feeds(code, build_.sources, span);
  } else {
    code = decode_xml(span, build_);
  }
  build_.add_cdata(std::move(code), span);
}

void XmlReader::read_child_node() {
  FieldSyntax field;
  const Name tag = scan_.tag();
  field.name.span = tag.span;
  field.value.kind = ValueKind::nodes;
  field.value.hold(build_.add_node(read_node()));
  field.value.span = element_span(tag);
  build_.add_field(field, tag.span);
}

void XmlReader::read_field_value() {
  const Name tag = scan_.tag();
  FieldSyntax field;
  XmlAttribute value;
  read_attributes({{"name", &field.name}, {.key = "value", .written = &value}});
  const bool named = required(field.name, tag, "name");
  if (value.value.valid()) field.value = lexical_value(value);
  read_value_children(tag, field.value);
  if (field.value.kind == ValueKind::none) {
    return build_.mistake(tag.span, "`<fieldValue>` needs the attribute `value` or nodes inside");
  }
  if (named) build_.add_field(field, field.name.span);
}

void XmlReader::read_interface() {
  const Name tag = scan_.tag();
  InterfaceSyntax field;
  Name access;
  XmlAttribute value;
  read_attributes({{"accessType", &access}, {"type", &field.type}, {"name", &field.name}, {.key = "value", .written = &value}});
  if (required(access, tag, "accessType")) field.access = access_type(build_, access);
  bool complete = required(field.type, tag, "type");
  complete &= required(field.name, tag, "name");
  if (value.value.valid()) field.value = lexical_value(value);
  read_value_children(tag, field.value);
  field.span = element_span(tag);
  if (complete) build_.add_interface(field);
}

/// The nodes inside a `<field>` or `<fieldValue>` are its value.
void XmlReader::read_value_children(const Name& tag, ValueSyntax& value) {
  const std::size_t mark = build_.nodes.open();
  bool any = false;
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    if (item == XmlItem::element) {
      any = true;
      build_.add_list_node(read_node());
    } else {
      reject_text("text stands where only elements may");
    }
  }
  const auto nodes = build_.nodes.close(mark, build_.document.nodes);
  if (!any) return;
  value = {};
  value.kind = ValueKind::nodes;
  value.span = element_span(tag);
  value.hold(nodes);
}

/// The `<IS>` of a node: its connections wait for the node's other fields.
void XmlReader::read_connections() {
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    const Name tag = scan_.tag();
    if (item == XmlItem::element && tag.text == "connect") {
      Connection connect;
      read_attributes({{"nodeField", &connect.node_field}, {"protoField", &connect.proto_field}});
      scan_.skip_element();
      bool complete = required(connect.node_field, tag, "nodeField");
      complete &= required(connect.proto_field, tag, "protoField");
      if (complete) connections_.push_back(connect);
    } else if (item == XmlItem::element) {
      build_.mistake(tag.span, "expected `<connect>` inside `<IS>`");
      scan_.skip_element();
    } else {
      reject_text("expected `<connect>` inside `<IS>`");
    }
  }
}

}  // namespace plugc
