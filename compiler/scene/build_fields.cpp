// What stands inside a node: fields, and interface declarations with their values. Numbers and strings are read at once;
// nodes become jobs that fill a list; IS takes what the prototype's instance was given.

#include <algorithm>
#include <array>
#include <unordered_set>

#include <fmt/format.h>

#include "scene/event_names.h"
#include "scene/graph_builder.h"
#include "scene/value_limits.h"

namespace plugc {
namespace {

std::vector<std::string_view> field_names(const NodeInfo& info) {
  std::vector<std::string_view> names;
  for (const FieldInfo& field : info.fields) {
    if (holds_value(field.access)) names.push_back(field.name);
  }
  return names;
}

bool is_url(std::string_view field) {
  return field.ends_with("url") || field.ends_with("Url");
}

/// X3D 4.0, part 1, 4.3.2: attributes by which pages of the web refer to an element. `style` is a field of FontStyle too.
bool is_for_pages(std::string_view attribute, Encoding encoding) {
  return attribute == "style" && (encoding == Encoding::xml || encoding == Encoding::json);
}

bool takes_code(const NodeInfo& node) {
  static constexpr std::array<std::string_view, 5> kTypes = {"X3DScriptNode", "EffectPart", "ShaderPart", "ShaderProgram",
                                                             "PackagedShader"};
  return std::any_of(kTypes.begin(), kTypes.end(), [&](std::string_view type) { return is_a(node, type); });
}

}  // namespace

void GraphBuilder::build_fields(const Job& job, NodeId id) {
  const NodeSyntax& syntax = *job.node;
  const Document& text = document(*job.scope);
  for (const StatementSyntax& statement : text.of(syntax.extras->statements)) {
    if (statement.kind == StatementKind::proto) declare_prototype(*job.scope, statement.index, false);
    if (statement.kind == StatementKind::externproto) declare_prototype(*job.scope, statement.index, true);
  }
  const NodeInfo& info = *graph_.nodes_[id.value].info;
  if (!syntax.extras->cdata.empty() && !takes_code(info)) {
    const MappedText& code = text.of(syntax.extras->cdata).front();
    const std::size_t begin = std::min<std::size_t>(code.text().find_first_not_of(" \t\n"), code.size());
    report(DiagnosticId::syntax, code.locate(static_cast<std::uint32_t>(begin), code.size()),
           fmt::format("text stands inside `{}`, which holds no code", info.name));
  }
  build_interface(job, id);
  for (const FieldSyntax& field : text.of(syntax.fields)) build_field(job, id, field);
  for (const StatementSyntax& statement : text.of(syntax.extras->statements)) {
    if (statement.kind != StatementKind::route) continue;
    Job route;
    route.kind = JobKind::statement;
    route.statement = &statement;
    route.scope = job.scope;
    jobs_.push_back(route);  // behind the children, whose names it may use
  }
}

void GraphBuilder::build_field(const Job& job, NodeId id, const FieldSyntax& field) {
  const NodeInfo& node = *graph_.nodes_[id.value].info;
  if (is_unplaced(field)) return lose_nodes(*job.scope, field.value);
  if (field.name.empty()) {
    Destination to;
    to.holder = id;
    to.by_container = true;
    return push_nodes(job, field.value, to, *job.scope);
  }
  const FieldInfo* info = find_field(*job.scope, node, field);
  if (info == nullptr && is_for_pages(field.name.text, document(*job.scope).encoding)) return;
  if (info == nullptr) {
    report_unknown_field(node, field.name);
    return lose_nodes(*job.scope, field.value);
  }
  if (field.value.kind == ValueKind::is) return connect_field(job, id, *info, field);
  if (!holds_value(info->access)) {
    return report(DiagnosticId::field_unknown, field.name.span,
                  fmt::format("`{}` of `{}` is an event and takes no value", info->name, node.name));
  }
  if (is_node(info->type)) return build_node_field(job, id, *info, field);
  FieldValue value;
  const ValueContract contract{info->type, info, info->name, node.name};
  if (!read_plain(*job.scope, field.value, contract, value)) return lose_nodes(*job.scope, field.value);
  graph_.nodes_[id.value].fields[write_field(id, *info, field.name.span)].value = value;
}

/// The field of that name. Names of VRML 2.0 that X3D changed are understood everywhere.
const FieldInfo* GraphBuilder::find_field(const Scope& scope, const NodeInfo& node, const FieldSyntax& field) {
  const Name& name = field.name;
  const bool is = field.value.kind == ValueKind::is;
  const auto find_in = [&](Encoding encoding) {
    const auto find = [&](std::string_view one) { return find_field_as_written(node, one, encoding); };
    return is ? find_event(name.text, EventUse::any, find) : find(name.text);
  };
  if (const FieldInfo* found = find_in(document(scope).encoding)) return found;
  const FieldInfo* renamed = find_in(Encoding::vrml2);
  if (renamed != nullptr) report_renamed(node, name, *renamed);
  return renamed;
}

void GraphBuilder::report_renamed(const NodeInfo& node, const Name& name, const FieldInfo& field) {
  report(
      DiagnosticId::field_unknown, name.span,
      fmt::format("`{}` is the name of VRML 2.0; the field of `{}` is called `{}` in X3D", name.text, node.name, field.name));
}

void GraphBuilder::build_node_field(const Job& job, NodeId id, const FieldInfo& info, const FieldSyntax& field) {
  const NodeInfo& node = *graph_.nodes_[id.value].info;
  if (!holds_nodes(*job.scope, field.value, {info.type, &info, info.name, node.name})) return;
  const std::size_t index = write_field(id, info, field.name.span);
  FieldValue& value = graph_.nodes_[id.value].fields[index].value;
  value.type = info.type;
  value.span = field.value.span;
  Destination to;
  to.holder = id;
  to.field = &info;
  to.single = !is_multiple(info.type);
  to.list = new_list(id, index, false);
  const Encoding encoding = document(*job.scope).encoding;
  if (encoding == Encoding::xml || encoding == Encoding::json) container_lists_[{id.value, &info}] = to.list;
  push_nodes(job, field.value, to, *job.scope);
}

void GraphBuilder::build_interface(const Job& job, NodeId id) {
  const std::span<const InterfaceSyntax> declared = document(*job.scope).of(job.node->extras->interface);
  if (declared.empty()) return;
  const NodeInfo& info = *graph_.nodes_[id.value].info;
  if (!info.has_interface) {
    return report(DiagnosticId::field_unknown, declared[0].name.span,
                  fmt::format("`{}` declares no fields of its own, such as `{}`", info.name, declared[0].name.text));
  }
  std::unordered_set<std::string_view> names;
  for (const InterfaceSyntax& one : declared) {
    if (!declare_once(names, one)) continue;
    const FieldType type = field_type(one.type.text);
    if (type == FieldType::unknown) {
      report_unknown_type(one.type);
      continue;
    }
    std::vector<InterfaceField>& fields = graph_.nodes_[id.value].own->interface;
    InterfaceField& field = fields.emplace_back();
    field.access = one.access;
    field.type = type;
    field.name = one.name.text;
    field.name_span = one.name.span;
    field.value.type = type;
    build_interface_value(job, id, fields.size() - 1, one);
  }
}

void GraphBuilder::build_interface_value(const Job& job, NodeId id, std::size_t index, const InterfaceSyntax& declared) {
  if (declared.value.kind == ValueKind::none) return;
  if (declared.value.kind == ValueKind::is) return connect_interface(job, id, index, declared);
  const GraphNode& node = graph_.nodes_[id.value];
  const FieldType type = node.own->interface[index].type;
  const ValueContract contract{type, nullptr, declared.name.text, node.info->name};
  FieldValue value;
  value.type = type;
  value.span = declared.value.span;
  if (!is_node(type)) {
    if (!read_plain(*job.scope, declared.value, contract, value)) return;
  } else if (!holds_nodes(*job.scope, declared.value, contract)) {
    return;
  }
  InterfaceField& field = graph_.nodes_[id.value].own->interface[index];
  field.has_value = true;
  field.value = value;
  if (!is_node(type)) return;
  Destination to;
  to.holder = id;
  to.single = !is_multiple(type);
  to.list = new_list(id, index, true);
  push_nodes(job, declared.value, to, *job.scope);
}

void GraphBuilder::connect_field(const Job& job, NodeId id, const FieldInfo& info, const FieldSyntax& field) {
  const ProtoField* source =
      follow_is(*job.scope, field.value, info.type, as_access_type(info.access), {id, nullptr, info.name});
  if (source == nullptr || !source->has_value || !holds_value(info.access)) return;
  NodeList* shared = is_node(info.type) ? share(job, id, &info, *source) : nullptr;
  if (is_node(info.type) && shared == nullptr) return;
  const std::size_t index = write_field(id, info, field.name.span);
  GraphNode& node = graph_.nodes_[id.value];
  node.fields[index].value = source->value;
  check_connected(source->value, {info.type, &info, info.name, node.info->name});
  if (shared != nullptr) list_uses_.push_back({id, static_cast<std::uint32_t>(index), false, shared});
  if (is_url(info.name)) node.document = source->value_document;
}

/// A value meets the limits of a field only where it is connected to one.
void GraphBuilder::check_connected(const FieldValue& value, const ValueContract& contract) {
  constexpr std::size_t kChecksOfOneNode = 64;  // numbers that are looked at in the time that a node takes
  if (!spend(1 + value.numbers.size() / kChecksOfOneNode + value.strings.size(), value.span)) return;
  const auto out = find_out_of_range(contract, value.numbers);
  if (out) report(DiagnosticId::field_range, value.span, out->message);
  check_words(contract, value.span, value.strings, diagnostics_);
}

void GraphBuilder::connect_interface(const Job& job, NodeId id, std::size_t index, const InterfaceSyntax& declared) {
  const FieldType type = graph_.nodes_[id.value].own->interface[index].type;
  const ProtoField* source = follow_is(*job.scope, declared.value, type, declared.access, {id, nullptr, declared.name.text});
  if (source == nullptr || !source->has_value) return;
  NodeList* shared = is_node(type) ? share(job, id, nullptr, *source) : nullptr;
  if (is_node(type) && shared == nullptr) return;
  InterfaceField& field = graph_.nodes_[id.value].own->interface[index];
  field.has_value = true;
  field.value = source->value;
  if (shared != nullptr) list_uses_.push_back({id, static_cast<std::uint32_t>(index), true, shared});
}

/// In a scope that repeats, the same syntax is read (and reported on) once.
bool GraphBuilder::read_plain(const Scope& scope, const ValueSyntax& syntax, const ValueContract& contract, FieldValue& value) {
  ValueStore store{graph_.numbers_, graph_.strings_, number_budget_};
  if (!scope.repeats) return read_value(syntax, document(scope), contract, store, diagnostics_, value);
  const auto [entry, is_new] = read_values_.try_emplace({&syntax, contract.type});
  if (is_new && read_value(syntax, document(scope), contract, store, diagnostics_, value)) entry->second = value;
  if (entry->second) value = *entry->second;
  return entry->second.has_value();
}

/// Nodes in a field that cannot take them are passed over.
void GraphBuilder::lose_nodes(Scope& scope, const ValueSyntax& value) {
  if (value.kind != ValueKind::nodes) return;
  for (const NodeSyntax& node : document(scope).of(value.nodes())) lose(scope, node);
}

bool GraphBuilder::declare_once(std::unordered_set<std::string_view>& names, const InterfaceSyntax& declared) {
  if (names.insert(declared.name.text).second) return true;
  report(DiagnosticId::name_repeated, declared.name.span,
         fmt::format("a field `{}` is declared already; this one is passed over", declared.name.text));
  return false;
}

/// XML has no words for no node; `<fieldValue name="back" value="NULL"/>` is common, and an empty text for a list.
bool GraphBuilder::holds_nodes(const Scope& scope, const ValueSyntax& value, const ValueContract& contract) {
  const auto text = document(scope).of(value.strings());
  const bool lexical = value.kind == ValueKind::lexical && !text.empty();
  const bool empty_list = value.kind == ValueKind::empty || (lexical && text[0].empty());
  const bool null = lexical && text[0].text() == "NULL";
  if (value.kind == ValueKind::nodes || null || (empty_list && is_multiple(contract.type))) return true;
  if (value.damaged || value.kind == ValueKind::none) return false;  // reported by the reader
  report(DiagnosticId::field_type, value.span,
         fmt::format("`{}` of `{}` takes {}, but {} here", contract.field, contract.node, to_text(contract.type),
                     what_stands(value)));
  return false;
}

void GraphBuilder::push_nodes(const Job& job, const ValueSyntax& value, const Destination& to, Scope& scope) {
  if (value.kind != ValueKind::nodes || value.count == 0) return;
  Job child;
  child.node = document(scope).of(value.nodes()).data();
  child.following = value.count - 1;
  child.scope = &scope;
  child.to = to;
  child.depth = job.depth + 1;
  jobs_.push_back(child);
}

/// The index of the field among those written; of a field written twice the last value counts.
std::size_t GraphBuilder::write_field(NodeId id, const FieldInfo& info, const Span& name_span) {
  GraphNode& node = graph_.nodes_[id.value];
  for (std::size_t i = 0; i < node.fields.size(); ++i) {
    if (node.fields[i].info != &info) continue;
    report(DiagnosticId::field_repeated, name_span,
           fmt::format("`{}` of `{}` is given twice; the last value counts", info.name, node.info->name));
    node.fields[i] = {&info, {}};
    return i;
  }
  node.fields.push_back({&info, {}});
  return node.fields.size() - 1;
}

NodeList* GraphBuilder::new_list(NodeId id, std::size_t index, bool interface) {
  NodeList* list = &graph_.node_lists_.emplace_back();
  list_uses_.push_back({id, static_cast<std::uint32_t>(index), interface, list});
  return list;
}

void GraphBuilder::report_unknown_field(const NodeInfo& info, const Name& name) {
  if (is_reported(DiagnosticId::field_unknown, name.span)) return;
  report(DiagnosticId::field_unknown, name.span,
         fmt::format("`{}` has no field `{}`{}", info.name, name.text, suggest(name.text, [&] { return field_names(info); })));
}

}  // namespace plugc
