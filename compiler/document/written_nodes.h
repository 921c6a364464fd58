#pragma once
// What all encodings write of a node in the same order.

#include "document/document.h"

namespace plugc {

/// The statements inside a node: its routes, or its prototypes.
template <typename Write>
void each_statement(const Document& document, const NodeSyntax& node, bool routes, Write write) {
  for (const StatementSyntax& one : document.of(node.extras->statements)) {
    if ((one.kind == StatementKind::route) == routes) write(one);
  }
}

/// Each IS of a node: the names of its own field and of the prototype's.
template <typename Write>
void each_connection(const Document& document, const NodeSyntax& node, Write write) {
  const auto write_if = [&](const Name& field, const ValueSyntax& value) {
    if (value.kind == ValueKind::is) write(field.text, document.of(value.strings()).front().text());
  };
  for (const InterfaceSyntax& field : document.of(node.extras->interface)) write_if(field.name, field.value);
  for (const FieldSyntax& field : document.of(node.fields)) write_if(field.name, field.value);
}

}  // namespace plugc
