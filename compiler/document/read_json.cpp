// One pass over the text: brackets are entered and left through the scanner, and what stands in them goes straight into the
// Document. Members may come in any order, so what needs another member (the type of a ProtoInstance, the connections of
// an IS) waits until the object ends. Source: ISO/IEC 19776-5 (draft).

#include "document/json_reader.h"

#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/read_document.h"
#include "document/read_lexical.h"

namespace plugc {
namespace {

char first_of(const Name& key) {
  return key.empty() ? '\0' : key.text.front();
}

/// `size` of `@size`.
Name behind_mark(const Name& key) {
  return {key.text.substr(1), {key.span.source, std::min(key.span.begin + 1, key.span.end), key.span.end}};
}

/// What an encoding as text needs and a scene does not: `#comment`, `$schema`, `JSON schema`, `encoding`.
bool is_remark(const Name& key) {
  return first_of(key) == '#' || first_of(key) == '$' || key.text == "JSON schema" || key.text == "encoding";
}

bool is_source(const Name& key) {
  return key.text == "#sourceCode" || key.text == "#sourceText" || key.text == "#cdata";
}

}  // namespace

// The file

Document JsonReader::read() {
  const std::size_t mark = build_.statements.open();
  read_file();
  build_.document.statements = build_.statements.close(mark, build_.document.statement_pool);
  return std::move(build_.document);
}

void JsonReader::read_file() {
  const Name file{"X3D", scan_.next_span()};
  bool found = false;
  Name key;
  JsonBracket object;
  if (!enter(object, file)) return;
  while (scan_.next_member(object, key)) {
    if (key.text != "X3D") {
      scan_.skip_value();
      continue;
    }
    found = true;
    read_x3d(key);
  }
  if (!found) scan_.mistake(file.span, "this object holds no `X3D`");
  if (!scan_.at_end()) scan_.mistake(scan_.next_span(), "text stands behind the scene");
}

void JsonReader::read_x3d(const Name& owner) {
  bool found = false;
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "Scene") {
      found = true;
      read_statements(key);
    } else if (key.text == "@version") {
      const Name version = read_name(key);
      set_version(build_, version.text, version.span);
    } else if (key.text == "head") {
      read_head(key);
    } else if (key.text == "@profile") {
      build_.document.head.profile = read_name(key);
    } else if (first_of(key) == '@') {
      scan_.skip_value();
    } else {
      pass_over(key, "`head` or `Scene`");
    }
  }
  if (!found) scan_.mistake(owner.span, "`X3D` holds no `Scene`");
}

/// `meta`, `component` and `unit`, each an object or a list of them.
void JsonReader::read_head(const Name& owner) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "meta" || key.text == "component" || key.text == "unit") {
      for_each_object(key, [&] { read_head_entry(key); });
    } else {
      scan_.skip_value();
    }
  }
}

void JsonReader::read_head_entry(const Name& owner) {
  Name name, content, category, level, factor, key;
  JsonBracket object;
  const std::array<NamedKey, 5> keys = {
      {{"@name", &name}, {"@content", &content}, {"@category", &category}, {"@level", &level}, {"@conversionFactor", &factor}}};
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    const auto known = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& one) { return one.key == key.text; });
    const bool scalar = scan_.next() != '{' && scan_.next() != '[';
    if (known == keys.end() || !scalar) {
      scan_.skip_value();
    } else {
      *known->name = scan_.take_name();  // a string, or the number that a level is
    }
  }
  const Span span = scan_.span_from(object.place.begin);
  if (name.empty()) return;
  if (owner.text == "component") build_.add_component(name, level.text, span);
  if (owner.text == "unit") build_.add_unit(category, name, factor.text, span);
  if (owner.text == "meta") build_.add_meta({name, content, span});
}

/// `-children` of a Scene or a ProtoBody.
void JsonReader::read_statements(const Name& owner) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (first_of(key) == '-') {
      read_nodes(NodesAre::statements, behind_mark(key));
    } else if (first_of(key) == '@') {
      scan_.skip_value();
    } else {
      pass_over(key, "`-children`");
    }
  }
}

// Keys

/// Enters the object that is the owner's value; anything else is reported and skipped.
bool JsonReader::enter(JsonBracket& object, const Name& owner) {
  if (scan_.next() == '{') {
    object = scan_.open();
    return true;
  }
  scan_.mistake(scan_.next_span(),
                fmt::format("expected an object for `{}`, found {}", shown(owner.text), scan_.describe_next()));
  scan_.skip_value();
  return false;
}

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

/// Skips a member, and reports it unless it is a remark.
void JsonReader::pass_over(const Name& key, std::string_view expected) {
  if (!is_remark(key)) scan_.mistake(key.span, fmt::format("expected {}, found `{}`", expected, shown(key.text)));
  scan_.skip_value();
}

Name JsonReader::read_name(const Name& key) {
  const char next = scan_.next();
  if (next != '"') {
    scan_.mistake(scan_.next_span(),
                  fmt::format("`{}` is a string; put {} into quotes", shown(key.text), scan_.describe_next()));
  }
  if (next != '{' && next != '[') return scan_.take_name();
  scan_.skip_value();
  return {};
}

bool JsonReader::required(const Name& name, const Name& owner, std::string_view key) {
  if (name.empty()) scan_.mistake(owner.span, fmt::format("`{}` needs `{}`", shown(owner.text), key));
  return !name.empty();
}

/// An object of names alone; other keys are passed over.
void JsonReader::read_names(const Name& owner, std::initializer_list<NamedKey> keys) {
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    const auto* known = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& one) { return one.key == key.text; });
    if (known != keys.end()) {
      *known->name = read_name(key);
    } else {
      pass_over(key, fmt::format("a key of `{}`", shown(owner.text)));
    }
  }
}

// Statements

/// The statements that may also stand inside a node.
bool JsonReader::read_declaration(const Name& key) {
  if (key.text == "ROUTE") {
    read_route(key);
  } else if (key.text == "IMPORT") {
    read_import(key);
  } else if (key.text == "EXPORT") {
    read_export(key);
  } else if (key.text == "ProtoDeclare") {
    read_proto(key);
  } else if (key.text == "ExternProtoDeclare") {
    read_externproto(key);
  } else {
    return false;
  }
  return true;
}

void JsonReader::read_route(const Name& owner) {
  RouteSyntax route;
  read_names(owner, {{"@fromNode", &route.from_node},
                     {"@fromField", &route.from_field},
                     {"@toNode", &route.to_node},
                     {"@toField", &route.to_field}});
  route.span = span_of(owner);
  const bool complete = required(route.from_node, owner, "@fromNode") && required(route.from_field, owner, "@fromField") &&
                        required(route.to_node, owner, "@toNode") && required(route.to_field, owner, "@toField");
  if (complete) build_.add_statement(route);
}

void JsonReader::read_import(const Name& owner) {
  ImportSyntax import;
  read_names(owner, {{"@inlineDEF", &import.inline_def},
                     {"@importedDEF", &import.name},
                     {"@exportedDEF", &import.name},
                     {"@AS", &import.alias}});
  import.span = span_of(owner);
  if (import.alias.empty()) import.alias = import.name;
  const bool complete = required(import.inline_def, owner, "@inlineDEF") && required(import.name, owner, "@importedDEF");
  if (complete) build_.add_statement(StatementKind::import, import);
}

void JsonReader::read_export(const Name& owner) {
  ImportSyntax exported;
  read_names(owner, {{"@localDEF", &exported.name}, {"@AS", &exported.alias}});
  exported.span = span_of(owner);
  if (exported.alias.empty()) exported.alias = exported.name;
  if (required(exported.name, owner, "@localDEF")) build_.add_statement(StatementKind::export_, exported);
}

void JsonReader::read_proto(const Name& owner) {
  if (depth_ >= kMaxNesting) {
    build_.too_deep(owner.span);
    return scan_.skip_value();
  }
  ++depth_;
  ProtoSyntax proto;
  const bool has_body = read_proto_members(owner, proto);
  --depth_;
  proto.span = span_of(owner);
  if (!has_body) scan_.mistake(owner.span, "`ProtoDeclare` holds no `ProtoBody`");
  if (required(proto.name, owner, "@name")) build_.add_statement(StatementKind::proto, proto);
}

/// Whether there was a body among them.
bool JsonReader::read_proto_members(const Name& owner, ProtoSyntax& proto) {
  bool has_body = false;
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return false;
  while (scan_.next_member(object, key)) {
    if (key.text == "@name") {
      proto.name = read_name(key);
    } else if (key.text == "ProtoInterface") {
      proto.interface = read_interfaces(key);
    } else if (key.text == "ProtoBody") {
      has_body = true;
      const std::size_t mark = build_.statements.open();
      read_statements(key);
      proto.body = build_.statements.close(mark, build_.document.statement_pool);
    } else {
      scan_.skip_value();  // @appinfo, @documentation
    }
  }
  return has_body;
}

void JsonReader::read_externproto(const Name& owner) {
  ProtoSyntax proto;
  const std::size_t mark = build_.interfaces.open();
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return;
  while (scan_.next_member(object, key)) {
    if (key.text == "@name") {
      proto.name = read_name(key);
    } else if (key.text == "@url") {
      proto.urls = read_urls(key);
    } else if (key.text == "field") {
      for_each_object(key, [&] { read_interface(key); });
    } else {
      scan_.skip_value();  // @appinfo, @documentation
    }
  }
  proto.interface = build_.interfaces.close(mark, build_.document.interfaces);
  proto.span = span_of(owner);
  if (proto.urls.empty()) return scan_.mistake(owner.span, "`ExternProtoDeclare` needs `@url`");
  if (required(proto.name, owner, "@name")) build_.add_statement(StatementKind::externproto, proto);
}

Range<MappedText> JsonReader::read_urls(const Name& key) {
  const ValueSyntax value = read_value();
  if (value.kind != ValueKind::lexical) return value.strings();
  const MappedText text = build_.document.of(value.strings()).front();
  const std::size_t first = build_.document.strings.size();
  for (MappedText& url : read_lexical_strings(text, build_.diagnostics)) build_.add_string(std::move(url), key.span);
  return build_.strings_since(first);
}

/// The value of `ProtoInterface`.
Range<InterfaceSyntax> JsonReader::read_interfaces(const Name& owner) {
  const std::size_t mark = build_.interfaces.open();
  Name key;
  JsonBracket object;
  if (!enter(object, owner)) return {};
  while (scan_.next_member(object, key)) {
    if (key.text == "field") {
      for_each_object(key, [&] { read_interface(key); });
    } else {
      pass_over(key, "`field`");
    }
  }
  return build_.interfaces.close(mark, build_.document.interfaces);
}

// Nodes

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

Document read_json(SourceId source, const SourceSet& sources, Diagnostics& diagnostics) {
  return JsonReader(source, sources, diagnostics).read();
}

}  // namespace plugc
