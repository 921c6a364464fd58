// Nodes and their members. A node may stand in an object of its own, in a list of them, or be `null`.

#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/json_reader.h"

namespace plugc {
namespace {

bool is_source(const Name& key) {
  return key.text == "#sourceCode" || key.text == "#sourceText" || key.text == "#cdata";
}

}  // namespace

/// An object that holds a node, a list of them, or `null`. `field` is the node's field that they stand in, if any. False when
/// nothing for that field is there: comments and statements stand in `-children` also of nodes without that field.
bool JsonReader::read_nodes(NodesAre nodes, const Name& field) {
  if (scan_.next() != '[') return read_node_object(nodes, field);
  bool is_value = false, is_empty = true;
  for (JsonBracket list = scan_.open(); scan_.next_item(list); is_empty = false) {
    if (read_node_object(nodes, field)) is_value = true;
  }
  return is_value || is_empty;
}

/// `{ "Shape": { ... } }`
bool JsonReader::read_node_object(NodesAre nodes, const Name& field) {
  if (scan_.peek_word() == "null") {
    scan_.take_word();
    return true;
  }
  if (scan_.next() != '{') {
    scan_.mistake(scan_.next_span(), fmt::format("expected a node, found {}", scan_.describe_next()));
    scan_.skip_value();
    return false;
  }
  bool is_value = false, any = false;
  Name key;
  for (JsonBracket object = scan_.open(); scan_.next_member(object, key);) {
    if (is_remark(key) || first_of(key) == '@' || first_of(key) == '-' || key.empty()) {
      pass_over(key, "the type of a node");
      continue;
    }
    if (std::exchange(any, true)) {
      scan_.mistake(key.span, fmt::format("give `{}` an object of its own: an object holds one node", shown(key.text)));
    }
    if (!read_declaration(key) && add_node(read_node(key), nodes, field)) is_value = true;
  }
  return is_value;
}

/// Whether the node was added where it stands. One that names another field goes there, as an element of XML does.
bool JsonReader::add_node(NodeSyntax node, NodesAre nodes, const Name& field) {
  const std::string_view named = node.extras->container_field.text;
  if (nodes == NodesAre::statements) {
    build_.add_statement(std::move(node));
  } else if (!field.empty() && !named.empty() && named != field.text) {
    add_elsewhere(node);
    return false;
  } else {
    build_.add_list_node(std::move(node));
  }
  return true;
}

/// Adds a node without the name of a field: the scene room finds it by containerField.
void JsonReader::add_elsewhere(const NodeSyntax& node) {
  FieldSyntax field;
  field.name.span = node.span;
  field.value.kind = ValueKind::nodes;
  field.value.span = node.span;
  field.value.hold(build_.add_node(node));
  build_.add_field(field, field.value.span);
}

NodeSyntax JsonReader::read_node(const Name& type) {
  NodeSyntax node;
  NodeExtras extras;
  node.type = type;
  node.span = type.span;
  if (depth_ >= kMaxNesting) {
    build_.too_deep(type.span);
    scan_.skip_value();
    return node;
  }
  ++depth_;
  const OpenBody body = build_.open_body();
  const std::size_t connections = connections_.open();
  const bool is_instance = node.is_instance = type.text == "ProtoInstance";
  if (is_instance) node.type = {};
  Name key;
  JsonBracket object;
  if (enter(object, type)) {
    while (scan_.next_member(object, key)) read_node_member(key, node, extras, is_instance);
  }
  if (is_instance && extras.use.empty()) required(node.type, type, "@name");
  std::vector<Connection> connects;
  connections_.close(connections, connects);
  build_.add_connections(body, connects);
  build_.close_body(body, node, extras);
  node.span = span_of(type);
  --depth_;
  return node;
}

void JsonReader::read_node_member(const Name& key, NodeSyntax& node, NodeExtras& extras, bool is_instance) {
  if (is_instance && key.text == "@name") {
    node.type = read_name(key);
  } else if (first_of(key) == '@') {
    read_attribute(behind_mark(key), extras);
  } else if (first_of(key) == '-') {
    read_child_field(behind_mark(key));
  } else if (key.text == "field") {
    for_each_object(key, [&] { read_interface(key); });
  } else if (key.text == "fieldValue") {
    for_each_object(key, [&] { read_field_value(key); });
  } else if (key.text == "IS") {
    read_connections(key);
  } else if (is_source(key)) {
    read_source();
  } else {
    pass_over(key, "`@` before the name of a field, or `-` before that of a field for nodes");
  }
}

void JsonReader::read_attribute(const Name& name, NodeExtras& extras) {
  if (name.text == "DEF") {
    extras.def = read_name(name);
  } else if (name.text == "USE") {
    extras.use = read_name(name);
  } else if (name.text == "containerField") {
    extras.container_field = read_name(name);
  } else if (name.text == "class" || name.text == "id" || name.text.find(':') != std::string_view::npos) {
    scan_.skip_value();
  } else {
    const ValueSyntax value = read_value();
    if (value.kind != ValueKind::none) build_.add_field({name, value}, name.span);
  }
}

void JsonReader::read_child_field(const Name& name) {
  FieldSyntax field{name, {}};
  const std::uint32_t begin = scan_.offset();
  const std::size_t mark = build_.nodes.open();
  field.value.kind = ValueKind::nodes;
  field.value.bracketed = scan_.next() == '[';
  const bool is_value = read_nodes(NodesAre::values, name);
  field.value.span = scan_.span_from(begin);
  field.value.hold(build_.nodes.close(mark, build_.document.nodes));
  if (is_value) build_.add_field(field, name.span);
}

void JsonReader::read_interface(const Name& owner) {
  InterfaceSyntax field;
  Name access, key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "@name") {
      field.name = read_name(key);
    } else if (key.text == "@type") {
      field.type = read_name(key);
    } else if (key.text == "@accessType") {
      access = read_name(key);
    } else if (key.text == "@value") {
      field.value = read_value();
    } else if (first_of(key) == '-') {
      field.value = read_node_value();
    } else {
      scan_.skip_value();  // @appinfo, @documentation
    }
  }
  field.span = scan_.span_from(object.place.begin);
  const Name brace{owner.text, object.place};
  if (required(access, brace, "@accessType")) field.access = access_type(build_, access);
  const bool complete = required(field.type, brace, "@type") && required(field.name, brace, "@name");
  if (complete) build_.add_interface(field);
}

void JsonReader::read_field_value(const Name& owner) {
  FieldSyntax field;
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "@name") {
      field.name = read_name(key);
    } else if (key.text == "@value") {
      field.value = read_value();
    } else if (first_of(key) == '-') {
      field.value = read_node_value();
    } else {
      pass_over(key, "`@name`, `@value` or `-children`");
    }
  }
  if (!required(field.name, {owner.text, object.place}, "@name")) return;
  if (field.value.kind == ValueKind::none) return scan_.mistake(object.place, "`fieldValue` needs `@value` or `-children`");
  build_.add_field(field, field.name.span);
}

/// The `IS` of a node; what it connects waits until the node's own fields are known.
void JsonReader::read_connections(const Name& owner) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text != "connect") {
      pass_over(key, "`connect`");
      continue;
    }
    for_each_object(key, [&] {
      Connection connect;
      read_names(key, {{"@nodeField", &connect.node_field}, {"@protoField", &connect.proto_field}});
      const bool complete =
          required(connect.node_field, key, "@nodeField") && required(connect.proto_field, key, "@protoField");
      if (complete) connections_.add(connect);
    });
  }
}

}  // namespace plugc
