// The X3D JSON encoding (ISO/IEC 19776-5, draft): `@` before fields with plain values, `-` before fields with nodes, one
// object a node. Routes and prototypes inside a node stand among its `-children`.

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

constexpr NumberWords kWords{", ", ", ", "true", "false"};
constexpr std::array<std::string_view, 5> kTakenFields = {"DEF", "USE", "containerField", "class", "id"};
constexpr std::array<std::string_view, 6> kTakenTypes = {"EXPORT",       "ExternProtoDeclare", "IMPORT",
                                                         "ProtoDeclare", "ProtoInstance",      "ROUTE"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string quoted(std::string_view string) {
  std::string text(1, '"');
  for (const char c : string) {
    switch (c) {
      case '"': text += "\\\""; break;
      case '\\': text += "\\\\"; break;
      case '\n': text += "\\n"; break;
      case '\r': text += "\\r"; break;
      case '\t': text += "\\t"; break;
      case '\0': text += "\\ufffd"; break;
      default:
        text +=
            static_cast<unsigned char>(c) < 0x20 ? fmt::format("\\u{:04x}", static_cast<unsigned char>(c)) : std::string(1, c);
    }
  }
  return text + '"';
}

class JsonWriter {
 public:
  explicit JsonWriter(const Document& document) : document_(document) {}
  std::string write();

 private:
  // Brackets. An item begins a line of its own.
  void open(char bracket);
  void close(char bracket);
  void item();
  void key(std::string_view name);
  void member(std::string_view name, std::string_view text) { key(name), text_ += text; }
  void optional_member(std::string_view name, const Name& value) {
    if (!value.empty()) member(name, quoted(value.text));
  }

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
  void write_list(const std::string& items);
  void write_strings(const std::vector<std::string>& strings);

  const Document& document_;
  std::string text_;
  std::size_t level_ = 0;
  std::vector<std::size_t> open_at_;  // behind each open bracket
  bool is_first_ = true;              // of the innermost bracket nothing is written yet
};

std::string JsonWriter::write() {
  open('{');
  key("X3D");
  open('{');
  member("encoding", "\"UTF-8\"");
  optional_member("@profile", document_.head.profile);
  member("@version", fmt::format("\"{}.{}\"", document_.version_major, document_.version_minor));
  write_head();
  key("Scene");
  write_statements(document_.statements);
  close('}');
  close('}');
  text_ += '\n';
  return std::move(text_);
}

void JsonWriter::write_head() {
  const HeadSyntax& head = document_.head;
  if (head.components.empty() && head.units.empty() && head.metas.empty()) return;
  const auto write_list_of = [&](std::string_view name, const auto& entries, const auto& text_of) {
    if (entries.empty()) return;
    key(name);
    open('[');
    for (const auto& one : entries) item(), text_ += text_of(one);
    close(']');
  };
  key("head");
  open('{');
  write_list_of("component", head.components, [](const ComponentSyntax& one) {
    return fmt::format(R"({{ "@name": {}, "@level": {} }})", quoted(one.name.text), one.level);
  });
  write_list_of("unit", head.units, [](const UnitSyntax& one) {
    return fmt::format(R"({{ "@category": {}, "@name": {}, "@conversionFactor": {} }})", quoted(one.category.text),
                       quoted(one.name.text), number_text(one.factor));
  });
  write_list_of("meta", head.metas, [](const MetaSyntax& one) {
    return fmt::format(R"({{ "@name": {}, "@content": {} }})", quoted(one.name.text), quoted(one.content.text));
  });
  close('}');
}

// Brackets

void JsonWriter::open(char bracket) {
  text_ += bracket;
  ++level_;
  is_first_ = true;
  open_at_.push_back(text_.size());
}

void JsonWriter::close(char bracket) {
  --level_;
  if (!std::exchange(is_first_, false)) text_ += '\n' + indentation(level_);
  text_ += bracket;
  join_lines(text_, open_at_.back());
  open_at_.pop_back();
}

void JsonWriter::item() {
  if (!std::exchange(is_first_, false)) text_ += ',';
  text_ += '\n' + indentation(level_);
}

void JsonWriter::key(std::string_view name) {
  item();
  text_ += quoted(name) + ": ";
}

/// `{ "Box": {` on one line.
void JsonWriter::open_object(std::string_view type) {
  text_ += "{ " + quoted(type) + ": ";
  open('{');
}

void JsonWriter::close_object() {
  close('}');
  text_ += " }";
}

// Statements

/// The value of a Scene or a ProtoBody.
void JsonWriter::write_statements(Range<StatementSyntax> statements) {
  open('{');
  key("-children");
  open('[');
  for (const StatementSyntax& one : document_.of(statements)) item(), write_statement(one);
  close(']');
  close('}');
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
  open_object("ROUTE");
  member("@fromNode", quoted(route.from_node.text));
  member("@fromField", quoted(route.from_field.text));
  member("@toNode", quoted(route.to_node.text));
  member("@toField", quoted(route.to_field.text));
  close_object();
}

void JsonWriter::write_import(const ImportSyntax& import, std::string_view type) {
  open_object(type);
  optional_member("@inlineDEF", import.inline_def);
  member(type == "IMPORT" ? "@importedDEF" : "@localDEF", quoted(import.name.text));
  if (import.alias.text != import.name.text) optional_member("@AS", import.alias);
  close_object();
}

void JsonWriter::write_prototype(const ProtoSyntax& prototype) {
  open_object("ProtoDeclare");
  member("@name", quoted(prototype.name.text));
  if (!prototype.interface.empty()) {
    key("ProtoInterface");
    open('{');
    write_interfaces(prototype.interface);
    close('}');
  }
  key("ProtoBody");
  write_statements(prototype.body);
  close_object();
}

void JsonWriter::write_external(const ProtoSyntax& prototype) {
  open_object("ExternProtoDeclare");
  member("@name", quoted(prototype.name.text));
  std::vector<std::string> urls;
  for (const MappedText& url : document_.of(prototype.urls)) urls.push_back(quoted(url.text()));
  key("@url");
  write_strings(urls);
  write_interfaces(prototype.interface);
  close_object();
}

void JsonWriter::write_interfaces(Range<InterfaceSyntax> interface) {
  if (interface.empty()) return;
  key("field");
  open('[');
  for (const InterfaceSyntax& field : document_.of(interface)) item(), write_interface(field);
  close(']');
}

void JsonWriter::write_interface(const InterfaceSyntax& field) {
  open('{');
  member("@accessType", quoted(to_text(field.access)));
  member("@type", quoted(field.type.text));
  member("@name", quoted(field.name.text));
  const ValueKind kind = field.value.kind;
  if (kind == ValueKind::nodes && !field.value.nodes().empty()) {
    key("-children");
    write_nodes(field.value);
  } else if (kind != ValueKind::none && kind != ValueKind::is && kind != ValueKind::nodes) {
    key("@value");
    write_value(field.value);
  }
  close('}');
}

// Nodes

void JsonWriter::write_node(const NodeSyntax& node) {
  const std::string_view type = node.type.text;
  const bool instance = node.is_instance || contains(kTakenTypes, type) || type.empty() ||
                        std::string_view("@-#$").find(type[0]) != std::string_view::npos || type == "JSON schema" ||
                        type == "encoding";
  open_object(instance ? "ProtoInstance" : type);
  if (instance) member("@name", quoted(type));
  optional_member("@DEF", node.extras->def);
  optional_member("@USE", node.extras->use);
  if (!node.extras->interface.empty()) write_interfaces(node.extras->interface);
  write_connections(node);
  write_fields(node, instance);
  write_field_values(node, instance);
  for (const MappedText& code : document_.of(node.extras->cdata)) write_code(code.text());
  close_object();
}

bool is_key(std::string_view field) {
  return !contains(kTakenFields, field) && field.find(':') == std::string_view::npos;
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
    key(std::string(nodes ? "-" : "@").append(field.name.text));
    write_value(field.value);
  }
  if (!children) write_children(node, nullptr);
}

/// The routes and prototypes of a node with its children, if it has any.
void JsonWriter::write_children(const NodeSyntax& node, const FieldSyntax* field) {
  key("-children");
  open('[');
  const auto write_if = [&](bool routes) {
    for (const StatementSyntax& one : document_.of(node.extras->statements)) {
      if ((one.kind == StatementKind::route) == routes) item(), write_statement(one);
    }
  };
  write_if(false);
  if (field != nullptr) {
    for (const NodeSyntax& child : document_.of(field->value.nodes())) item(), write_node(child);
  }
  write_if(true);
  close(']');
}

void JsonWriter::write_field_values(const NodeSyntax& node, bool instance) {
  bool any = false;
  for (const FieldSyntax& field : document_.of(node.fields)) {
    if (field.value.kind == ValueKind::is || (!instance && is_key(field.name.text))) continue;
    if (!std::exchange(any, true)) {
      key("fieldValue");
      open('[');
    }
    item();
    open('{');
    member("@name", quoted(field.name.text));
    const bool nodes = field.value.kind == ValueKind::nodes && (field.value.bracketed || !field.value.nodes().empty());
    key(nodes ? "-children" : "@value");
    write_value(field.value);
    close('}');
  }
  if (any) close(']');
}

void JsonWriter::write_connections(const NodeSyntax& node) {
  bool any = false;
  const auto connect = [&](const Name& field, const ValueSyntax& value) {
    if (value.kind != ValueKind::is) return;
    if (!std::exchange(any, true)) {
      key("IS");
      open('{');
      key("connect");
      open('[');
    }
    item();
    text_ += fmt::format(R"({{ "@nodeField": {}, "@protoField": {} }})", quoted(field.text),
                         quoted(document_.of(value.strings()).front().text()));
  };
  for (const InterfaceSyntax& field : document_.of(node.extras->interface)) connect(field.name, field.value);
  for (const FieldSyntax& field : document_.of(node.fields)) connect(field.name, field.value);
  if (!any) return;
  close(']');
  close('}');
}

void JsonWriter::write_code(std::string_view code) {
  key("#sourceCode");
  open('[');
  open_at_.back() = 0;  // code keeps its lines
  for (std::size_t begin = 0; begin <= code.size();) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    item();
    text_ += quoted(code.substr(begin, end - begin));
    begin = end + 1;
  }
  close(']');
}

// Values

void JsonWriter::write_value(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::none:
    case ValueKind::is:
    case ValueKind::empty: text_ += "[ ]"; break;
    case ValueKind::nodes: write_nodes(value); break;
    case ValueKind::numbers:
    case ValueKind::booleans: {
      const std::string numbers = numbers_text(document_, value, kWords, level_ + 1);
      value.bracketed || value.count > 1 ? write_list(numbers) : void(text_ += numbers);
      break;
    }
    case ValueKind::lexical:
    case ValueKind::strings: {
      std::vector<std::string> strings;
      for (const MappedText& string : document_.of(value.strings())) strings.push_back(quoted(string.text()));
      value.bracketed || strings.size() != 1 ? write_strings(strings) : void(text_ += strings.front());
    }
  }
}

void JsonWriter::write_nodes(const ValueSyntax& value) {
  const auto nodes = document_.of(value.nodes());
  if (nodes.empty()) {
    text_ += value.bracketed ? "[ ]" : "null";
  } else if (!value.bracketed) {
    write_node(nodes.front());
  } else {
    open('[');
    for (const NodeSyntax& node : nodes) item(), write_node(node);
    close(']');
  }
}

void JsonWriter::write_list(const std::string& items) {
  if (fits_line(items, level_)) {
    text_ += "[ " + items + " ]";
  } else {
    text_ += "[\n" + indentation(level_ + 1) + items + '\n' + indentation(level_) + ']';
  }
}

void JsonWriter::write_strings(const std::vector<std::string>& strings) {
  if (strings.empty()) return void(text_ += "[ ]");
  const std::string line = fmt::format("{}", fmt::join(strings, ", "));
  const std::string between = ",\n" + indentation(level_ + 1);
  write_list(fits_line(line, level_) ? line : fmt::format("{}", fmt::join(strings, between)));
}

}  // namespace

std::string write_json(const Document& document) {
  return JsonWriter(document).write();
}

}  // namespace plugc
