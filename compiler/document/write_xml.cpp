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

namespace plugc {
namespace {

constexpr NumberWords kWords{" ", ", ", "true", "false"};
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
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

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

/// The text of an attribute in quotes. Line ends and tabs are written by number: parsers make blanks of others.
std::string attribute_text(std::string_view value) {
  const char quote = value.find('"') != std::string_view::npos ? '\'' : '"';
  std::string text(1, quote);
  for (const char c : value) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == quote) {
      text += "&apos;";
    } else if (c == '\n' || c == '\r' || c == '\t') {
      text += fmt::format("&#{};", static_cast<int>(c));
    } else if (is_control(c)) {
      text += kReplacement;
    } else {
      text += c;
    }
  }
  return text + quote;
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
  // Tags
  void open(std::string_view element);
  void attribute(std::string_view name, std::string_view value) { raw_attribute(name, attribute_text(value)); }
  void optional_attribute(std::string_view name, const Name& value) {
    if (!value.empty()) attribute(name, value.text);
  }
  void raw_attribute(std::string_view name, std::string_view quoted);
  void end_tag();
  void close(std::string_view element);

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
  void write_code(std::string_view code);
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
  std::string text_;
  std::size_t level_ = 0;
  std::size_t line_begin_ = 0;
  bool tag_is_open_ = false;  // `<Box size="1 1 1"`: attributes may follow, and `/>` or `>` is not written
  bool code_ends_here_ = false;
};

std::string XmlWriter::write() {
  text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  open("X3D");
  optional_attribute("profile", document_.head.profile);
  attribute("version", fmt::format("{}.{}", document_.version_major, document_.version_minor));
  write_head();
  open("Scene");
  write_statements(document_.statements);
  close("Scene");
  close("X3D");
  return std::move(text_);
}

void XmlWriter::write_head() {
  const HeadSyntax& head = document_.head;
  if (head.components.empty() && head.units.empty() && head.metas.empty()) return;
  open("head");
  for (const ComponentSyntax& one : head.components) {
    open("component");
    attribute("name", one.name.text);
    attribute("level", std::to_string(one.level));
    close("component");
  }
  for (const UnitSyntax& one : head.units) {
    open("unit");
    attribute("category", one.category.text);
    attribute("name", one.name.text);
    attribute("conversionFactor", number_text(one.factor));
    close("unit");
  }
  for (const MetaSyntax& one : head.metas) {
    open("meta");
    attribute("name", one.name.text);
    attribute("content", one.content.text);
    close("meta");
  }
  close("head");
}

// Tags

void XmlWriter::end_tag() {
  if (std::exchange(tag_is_open_, false)) text_ += ">\n";
}

void XmlWriter::open(std::string_view element) {
  end_tag();
  line_begin_ = text_.size();
  text_ += indentation(level_++);
  text_ += '<';
  text_ += element;
  tag_is_open_ = true;
}

void XmlWriter::raw_attribute(std::string_view name, std::string_view quoted) {
  const std::size_t end = text_.size() - line_begin_ + name.size() + std::min(quoted.find('\n'), quoted.size()) + 2;
  if (end > kLineWidth) {
    text_ += '\n';
    line_begin_ = text_.size();
    text_ += indentation(level_ + 1);
  } else {
    text_ += ' ';
  }
  text_.append(name).append("=").append(quoted);
  if (quoted.find('\n') != std::string_view::npos) line_begin_ = text_.rfind('\n') + 1;
}

void XmlWriter::close(std::string_view element) {
  --level_;
  if (std::exchange(tag_is_open_, false)) {
    text_ += "/>\n";
    return;
  }
  if (!std::exchange(code_ends_here_, false)) text_ += indentation(level_);
  text_.append("</").append(element).append(">\n");
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
  open("ROUTE");
  attribute("fromNode", route.from_node.text);
  attribute("fromField", route.from_field.text);
  attribute("toNode", route.to_node.text);
  attribute("toField", route.to_field.text);
  close("ROUTE");
}

void XmlWriter::write_import(const ImportSyntax& import, std::string_view element) {
  open(element);
  optional_attribute("inlineDEF", import.inline_def);
  attribute(element == "IMPORT" ? "importedDEF" : "localDEF", import.name.text);
  if (import.alias.text != import.name.text) optional_attribute("AS", import.alias);
  close(element);
}

void XmlWriter::write_prototype(const ProtoSyntax& prototype) {
  open("ProtoDeclare");
  attribute("name", prototype.name.text);
  if (!prototype.interface.empty()) {
    open("ProtoInterface");
    for (const InterfaceSyntax& field : document_.of(prototype.interface)) write_interface(field);
    close("ProtoInterface");
  }
  open("ProtoBody");
  write_statements(prototype.body);
  close("ProtoBody");
  close("ProtoDeclare");
}

void XmlWriter::write_external(const ProtoSyntax& prototype) {
  open("ExternProtoDeclare");
  attribute("name", prototype.name.text);
  ValueSyntax urls;
  urls.kind = ValueKind::strings;
  urls.bracketed = true;
  urls.hold(prototype.urls);
  write_value("url", urls);
  for (const InterfaceSyntax& field : document_.of(prototype.interface)) write_interface(field);
  close("ExternProtoDeclare");
}

void XmlWriter::write_interface(const InterfaceSyntax& field) {
  open("field");
  attribute("accessType", to_text(field.access));
  attribute("type", field.type.text);
  attribute("name", field.name.text);
  const ValueKind kind = field.value.kind;
  if (kind == ValueKind::nodes) {
    for (const NodeSyntax& node : document_.of(field.value.nodes())) write_node(node);
  } else if (kind != ValueKind::none && kind != ValueKind::is) {
    write_value("value", field.value);
  }
  close("field");
}

// Nodes

void XmlWriter::write_node(const NodeSyntax& node) {
  const bool instance = is_instance(node);
  const std::string_view element = instance ? "ProtoInstance" : node.type.text;
  open(element);
  if (instance) attribute("name", node.type.text);
  optional_attribute("DEF", node.extras->def);
  optional_attribute("USE", node.extras->use);
  optional_attribute("containerField", node.extras->container_field);
  write_attributes(node);
  write_inside(node);
  close(element);
}

void XmlWriter::write_attributes(const NodeSyntax& node) {
  for (const FieldSyntax& field : document_.of(node.fields)) {
    if (as_attribute(node, field)) write_value(field.name.text, field.value);
  }
}

void XmlWriter::write_inside(const NodeSyntax& node) {
  const auto write_if = [&](bool routes) {
    for (const StatementSyntax& one : document_.of(node.extras->statements)) {
      if ((one.kind == StatementKind::route) == routes) write_statement(one);
    }
  };
  write_if(false);
  for (const InterfaceSyntax& field : document_.of(node.extras->interface)) write_interface(field);
  write_connections(node);
  for (const FieldSyntax& field : document_.of(node.fields)) write_field(node, field);
  write_if(true);
  for (const MappedText& code : document_.of(node.extras->cdata)) write_code(code.text());
}

void XmlWriter::write_field(const NodeSyntax& node, const FieldSyntax& field) {
  if (field.value.kind == ValueKind::is || as_attribute(node, field)) return;
  if (is_instance(node) || field.value.kind != ValueKind::nodes) return write_field_value(field);
  for (const NodeSyntax& child : document_.of(field.value.nodes())) write_node(child);
}

void XmlWriter::write_field_value(const FieldSyntax& field) {
  open("fieldValue");
  attribute("name", field.name.text);
  if (field.value.kind != ValueKind::nodes) {
    write_value("value", field.value);
  } else if (field.value.nodes().empty()) {
    attribute("value", field.value.bracketed ? "" : "NULL");
  }
  for (const NodeSyntax& node : document_.of(field.value.nodes())) write_node(node);
  close("fieldValue");
}

void XmlWriter::write_connections(const NodeSyntax& node) {
  bool any = false;
  const auto connect = [&](const Name& field, const ValueSyntax& value) {
    if (value.kind != ValueKind::is) return;
    if (!std::exchange(any, true)) open("IS");
    open("connect");
    attribute("nodeField", field.text);
    attribute("protoField", document_.of(value.strings()).front().text());
    close("connect");
  };
  for (const InterfaceSyntax& field : document_.of(node.extras->interface)) connect(field.name, field.value);
  for (const FieldSyntax& field : document_.of(node.fields)) connect(field.name, field.value);
  if (any) close("IS");
}

/// Ends where the code ends: white space behind it would belong to it, were it no CDATA.
void XmlWriter::write_code(std::string_view code) {
  if (std::exchange(tag_is_open_, false)) text_ += '>';
  code_ends_here_ = true;
  const bool plain = code.find("]]>") == std::string_view::npos && code.find('\r') == std::string_view::npos &&
                     std::none_of(code.begin(), code.end(), is_control);
  if (plain) {
    text_.append("<![CDATA[").append(code).append("]]>");
    return;
  }
  if (text_.back() == '\n') text_.pop_back();
  for (const char c : code) {
    if (c == '&') {
      text_ += "&amp;";
    } else if (c == '<') {
      text_ += "&lt;";
    } else if (c == '>') {
      text_ += "&gt;";
    } else if (c == '\r') {
      text_ += "&#13;";
    } else if (is_control(c)) {
      text_ += kReplacement;
    } else {
      text_ += c;
    }
  }
}

// Values

void XmlWriter::write_value(std::string_view name, const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::numbers:
    case ValueKind::booleans: return raw_attribute(name, '"' + numbers_text(document_, value, kWords, level_ + 2) + '"');
    case ValueKind::lexical:
    case ValueKind::strings: return raw_attribute(name, strings_text(value));
    default: return raw_attribute(name, "\"\"");
  }
}

/// One string as it is; of a list each in quotes of its own, each in a line of its own where they are long.
std::string XmlWriter::strings_text(const ValueSyntax& value) const {
  const auto strings = document_.of(value.strings());
  if (!value.bracketed && strings.size() == 1) return attribute_text(strings.front().text());
  std::vector<std::string> parts;
  for (const MappedText& string : strings) {
    const std::string part = attribute_text(quoted(string.text()));
    parts.push_back(part.substr(1, part.size() - 2));
  }
  const std::string line = fmt::format("'{}'", fmt::join(parts, " "));
  return fits_line(line, level_ + 2) ? line : fmt::format("'{}'", fmt::join(parts, '\n' + indentation(level_ + 2)));
}

}  // namespace

std::string write_xml(const Document& document) {
  return XmlWriter(document).write();
}

}  // namespace plugc
