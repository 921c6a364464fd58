// The fields of a node: those that are named, and those that child elements of XML go to by their type. Plain values come
// first, then nodes, then IS; code that is the last url moves to where code stands.

#include <algorithm>
#include <array>

#include "document/code_url.h"
#include "scene/container_field.h"
#include "scene/document_typer.h"
#include "scene/event_names.h"
#include "scene/type_values.h"

namespace plugc {
namespace {

constexpr std::array<std::string_view, 5> kCodeNodes = {"EffectPart", "PackagedShader", "Script", "ShaderPart",
                                                        "ShaderProgram"};

/// Plain values first, then nodes, then IS.
int rank(const FieldSyntax& field) {
  if (field.value.kind == ValueKind::is) return 2;
  return field.value.kind == ValueKind::nodes ? 1 : 0;
}

}  // namespace

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
  } else if (node.type.text == "Script" && is_script(last.text())) {
    code = last;
  } else {
    return;
  }
  extras.cdata = append(document_.strings, {std::move(code)});
  if (--urls.count == 0) fields.erase(url);
}

}  // namespace plugc
