// One walk in the order of the text, with the name spaces that the graph builder has: a file, and each prototype's body, know
// the prototypes declared so far and the type that stands behind each DEF. Nodes, fields and statements change where they
// are in the document's pools; lists that change their length go to the end of them.
//
//     <Shape><Appearance/><Sphere USE="Ball"/></Shape>   ->   Shape { appearance Appearance { } geometry USE Ball }

#include "scene/type_document.h"

#include <algorithm>
#include <array>
#include <deque>
#include <unordered_map>

#include "scene/container_field.h"
#include "scene/event_names.h"
#include "scene/type_values.h"

namespace plugc {
namespace {

constexpr std::string_view kPlainCode = "data:text/plain,";
constexpr std::array<std::string_view, 5> kCodeNodes = {"EffectPart", "PackagedShader", "Script", "ShaderPart",
                                                        "ShaderProgram"};

struct PrototypeFields {
  std::unordered_map<std::string_view, FieldType> types;
  std::string_view first_for_nodes;
};

/// What a node is: one of the table, an instance of a prototype, or (both null) unknown.
struct NodeKind {
  const NodeInfo* info = nullptr;
  const PrototypeFields* prototype = nullptr;
  const NodeInfo* stands_for = nullptr;  // of an instance: the first node of the body, where that is known
};

/// A field while its node is typed: the children that stand in it, and where `nodes` is used, instead of the value's range.
struct TypedField {
  FieldSyntax field;
  std::vector<std::uint32_t> nodes;
};

struct Defined {
  std::string_view type;
  NodeKind kind;
};

struct NameSpace {
  const NameSpace* outer = nullptr;
  std::unordered_map<std::string_view, NodeKind> prototypes;
  std::unordered_map<std::string_view, Defined> definitions;
  std::vector<StatementSyntax> hoisted;  // IMPORT and EXPORT from inside the statement before
};

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

/// Plain values first, then nodes, then IS.
int rank(const FieldSyntax& field) {
  if (field.value.kind == ValueKind::is) return 2;
  return field.value.kind == ValueKind::nodes ? 1 : 0;
}

/// `ecmascript:`, `javascript:` and their kind.
bool begins_with_script(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view scheme = text.substr(0, colon);
  return colon < text.size() && scheme.ends_with("script") &&
         std::all_of(scheme.begin(), scheme.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

class DocumentTyper {
 public:
  explicit DocumentTyper(Document& document) : document_(document) {}
  void type();

 private:
  Range<StatementSyntax> type_statements(Range<StatementSyntax> range, NameSpace& names);
  Range<StatementSyntax> type_body_statements(Range<StatementSyntax> range, NameSpace& names);
  void type_prototype(std::uint32_t index, bool external, NameSpace& names);
  NodeKind prototype_kind(const ProtoSyntax& prototype, const NameSpace& body);
  void type_interfaces(Range<InterfaceSyntax> range, bool of_prototype, bool defaults, NameSpace& names);
  NodeKind type_node(std::uint32_t index, NameSpace& names);
  NodeKind identify(NodeSyntax& node, const NameSpace& names) const;
  void type_fields(NodeSyntax& node, NodeExtras& extras, const NodeKind& kind, NameSpace& names);
  void type_children(Range<NodeSyntax> nodes, const NodeKind& holder, std::vector<TypedField>& fields,
                     std::unordered_map<std::string_view, std::size_t>& containers, NameSpace& names);
  void type_named_field(FieldSyntax& field, const NodeKind& holder, NameSpace& names);
  void type_nodes(const ValueSyntax& value, NameSpace& names);
  void set_container(std::uint32_t node, const Name& field);
  void set_extras(NodeSyntax& node, const NodeExtras& extras);
  void name_container(std::uint32_t node, const NodeKind& kind, const NodeKind& holder, std::string_view field);
  std::string_view container_of(const NodeKind& holder, const NodeKind& node, std::string_view written) const;
  FieldType identify(Name& field, bool is, const NodeKind& holder) const;
  void gather_nodes(TypedField& typed, const NodeKind& holder);
  void join_code(NodeExtras& extras);
  void lift_code(const NodeSyntax& node, NodeExtras& extras, std::vector<TypedField>& fields);
  template <typename T>
  static Range<T> append(std::vector<T>& pool, const std::vector<T>& items);

  Document& document_;
  std::deque<PrototypeFields> prototypes_;
};

template <typename T>
Range<T> DocumentTyper::append(std::vector<T>& pool, const std::vector<T>& items) {
  const Range<T> range{static_cast<std::uint32_t>(pool.size()), static_cast<std::uint32_t>(items.size())};
  pool.insert(pool.end(), items.begin(), items.end());
  return range;
}

void DocumentTyper::type() {
  NameSpace names;
  document_.statements = type_statements(document_.statements, names);
  if (document_.encoding != Encoding::vrml2) return;
  document_.encoding = Encoding::classic;
  document_.version_major = 3;
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

void DocumentTyper::type_fields(NodeSyntax& node, NodeExtras& extras, const NodeKind& kind, NameSpace& names) {
  std::vector<TypedField> fields;
  std::unordered_map<std::string_view, std::size_t> containers;  // fields that child elements may join
  for (std::uint32_t i = node.fields.first; i < node.fields.first + node.fields.count; ++i) {
    FieldSyntax field = document_.fields[i];
    if (field.name.empty()) {
      type_children(field.value.nodes(), kind, fields, containers, names);
    } else if (field.value.kind != ValueKind::none) {
      type_named_field(field, kind, names);
      if (field.value.kind == ValueKind::nodes || field.value.kind == ValueKind::empty)
        containers[field.name.text] = fields.size();
      fields.push_back({field, {}});
    }
  }
  for (TypedField& field : fields) gather_nodes(field, kind);
  const auto* code_node =
      kind.info == nullptr ? kCodeNodes.begin() : std::find(kCodeNodes.begin(), kCodeNodes.end(), kind.info->name);
  if (kind.prototype == nullptr && code_node != kCodeNodes.end()) lift_code(node, extras, fields);
  std::stable_sort(fields.begin(), fields.end(),
                   [](const TypedField& a, const TypedField& b) { return rank(a.field) < rank(b.field); });
  node.fields = {static_cast<std::uint32_t>(document_.fields.size()), static_cast<std::uint32_t>(fields.size())};
  for (const TypedField& typed : fields) document_.fields.push_back(typed.field);
}

/// Child elements: each joins the nodes of its field.
void DocumentTyper::type_children(Range<NodeSyntax> nodes, const NodeKind& holder, std::vector<TypedField>& fields,
                                  std::unordered_map<std::string_view, std::size_t>& containers, NameSpace& names) {
  for (std::uint32_t i = nodes.first; i < nodes.first + nodes.count; ++i) {
    const NodeKind kind = type_node(i, names);
    const Span span = document_.nodes[i].span;
    const std::string_view name = container_of(holder, kind, document_.nodes[i].extras->container_field.text);
    name_container(i, kind, holder, name);
    const auto [known, is_new] = containers.try_emplace(name, fields.size());
    if (is_new) fields.push_back({{{name, span}, {}}, {}});
    TypedField& typed = fields[known->second];
    ValueSyntax& value = typed.field.value;
    if (is_new) value.span = span;
    for (std::uint32_t node = 0; node < value.nodes().count; ++node) typed.nodes.push_back(value.first + node);
    value.count = 0;
    typed.nodes.push_back(i);
  }
}

/// Gives the nodes of a field a range of their own.
void DocumentTyper::gather_nodes(TypedField& typed, const NodeKind& holder) {
  if (typed.nodes.empty()) return;
  ValueSyntax& value = typed.field.value;
  value.kind = ValueKind::nodes;
  value.hold(Range<NodeSyntax>{typed.nodes.front(), static_cast<std::uint32_t>(typed.nodes.size())});
  if (typed.nodes.size() > 1) {
    value.bracketed = true;
    value.first = static_cast<std::uint32_t>(document_.nodes.size());
    for (const std::uint32_t node : typed.nodes) document_.nodes.push_back(NodeSyntax(document_.nodes[node]));
  }
  type_value(document_, value, identify(typed.field.name, false, holder));
}

void DocumentTyper::type_named_field(FieldSyntax& field, const NodeKind& holder, NameSpace& names) {
  type_value(document_, field.value, identify(field.name, field.value.kind == ValueKind::is, holder));
  const Range<NodeSyntax> nodes = field.value.nodes();
  for (std::uint32_t i = nodes.first; i < nodes.first + nodes.count; ++i) {
    const NodeKind kind = type_node(i, names);
    name_container(i, kind, holder, field.name.text);
  }
}

/// The nodes of an interface field; they need no containerField.
void DocumentTyper::type_nodes(const ValueSyntax& value, NameSpace& names) {
  const Range<NodeSyntax> nodes = value.nodes();
  for (std::uint32_t i = nodes.first; i < nodes.first + nodes.count; ++i) {
    type_node(i, names);
    set_container(i, {});
  }
}

// Fields

/// Keeps a containerField only where the node would not come to its field without.
void DocumentTyper::name_container(std::uint32_t node, const NodeKind& kind, const NodeKind& holder, std::string_view field) {
  const bool by_itself = holder.prototype != nullptr || container_of(holder, kind, "") == field;
  set_container(node, by_itself ? Name{} : Name{field, document_.nodes[node].span});
}

void DocumentTyper::set_container(std::uint32_t node, const Name& field) {
  if (document_.nodes[node].extras->container_field.text == field.text) return;
  NodeExtras extras = *document_.nodes[node].extras;
  extras.container_field = field;
  set_extras(document_.nodes[node], extras);
}

void DocumentTyper::set_extras(NodeSyntax& node, const NodeExtras& extras) {
  node.extras = extras.any() ? &document_.extras.emplace_back(extras) : &kNoExtras;
}

std::string_view DocumentTyper::container_of(const NodeKind& holder, const NodeKind& node, std::string_view written) const {
  if (holder.prototype != nullptr) {
    const auto named = holder.prototype->types.find(written);
    if (named != holder.prototype->types.end() && is_node(named->second)) return named->first;
    if (!holder.prototype->first_for_nodes.empty()) return holder.prototype->first_for_nodes;
  }
  if (!written.empty()) {
    const FieldInfo* named = holder.info == nullptr ? nullptr : find_field_as_written(*holder.info, written, Encoding::vrml2);
    return named == nullptr ? written : named->name;
  }
  if (node.stands_for == nullptr) return "children";
  const FieldInfo* field = holder.info == nullptr ? nullptr : container_field_of(*holder.info, *node.stands_for, "");
  return field == nullptr ? node.stands_for->container_field : field->name;
}

/// The type of a field, and its name as X3D has it.
FieldType DocumentTyper::identify(Name& field, bool is, const NodeKind& holder) const {
  if (holder.prototype != nullptr) {
    const auto declared = holder.prototype->types.find(field.text);
    return declared == holder.prototype->types.end() ? FieldType::unknown : declared->second;
  }
  if (holder.info == nullptr) return FieldType::unknown;
  const FieldInfo* info = find_field_as_written(*holder.info, field.text, Encoding::vrml2);
  if (info == nullptr) return FieldType::unknown;
  field.text = info->name;
  return is ? FieldType::unknown : info->type;
}

// Code

/// XML 1.0 has no limit on the pieces that one text comes in.
void DocumentTyper::join_code(NodeExtras& extras) {
  if (extras.cdata.count < 2) return;
  MappedText code;
  for (const MappedText& piece : document_.of(extras.cdata)) code.append(piece);
  extras.cdata = append(document_.strings, {std::move(code)});
}

void DocumentTyper::lift_code(const NodeSyntax& node, NodeExtras& extras, std::vector<TypedField>& fields) {
  const auto url =
      std::find_if(fields.begin(), fields.end(), [](const TypedField& typed) { return typed.field.name.text == "url"; });
  if (!extras.cdata.empty() || url == fields.end() || url->field.value.kind != ValueKind::strings) return;
  ValueSyntax& urls = url->field.value;
  const MappedText last = document_.of(urls.strings()).back();
  MappedText code;
  if (last.text().starts_with(kPlainCode)) {
    code.append(last, static_cast<std::uint32_t>(kPlainCode.size()), last.size());
  } else if (node.type.text == "Script" && begins_with_script(last.text())) {
    code = last;
  } else {
    return;
  }
  extras.cdata = append(document_.strings, {std::move(code)});
  if (--urls.count == 0) fields.erase(url);
}

}  // namespace

Document type_document(Document document) {
  DocumentTyper(document).type();
  return document;
}

}  // namespace plugc
