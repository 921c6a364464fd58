// Plain values are attributes, nodes child elements (ISO/IEC 19776-1). Inside an element: prototypes, interface, IS,
// fieldValues, nodes, routes, code. What no attribute or element may be called is a fieldValue or a ProtoInstance, which
// read as the same.

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "document/layout.h"
#include "document/read_document.h"
#include "document/write_document.h"
#include "document/written_nodes.h"
#include "document/xml_output.h"

namespace plugc {
namespace {

constexpr NumberWords kWords{" ", ", ", "true", "false"};
constexpr std::array<std::string_view, 6> kTakenAttributes = {"DEF", "USE", "containerField", "class", "id", "xmlns"};
constexpr std::array<std::string_view, 9> kTakenElements = {
    "EXPORT", "ExternProtoDeclare", "IMPORT", "IS", "ProtoDeclare", "ProtoInstance", "ROUTE", "field", "fieldValue"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether an element or attribute may be called so; of the characters beyond ASCII all (XML 1.0, 2.3 names a few).
bool is_xml_name(std::string_view name) {
  const auto begins = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (static_cast<unsigned char>(c) & 0x80U) != 0;
  };
  const auto continues = [&](char c) { return begins(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; };
  return !name.empty() && begins(name[0]) && std::all_of(name.begin(), name.end(), continues);
}

bool is_attribute(std::string_view field) {
  return is_xml_name(field) && !contains(kTakenAttributes, field);
}

/// Several strings in one attribute, before its quotes.
std::string quoted(std::string_view string) {
  std::string text(1, '"');
  for (const char c : string) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

class XmlWriter {
 public:
  explicit XmlWriter(const Document& document) : document_(document) {}
  std::string write();

 private:
  // Statements
  void write_head();
  void write_statements(Range<StatementSyntax> statements);
  void write_statement(const StatementSyntax& statement);
  void write_route(const RouteSyntax& route);
  void write_import(const ImportSyntax& import, std::string_view element);
  void write_prototype(const ProtoSyntax& prototype);
  void write_external(const ProtoSyntax& prototype);
  void write_interface(const InterfaceSyntax& field);

  // Nodes
  void write_node(const NodeSyntax& node);
  void write_attributes(const NodeSyntax& node);
  void write_inside(const NodeSyntax& node);
  void write_field(const NodeSyntax& node, const FieldSyntax& field);
  void write_field_value(const FieldSyntax& field);
  void write_connections(const NodeSyntax& node);
  bool is_instance(const NodeSyntax& node) const {
    return node.is_instance || !is_xml_name(node.type.text) || contains(kTakenElements, node.type.text);
  }
  bool as_attribute(const NodeSyntax& node, const FieldSyntax& field) const {
    return !is_instance(node) && is_attribute(field.name.text) && field.value.kind != ValueKind::nodes &&
           field.value.kind != ValueKind::is;
  }

  // Values
  void write_value(std::string_view name, const ValueSyntax& value);
  std::string strings_text(const ValueSyntax& value) const;

  const Document& document_;
  XmlOutput out_;
};

std::string XmlWriter::write() {
  out_.open("X3D");
  out_.optional_attribute("profile", document_.head.profile);
  out_.attribute("version", fmt::format("{}.{}", document_.version_major, document_.version_minor));
  write_head();
  out_.open("Scene");
  write_statements(document_.statements);
  out_.close("Scene");
  out_.close("X3D");
  return out_.take_text();
}

void XmlWriter::write_head() {
  const HeadSyntax& head = document_.head;
  if (head.components.empty() && head.units.empty() && head.metas.empty()) return;
  out_.open("head");
  for (const ComponentSyntax& one : head.components) {
    out_.open("component");
    out_.attribute("name", one.name.text);
    out_.attribute("level", std::to_string(one.level));
    out_.close("component");
  }
  for (const UnitSyntax& one : head.units) {
    out_.open("unit");
    out_.attribute("category", one.category.text);
    out_.attribute("name", one.name.text);
    out_.attribute("conversionFactor", number_text(one.factor));
    out_.close("unit");
  }
  for (const MetaSyntax& one : head.metas) {
    out_.open("meta");
    out_.attribute("name", one.name.text);
    out_.attribute("content", one.content.text);
    out_.close("meta");
  }
  out_.close("head");
}

// Statements

void XmlWriter::write_statements(Range<StatementSyntax> statements) {
  for (const StatementSyntax& one : document_.of(statements)) write_statement(one);
}

void XmlWriter::write_statement(const StatementSyntax& statement) {
  const std::uint32_t index = statement.index;
  switch (statement.kind) {
    case StatementKind::node: return write_node(document_.nodes[index]);
    case StatementKind::route: return write_route(document_.routes[index]);
    case StatementKind::proto: return write_prototype(document_.protos[index]);
    case StatementKind::externproto: return write_external(document_.protos[index]);
    case StatementKind::import: return write_import(document_.imports[index], "IMPORT");
    case StatementKind::export_: return write_import(document_.imports[index], "EXPORT");
  }
}

void XmlWriter::write_route(const RouteSyntax& route) {
  out_.open("ROUTE");
  out_.attribute("fromNode", route.from_node.text);
  out_.attribute("fromField", route.from_field.text);
  out_.attribute("toNode", route.to_node.text);
  out_.attribute("toField", route.to_field.text);
  out_.close("ROUTE");
}

void XmlWriter::write_import(const ImportSyntax& import, std::string_view element) {
  out_.open(element);
  out_.optional_attribute("inlineDEF", import.inline_def);
  out_.attribute(element == "IMPORT" ? "importedDEF" : "localDEF", import.name.text);
  if (import.alias.text != import.name.text) out_.optional_attribute("AS", import.alias);
  out_.close(element);
}

void XmlWriter::write_prototype(const ProtoSyntax& prototype) {
  out_.open("ProtoDeclare");
  out_.attribute("name", prototype.name.text);
  if (!prototype.interface.empty()) {
    out_.open("ProtoInterface");
    for (const InterfaceSyntax& field : document_.of(prototype.interface)) write_interface(field);
    out_.close("ProtoInterface");
  }
  out_.open("ProtoBody");
  write_statements(prototype.body);
  out_.close("ProtoBody");
  out_.close("ProtoDeclare");
}

void XmlWriter::write_external(const ProtoSyntax& prototype) {
  out_.open("ExternProtoDeclare");
  out_.attribute("name", prototype.name.text);
  ValueSyntax urls;
  urls.kind = ValueKind::strings;
  urls.bracketed = true;
  urls.hold(prototype.urls);
  write_value("url", urls);
  for (const InterfaceSyntax& field : document_.of(prototype.interface)) write_interface(field);
  out_.close("ExternProtoDeclare");
}

void XmlWriter::write_interface(const InterfaceSyntax& field) {
  out_.open("field");
  out_.attribute("accessType", to_text(field.access));
  out_.attribute("type", field.type.text);
  out_.attribute("name", field.name.text);
  const ValueKind kind = field.value.kind;
  if (kind == ValueKind::nodes) {
    for (const NodeSyntax& node : document_.of(field.value.nodes())) write_node(node);
  } else if (kind != ValueKind::none && kind != ValueKind::is) {
    write_value("value", field.value);
  }
  out_.close("field");
}

// Nodes

void XmlWriter::write_node(const NodeSyntax& node) {
  const bool instance = is_instance(node);
  const std::string_view element = instance ? "ProtoInstance" : node.type.text;
  out_.open(element);
  if (instance) out_.attribute("name", node.type.text);
  out_.optional_attribute("DEF", node.extras->def);
  out_.optional_attribute("USE", node.extras->use);
  out_.optional_attribute("containerField", node.extras->container_field);
  write_attributes(node);
  write_inside(node);
  out_.close(element);
}

void XmlWriter::write_attributes(const NodeSyntax& node) {
  for (const FieldSyntax& field : document_.of(node.fields)) {
    if (as_attribute(node, field)) write_value(field.name.text, field.value);
  }
}

void XmlWriter::write_inside(const NodeSyntax& node) {
  const auto write_one = [&](const StatementSyntax& one) { write_statement(one); };
  each_statement(document_, node, false, write_one);
  for (const InterfaceSyntax& field : document_.of(node.extras->interface)) write_interface(field);
  write_connections(node);
  for (const FieldSyntax& field : document_.of(node.fields)) write_field(node, field);
  each_statement(document_, node, true, write_one);
  for (const MappedText& code : document_.of(node.extras->cdata)) out_.code(code.text());
}

void XmlWriter::write_field(const NodeSyntax& node, const FieldSyntax& field) {
  if (field.value.kind == ValueKind::is || as_attribute(node, field)) return;
  if (is_instance(node) || field.value.kind != ValueKind::nodes) return write_field_value(field);
  for (const NodeSyntax& child : document_.of(field.value.nodes())) write_node(child);
}

void XmlWriter::write_field_value(const FieldSyntax& field) {
  out_.open("fieldValue");
  out_.attribute("name", field.name.text);
  if (field.value.kind != ValueKind::nodes) {
    write_value("value", field.value);
  } else if (field.value.nodes().empty()) {
    out_.attribute("value", field.value.bracketed ? "" : "NULL");
  }
  for (const NodeSyntax& node : document_.of(field.value.nodes())) write_node(node);
  out_.close("fieldValue");
}

void XmlWriter::write_connections(const NodeSyntax& node) {
  bool any = false;
  each_connection(document_, node, [&](std::string_view node_field, std::string_view proto_field) {
    if (!std::exchange(any, true)) out_.open("IS");
    out_.open("connect");
    out_.attribute("nodeField", node_field);
    out_.attribute("protoField", proto_field);
    out_.close("connect");
  });
  if (any) out_.close("IS");
}

// Values

void XmlWriter::write_value(std::string_view name, const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::numbers:
    case ValueKind::booleans:
      return out_.raw_attribute(name, '"' + numbers_text(document_, value, kWords, out_.level() + 2) + '"');
    case ValueKind::lexical:
    case ValueKind::strings: return out_.raw_attribute(name, strings_text(value));
    default: return out_.raw_attribute(name, "\"\"");
  }
}

/// One string as it is; of a list each in quotes of its own, each in a line of its own where they are long.
std::string XmlWriter::strings_text(const ValueSyntax& value) const {
  const auto strings = document_.of(value.strings());
  if (!value.bracketed && strings.size() == 1) return xml_attribute_text(strings.front().text());
  std::vector<std::string> parts;
  for (const MappedText& string : strings) {
    const std::string part = xml_attribute_text(quoted(string.text()));
    parts.push_back(part.substr(1, part.size() - 2));
  }
  const std::string line = fmt::format("'{}'", fmt::join(parts, " "));
  return fits_line(line, out_.level() + 2) ? line : fmt::format("'{}'", fmt::join(parts, '\n' + indentation(out_.level() + 2)));
}

}  // namespace

std::string write_xml(const Document& document) {
  return XmlWriter(document).write();
}

}  // namespace plugc
