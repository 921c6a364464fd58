// One walk in the order of the text, with the name spaces that the graph builder has: a file, and each prototype's body, know
// the prototypes declared so far and the type that stands behind each DEF. Nodes, fields and statements change where they
// are in the document's pools; lists that change their length go to the end of them.
//
//     <Shape><Appearance/><Sphere USE="Ball"/></Shape>   ->   Shape { appearance Appearance { } geometry USE Ball }

#include "scene/type_document.h"

#include <algorithm>

#include "scene/document_typer.h"
#include "scene/type_values.h"

namespace plugc {
namespace {

const NodeKind* find_prototype(const NameSpace& names, std::string_view type) {
  for (const NameSpace* at = &names; at != nullptr; at = at->outer) {
    const auto found = at->prototypes.find(type);
    if (found != at->prototypes.end()) return &found->second;
  }
  return nullptr;
}

NodeKind kind_of_type(const NameSpace& names, std::string_view type) {
  if (const NodeKind* prototype = find_prototype(names, type)) return *prototype;
  const NodeInfo* info = find_node_info(type);
  return {info, nullptr, info};
}

}  // namespace

void DocumentTyper::type() {
  NameSpace names;
  document_.statements = type_statements(document_.statements, names);
  const bool is_vrml1 = document_.encoding == Encoding::vrml1;
  if (!is_vrml1 && document_.encoding != Encoding::vrml2) return;
  document_.encoding = Encoding::classic;
  document_.version_major = is_vrml1 ? 4 : 3;  // its unlit materials are X3D 4
  document_.version_minor = 0;
}

// Statements

Range<StatementSyntax> DocumentTyper::type_statements(Range<StatementSyntax> range, NameSpace& names) {
  std::vector<StatementSyntax> typed;
  for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
    const StatementSyntax statement = document_.statement_pool[i];
    typed.push_back(statement);
    switch (statement.kind) {
      case StatementKind::node: type_node(statement.index, names); break;
      case StatementKind::proto: type_prototype(statement.index, false, names); break;
      case StatementKind::externproto: type_prototype(statement.index, true, names); break;
      default: break;
    }
    typed.insert(typed.end(), names.hoisted.begin(), names.hoisted.end());
    names.hoisted.clear();
  }
  return typed.size() == range.count ? range : append(document_.statement_pool, typed);
}

/// Prototypes, then routes; IMPORT and EXPORT go behind the statement that the node stands in.
Range<StatementSyntax> DocumentTyper::type_body_statements(Range<StatementSyntax> range, NameSpace& names) {
  std::vector<StatementSyntax> prototypes, routes;
  for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
    const StatementSyntax statement = document_.statement_pool[i];
    switch (statement.kind) {
      case StatementKind::route: routes.push_back(statement); break;
      case StatementKind::import:
      case StatementKind::export_: names.hoisted.push_back(statement); break;
      default:
        type_prototype(statement.index, statement.kind == StatementKind::externproto, names);
        prototypes.push_back(statement);
    }
  }
  prototypes.insert(prototypes.end(), routes.begin(), routes.end());
  return append(document_.statement_pool, prototypes);
}

void DocumentTyper::type_prototype(std::uint32_t index, bool external, NameSpace& names) {
  NameSpace body;
  body.outer = &names;
  type_interfaces(document_.protos[index].interface, true, !external, body);
  document_.protos[index].body = type_statements(document_.protos[index].body, body);
  names.prototypes[document_.protos[index].name.text] = prototype_kind(document_.protos[index], body);
}

/// An external one stands for what its name says, where that is a node of the table.
NodeKind DocumentTyper::prototype_kind(const ProtoSyntax& prototype, const NameSpace& body) {
  PrototypeFields& fields = prototypes_.emplace_back();
  for (const InterfaceSyntax& field : document_.of(prototype.interface)) {
    const FieldType type = field_type(field.type.text);
    fields.types.emplace(field.name.text, type);
    if (is_node(type) && fields.first_for_nodes.empty()) fields.first_for_nodes = field.name.text;
  }
  NodeKind kind{nullptr, &fields, find_node_info(prototype.name.text)};
  for (const StatementSyntax& statement : document_.of(prototype.body)) {
    if (statement.kind != StatementKind::node) continue;
    kind.stands_for = kind_of_type(body, document_.nodes[statement.index].type.text).stands_for;
    break;
  }
  return kind;
}

void DocumentTyper::type_interfaces(Range<InterfaceSyntax> range, bool of_prototype, bool defaults, NameSpace& names) {
  for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
    InterfaceSyntax field = document_.interfaces[i];
    const FieldType type = field_type(field.type.text);
    const bool has_value = field.access == AccessType::initialize_only || field.access == AccessType::input_output;
    if (of_prototype && field.value.kind == ValueKind::is) field.value = {};
    if (is_node(type) && has_value && defaults && field.value.kind == ValueKind::none) field.value.kind = ValueKind::nodes;
    type_value(document_, field.value, type);
    type_nodes(field.value, names);
    document_.interfaces[i] = field;
  }
}

// Nodes

NodeKind DocumentTyper::type_node(std::uint32_t index, NameSpace& names) {
  NodeSyntax node = document_.nodes[index];
  const NodeKind kind = identify(node, names);
  NodeExtras extras = *node.extras;
  if (!extras.def.empty()) names.definitions[extras.def.text] = {node.type.text, kind};
  extras.statements = type_body_statements(extras.statements, names);
  type_interfaces(extras.interface, false, true, names);
  join_code(extras);
  type_fields(node, extras, kind, names);
  if (node.extras != &kNoExtras || extras.any()) set_extras(node, extras);
  document_.nodes[index] = node;
  return kind;
}

/// Also gives a USE the type of its node. One that cannot be found is called a Group: XML and JSON need a word there.
NodeKind DocumentTyper::identify(NodeSyntax& node, const NameSpace& names) const {
  NodeKind kind;
  const auto found = names.definitions.find(node.extras->use.text);
  if (!node.extras->use.empty() && found != names.definitions.end()) {
    node.type.text = found->second.type;
    kind = found->second.kind;
  } else {
    if (node.type.empty()) node.type.text = "Group";
    kind = kind_of_type(names, node.type.text);
  }
  node.is_instance = node.is_instance || kind.prototype != nullptr;
  return kind;
}

/// The nodes of an interface field; they need no containerField.
void DocumentTyper::type_nodes(const ValueSyntax& value, NameSpace& names) {
  const Range<NodeSyntax> nodes = value.nodes();
  for (std::uint32_t i = nodes.first; i < nodes.first + nodes.count; ++i) {
    type_node(i, names);
    set_container(i, {});
  }
}

Document type_document(Document document) {
  DocumentTyper(document).type();
  return document;
}

}  // namespace plugc
