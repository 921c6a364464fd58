// Routes, imports and exports, prototypes and their interfaces.

#include "base/limits.h"
#include "document/json_reader.h"
#include "document/read_lexical.h"

namespace plugc {

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

}  // namespace plugc
