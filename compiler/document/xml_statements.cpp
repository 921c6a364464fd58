// ROUTE, IMPORT, EXPORT and prototypes: each is an element, its parts are attributes in any order.

#include <utility>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/read_lexical.h"
#include "document/xml_reader.h"
#include "document/xml_text.h"

namespace plugc {

void XmlReader::read_statement(XmlItem item) {
  if (item != XmlItem::element) return reject_text("text stands where only elements may");
  if (!read_declaration()) build_.add_statement(read_node());
}

/// The statements that may also stand inside a node.
bool XmlReader::read_declaration() {
  const std::string_view name = scan_.tag().text;
  if (name == "ROUTE") {
    read_route();
  } else if (name == "IMPORT") {
    read_import();
  } else if (name == "EXPORT") {
    read_export();
  } else if (name == "ProtoDeclare") {
    read_proto();
  } else if (name == "ExternProtoDeclare") {
    read_externproto();
  } else {
    return false;
  }
  return true;
}

void XmlReader::read_route() {
  const Name tag = scan_.tag();
  RouteSyntax route;
  read_attributes({{"fromNode", &route.from_node},
                   {"fromField", &route.from_field},
                   {"toNode", &route.to_node},
                   {"toField", &route.to_field}});
  scan_.skip_element();
  route.span = element_span(tag);
  bool complete = required(route.from_node, tag, "fromNode");
  complete &= required(route.from_field, tag, "fromField");
  complete &= required(route.to_node, tag, "toNode");
  complete &= required(route.to_field, tag, "toField");
  if (complete) build_.add_statement(route);
}

void XmlReader::read_import() {
  const Name tag = scan_.tag();
  ImportSyntax import;
  Name exported;
  read_attributes(
      {{"inlineDEF", &import.inline_def}, {"importedDEF", &import.name}, {"exportedDEF", &exported}, {"AS", &import.alias}});
  scan_.skip_element();
  import.span = element_span(tag);
  if (!exported.empty()) import.name = exported;
  if (import.alias.empty()) import.alias = import.name;
  bool complete = required(import.inline_def, tag, "inlineDEF");
  complete &= required(import.name, tag, "importedDEF");
  if (complete) build_.add_statement(StatementKind::import, import);
}

void XmlReader::read_export() {
  const Name tag = scan_.tag();
  ImportSyntax exported;
  read_attributes({{"localDEF", &exported.name}, {"AS", &exported.alias}});
  scan_.skip_element();
  exported.span = element_span(tag);
  if (exported.alias.empty()) exported.alias = exported.name;
  if (required(exported.name, tag, "localDEF")) build_.add_statement(StatementKind::export_, exported);
}

void XmlReader::read_proto() {
  const Name tag = scan_.tag();
  ProtoSyntax proto;
  read_attributes({{"name", &proto.name}});
  const bool named = required(proto.name, tag, "name");
  if (depth_ >= kMaxNesting) {
    build_.too_deep(tag.span);
    return scan_.skip_element();
  }
  ++depth_;
  read_proto_parts(tag, proto);
  --depth_;
  proto.span = element_span(tag);
  if (named) build_.add_statement(StatementKind::proto, proto);
}

void XmlReader::read_proto_parts(const Name& tag, ProtoSyntax& proto) {
  bool found = false;
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    const Name part = scan_.tag();
    if (item != XmlItem::element) {
      reject_text("text stands where only elements may");
    } else if (part.text == "ProtoInterface") {
      proto.interface = read_interfaces();
    } else if (part.text == "ProtoBody") {
      found = true;
      const std::size_t mark = build_.statements.open();
      read_scene();
      proto.body = build_.statements.close(mark, build_.document.statement_pool);
    } else {
      build_.mistake(part.span, fmt::format("expected `<ProtoInterface>` or `<ProtoBody>`, found `<{}>`", shown(part.text)));
      scan_.skip_element();
    }
  }
  if (!found) build_.mistake(tag.span, "`<ProtoDeclare>` holds no `<ProtoBody>`");
}

void XmlReader::read_externproto() {
  const Name tag = scan_.tag();
  ProtoSyntax proto;
  XmlAttribute url;
  read_attributes({{"name", &proto.name}, {.key = "url", .written = &url}});
  bool complete = required(proto.name, tag, "name");
  proto.interface = read_interfaces();
  proto.span = element_span(tag);
  complete &= required(url.name, tag, "url");
  if (!complete) return;
  const std::size_t first = build_.document.strings.size();
  for (MappedText& text : read_lexical_strings(decode_xml(url.value, build_), build_.diagnostics)) {
    build_.add_string(std::move(text), url.value);
  }
  proto.urls = build_.strings_since(first);
  build_.add_statement(StatementKind::externproto, proto);
}

Range<InterfaceSyntax> XmlReader::read_interfaces() {
  const std::size_t mark = build_.interfaces.open();
  for (XmlItem item = scan_.next(); item != XmlItem::end; item = scan_.next()) {
    if (item != XmlItem::element) {
      reject_text("text stands where only elements may");
    } else if (scan_.tag().text == "field") {
      read_interface();
    } else {
      build_.mistake(scan_.tag().span, fmt::format("expected `<field>`, found `<{}>`", shown(scan_.tag().text)));
      scan_.skip_element();
    }
  }
  return build_.interfaces.close(mark, build_.document.interfaces);
}

}  // namespace plugc
