// The X3D JSON encoding (ISO/IEC 19776-5, draft): `@` before fields with plain values, `-` before fields with nodes, one
// object a node. Routes and prototypes inside a node stand among its `-children`.

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "document/json_output.h"
#include "document/layout.h"
#include "document/read_document.h"
#include "document/write_document.h"
#include "document/written_nodes.h"

namespace plugc {
namespace {

constexpr NumberWords kWords{", ", ", ", "true", "false"};
constexpr std::array<std::string_view, 5> kTakenFields = {"DEF", "USE", "containerField", "class", "id"};
constexpr std::array<std::string_view, 6> kTakenTypes = {"EXPORT",       "ExternProtoDeclare", "IMPORT",
                                                         "ProtoDeclare", "ProtoInstance",      "ROUTE"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_key(std::string_view field) {
  return !contains(kTakenFields, field) && field.find(':') == std::string_view::npos;
}

class JsonWriter {
 public:
  explicit JsonWriter(const Document& document) : document_(document) {}
  std::string write();

 private:
  // Statements
  void write_head();
  void write_statements(Range<StatementSyntax> statements);
  void write_statement(const StatementSyntax& statement);
  void open_object(std::string_view type);
  void close_object();
  void write_route(const RouteSyntax& route);
  void write_import(const ImportSyntax& import, std::string_view type);
  void write_prototype(const ProtoSyntax& prototype);
  void write_external(const ProtoSyntax& prototype);
  void write_interfaces(Range<InterfaceSyntax> interface);
  void write_interface(const InterfaceSyntax& field);

  // Nodes
  void write_node(const NodeSyntax& node);
  void write_fields(const NodeSyntax& node, bool instance);
  void write_field_values(const NodeSyntax& node, bool instance);
  void write_children(const NodeSyntax& node, const FieldSyntax* field);
  void write_connections(const NodeSyntax& node);
  void write_code(std::string_view code);

  // Values
  void write_value(const ValueSyntax& value);
  void write_nodes(const ValueSyntax& value);

  const Document& document_;
  JsonOutput out_;
};

std::string JsonWriter::write() {
  out_.open('{');
  out_.key("X3D");
  out_.open('{');
  out_.member("encoding", "\"UTF-8\"");
  out_.optional_member("@profile", document_.head.profile);
  out_.member("@version", fmt::format("\"{}.{}\"", document_.version_major, document_.version_minor));
  write_head();
  out_.key("Scene");
  write_statements(document_.statements);
  out_.close('}');
  out_.close('}');
  out_.write("\n");
  return out_.take_text();
}

void JsonWriter::write_head() {
  const HeadSyntax& head = document_.head;
  if (head.components.empty() && head.units.empty() && head.metas.empty()) return;
  const auto write_list_of = [&](std::string_view name, const auto& entries, const auto& text_of) {
    if (entries.empty()) return;
    out_.key(name);
    out_.open('[');
    for (const auto& one : entries) out_.item(), out_.write(text_of(one));
    out_.close(']');
  };
  out_.key("head");
  out_.open('{');
  write_list_of("component", head.components, [](const ComponentSyntax& one) {
    return fmt::format(R"({{ "@name": {}, "@level": {} }})", json_quoted(one.name.text), one.level);
  });
  write_list_of("unit", head.units, [](const UnitSyntax& one) {
    return fmt::format(R"({{ "@category": {}, "@name": {}, "@conversionFactor": {} }})", json_quoted(one.category.text),
                       json_quoted(one.name.text), number_text(one.factor));
  });
  write_list_of("meta", head.metas, [](const MetaSyntax& one) {
    return fmt::format(R"({{ "@name": {}, "@content": {} }})", json_quoted(one.name.text), json_quoted(one.content.text));
  });
  out_.close('}');
}

// Statements

/// The value of a Scene or a ProtoBody.
void JsonWriter::write_statements(Range<StatementSyntax> statements) {
  out_.open('{');
  out_.key("-children");
  out_.open('[');
  for (const StatementSyntax& one : document_.of(statements)) out_.item(), write_statement(one);
  out_.close(']');
  out_.close('}');
}

void JsonWriter::write_statement(const StatementSyntax& statement) {
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

void JsonWriter::write_route(const RouteSyntax& route) {
  out_.open_object("ROUTE");
  out_.member("@fromNode", json_quoted(route.from_node.text));
  out_.member("@fromField", json_quoted(route.from_field.text));
  out_.member("@toNode", json_quoted(route.to_node.text));
  out_.member("@toField", json_quoted(route.to_field.text));
  out_.close_object();
}

void JsonWriter::write_import(const ImportSyntax& import, std::string_view type) {
  out_.open_object(type);
  out_.optional_member("@inlineDEF", import.inline_def);
  out_.member(type == "IMPORT" ? "@importedDEF" : "@localDEF", json_quoted(import.name.text));
  if (import.alias.text != import.name.text) out_.optional_member("@AS", import.alias);
  out_.close_object();
}

void JsonWriter::write_prototype(const ProtoSyntax& prototype) {
  out_.open_object("ProtoDeclare");
  out_.member("@name", json_quoted(prototype.name.text));
  if (!prototype.interface.empty()) {
    out_.key("ProtoInterface");
    out_.open('{');
    write_interfaces(prototype.interface);
    out_.close('}');
  }
  out_.key("ProtoBody");
  write_statements(prototype.body);
  out_.close_object();
}

void JsonWriter::write_external(const ProtoSyntax& prototype) {
  out_.open_object("ExternProtoDeclare");
  out_.member("@name", json_quoted(prototype.name.text));
  std::vector<std::string> urls;
  for (const MappedText& url : document_.of(prototype.urls)) urls.push_back(json_quoted(url.text()));
  out_.key("@url");
  out_.write(strings_list_text(urls, ", ", out_.level()));
  write_interfaces(prototype.interface);
  out_.close_object();
}

void JsonWriter::write_interfaces(Range<InterfaceSyntax> interface) {
  if (interface.empty()) return;
  out_.key("field");
  out_.open('[');
  for (const InterfaceSyntax& field : document_.of(interface)) out_.item(), write_interface(field);
  out_.close(']');
}

void JsonWriter::write_interface(const InterfaceSyntax& field) {
  out_.open('{');
  out_.member("@accessType", json_quoted(to_text(field.access)));
  out_.member("@type", json_quoted(field.type.text));
  out_.member("@name", json_quoted(field.name.text));
  const ValueKind kind = field.value.kind;
  if (kind == ValueKind::nodes && !field.value.nodes().empty()) {
    out_.key("-children");
    write_nodes(field.value);
  } else if (kind != ValueKind::none && kind != ValueKind::is && kind != ValueKind::nodes) {
    out_.key("@value");
    write_value(field.value);
  }
  out_.close('}');
}

// Nodes

void JsonWriter::write_node(const NodeSyntax& node) {
  const std::string_view type = node.type.text;
  const bool instance = node.is_instance || contains(kTakenTypes, type) || type.empty() ||
                        std::string_view("@-#$").find(type[0]) != std::string_view::npos || type == "JSON schema" ||
                        type == "encoding";
  out_.open_object(instance ? "ProtoInstance" : type);
  if (instance) out_.member("@name", json_quoted(type));
  out_.optional_member("@DEF", node.extras->def);
  out_.optional_member("@USE", node.extras->use);
  if (!node.extras->interface.empty()) write_interfaces(node.extras->interface);
  write_connections(node);
  write_fields(node, instance);
  write_field_values(node, instance);
  for (const MappedText& code : document_.of(node.extras->cdata)) write_code(code.text());
  out_.close_object();
}

void JsonWriter::write_fields(const NodeSyntax& node, bool instance) {
  bool children = node.extras->statements.empty();  // are written
  for (const FieldSyntax& field : document_.of(node.fields)) {
    if (field.value.kind == ValueKind::is || instance || !is_key(field.name.text)) continue;
    if (!children && field.name.text == "children" && field.value.kind == ValueKind::nodes) {
      children = true;
      write_children(node, &field);
      continue;
    }
    const bool nodes = field.value.kind == ValueKind::nodes;
    out_.key(std::string(nodes ? "-" : "@").append(field.name.text));
    write_value(field.value);
  }
  if (!children) write_children(node, nullptr);
}

/// The routes and prototypes of a node with its children, if it has any.
void JsonWriter::write_children(const NodeSyntax& node, const FieldSyntax* field) {
  out_.key("-children");
  out_.open('[');
  const auto write_one = [&](const StatementSyntax& one) { out_.item(), write_statement(one); };
  each_statement(document_, node, false, write_one);
  if (field != nullptr) {
    for (const NodeSyntax& child : document_.of(field->value.nodes())) out_.item(), write_node(child);
  }
  each_statement(document_, node, true, write_one);
  out_.close(']');
}

void JsonWriter::write_field_values(const NodeSyntax& node, bool instance) {
  bool any = false;
  for (const FieldSyntax& field : document_.of(node.fields)) {
    if (field.value.kind == ValueKind::is || (!instance && is_key(field.name.text))) continue;
    if (!std::exchange(any, true)) {
      out_.key("fieldValue");
      out_.open('[');
    }
    out_.item();
    out_.open('{');
    out_.member("@name", json_quoted(field.name.text));
    const bool nodes = field.value.kind == ValueKind::nodes && (field.value.bracketed || !field.value.nodes().empty());
    out_.key(nodes ? "-children" : "@value");
    write_value(field.value);
    out_.close('}');
  }
  if (any) out_.close(']');
}

void JsonWriter::write_connections(const NodeSyntax& node) {
  bool any = false;
  each_connection(document_, node, [&](std::string_view node_field, std::string_view proto_field) {
    if (!std::exchange(any, true)) {
      out_.key("IS");
      out_.open('{');
      out_.key("connect");
      out_.open('[');
    }
    out_.item();
    out_.write(fmt::format(R"({{ "@nodeField": {}, "@protoField": {} }})", json_quoted(node_field), json_quoted(proto_field)));
  });
  if (!any) return;
  out_.close(']');
  out_.close('}');
}

void JsonWriter::write_code(std::string_view code) {
  out_.key("#sourceCode");
  out_.open('[');
  out_.keep_lines();  // code keeps its lines
  for (std::size_t begin = 0; begin <= code.size();) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    out_.item();
    out_.write(json_quoted(code.substr(begin, end - begin)));
    begin = end + 1;
  }
  out_.close(']');
}

// Values

void JsonWriter::write_value(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::none:
    case ValueKind::is:
    case ValueKind::empty: out_.write("[ ]"); break;
    case ValueKind::nodes: write_nodes(value); break;
    case ValueKind::numbers:
    case ValueKind::booleans: {
      const std::string numbers = numbers_text(document_, value, kWords, out_.level() + 1);
      out_.write(value.bracketed || value.count > 1 ? list_text(numbers, out_.level()) : numbers);
      break;
    }
    case ValueKind::lexical:
    case ValueKind::strings: {
      std::vector<std::string> strings;
      for (const MappedText& string : document_.of(value.strings())) strings.push_back(json_quoted(string.text()));
      const bool list = value.bracketed || strings.size() != 1;
      out_.write(list ? strings_list_text(strings, ", ", out_.level()) : strings.front());
    }
  }
}

void JsonWriter::write_nodes(const ValueSyntax& value) {
  const auto nodes = document_.of(value.nodes());
  if (nodes.empty()) {
    out_.write(value.bracketed ? "[ ]" : "null");
  } else if (!value.bracketed) {
    write_node(nodes.front());
  } else {
    out_.open('[');
    for (const NodeSyntax& node : nodes) out_.item(), write_node(node);
    out_.close(']');
  }
}

}  // namespace

std::string write_json(const Document& document) {
  return JsonWriter(document).write();
}

}  // namespace plugc
