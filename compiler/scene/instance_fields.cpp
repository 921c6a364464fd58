// The fields of a prototype's instance: what the instance gives them, and what IS in the body makes of them. A value is built
// in the scope that wrote it; an IS finds it ready and leaves a link, along which routes are followed later.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "document/read_document.h"
#include "scene/event_names.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

std::vector<std::string_view> field_names(const Instance& instance) {
  std::vector<std::string_view> names;
  for (const ProtoField& field : instance.fields) names.push_back(field.declared->name.text);
  return names;
}

}  // namespace

ProtoField* find_proto_field(Instance& instance, std::string_view name) {
  const auto found = instance.prototype->field_index.find(name);
  return found == instance.prototype->field_index.end() ? nullptr : &instance.fields[found->second];
}

bool GraphBuilder::declares(const Prototype& prototype, std::string_view field) const {
  const auto declared = graph_.documents_[prototype.document].of(prototype.syntax->interface);
  return std::any_of(declared.begin(), declared.end(), [&](const InterfaceSyntax& one) { return one.name.text == field; });
}

void GraphBuilder::set_field(const Job& job, Instance& instance, const FieldSyntax& written) {
  if (is_unplaced(written)) return lose_nodes(*job.scope, written.value);
  const Name& name = written.name;
  ProtoField* field = find_given(job, instance, written);
  if (field == nullptr) return lose_nodes(*job.scope, written.value);
  if (!name.empty() && std::exchange(field->is_given, true)) {
    report(DiagnosticId::field_repeated, name.span,
           fmt::format("`{}` of `{}` is given twice; the last value counts", name.text, instance.prototype->syntax->name.text));
  }
  if (!name.empty()) field->nodes = nullptr;  // of a field given twice the last value counts; XML children add up
  if (written.value.kind != ValueKind::is) return give_value(job, instance, *field, written.value, *job.scope);
  const ProtoField* source =
      follow_is(*job.scope, written.value, field->type, field->declared->access, {{}, &instance, field->declared->name.text});
  if (source == nullptr || !source->has_value) return;
  field->has_value = true;
  field->value = source->value;
  field->value_document = source->value_document;
  field->nodes = source->nodes;
}

/// The field of the interface that an instance gives something; null when it has none that could take it.
ProtoField* GraphBuilder::find_given(const Job& job, Instance& instance, const FieldSyntax& written) {
  const Name& name = written.name;
  const std::string_view prototype = instance.prototype->syntax->name.text;
  const Span span = name.empty() ? written.value.span : name.span;
  const bool is = written.value.kind == ValueKind::is;
  const auto find = [&](std::string_view wanted) { return find_proto_field(instance, wanted); };
  ProtoField* field = nullptr;
  if (name.empty()) {
    field = container_of(instance, written, document(*job.scope));
  } else {
    field = is ? find_event(name.text, EventUse::any, find) : find(name.text);
  }
  if (is_reported(DiagnosticId::field_unknown, span)) return field;
  if (field == nullptr) {
    report(DiagnosticId::field_unknown, span,
           name.empty() ? fmt::format("prototype `{}` has no field for this node", prototype)
                        : fmt::format("prototype `{}` has no field `{}`{}", prototype, name.text,
                                      suggest(name.text, [&] { return field_names(instance); })));
    return nullptr;
  }
  if (!is && !holds_value(field->declared->access)) {
    report(DiagnosticId::field_unknown, span,
           fmt::format("`{}` of `{}` is an event and takes no value", field->declared->name.text, prototype));
    return nullptr;
  }
  if (instance.external != nullptr && !declares(*instance.external, field->declared->name.text)) {
    report(DiagnosticId::field_unknown, span,
           fmt::format("the external prototype `{}` does not declare `{}`; its file does, so the value is taken",
                       instance.external->syntax->name.text, field->declared->name.text));
  }
  return field->type == FieldType::unknown ? nullptr : field;
}

void GraphBuilder::give_value(const Job& job, Instance& instance, ProtoField& field, const ValueSyntax& value, Scope& scope) {
  const ValueContract contract{field.type, nullptr, field.declared->name.text, instance.prototype->syntax->name.text};
  field.value_document = scope.document;
  field.value.type = field.type;
  field.value.span = value.span;
  if (field.type == FieldType::unknown) return;
  if (!is_node(field.type)) {
    field.has_value = read_plain(scope, value, contract, field.value);
    return;
  }
  if (!holds_nodes(scope, value, contract)) return;
  if (field.nodes == nullptr) field.nodes = &graph_.node_lists_.emplace_back();
  field.has_value = true;
  Destination to;
  to.list = field.nodes;
  to.single = !is_multiple(field.type);
  push_nodes(job, value, to, scope);
}

/// XML: a node directly inside an instance goes to the field that it names, else to the first one for nodes.
ProtoField* GraphBuilder::container_of(Instance& instance, const FieldSyntax& child, const Document& text) {
  const std::span<const NodeSyntax> nodes = text.of(child.value.nodes());
  if (!nodes.empty()) {
    ProtoField* named = find_proto_field(instance, nodes[0].extras->container_field.text);
    if (named != nullptr && is_node(named->type)) return named;
  }
  const auto first =
      std::find_if(instance.fields.begin(), instance.fields.end(), [](const ProtoField& field) { return is_node(field.type); });
  return first == instance.fields.end() ? nullptr : &*first;
}

/// The interface field that `IS name` means in a body, with a link from it to what it feeds.
ProtoField* GraphBuilder::follow_is(const Scope& scope, const ValueSyntax& is, FieldType type, AccessType access,
                                    const Link& link) {
  const std::span<const MappedText> text = document(scope).of(is.strings());
  const std::string_view name = text.empty() ? std::string_view() : text[0].text();
  if (scope.instance == nullptr) {
    report(DiagnosticId::proto_unknown_field, is.span, fmt::format("`IS {}` stands outside a prototype's body", name));
    return nullptr;
  }
  Instance& instance = *scope.instance;
  ProtoField* field =
      find_event(name, EventUse::any, [&](std::string_view wanted) { return find_proto_field(instance, wanted); });
  if (field == nullptr) {
    if (is_reported(DiagnosticId::proto_unknown_field, is.span)) return nullptr;
    report(DiagnosticId::proto_unknown_field, is.span,
           fmt::format("prototype `{}` declares no field `{}`{}", instance.prototype->syntax->name.text, name,
                       suggest(name, [&] { return field_names(instance); })));
    return nullptr;
  }
  if (field->type != type && field->type != FieldType::unknown && type != FieldType::unknown) {
    report(DiagnosticId::field_type, is.span,
           fmt::format("`{}` is of type {}, but the prototype's `{}` is of type {}", link.field, to_text(type), name,
                       to_text(field->type)));
    return nullptr;
  }
  if (!may_join(access, field->declared->access)) {
    report(DiagnosticId::access_type, is.span,
           fmt::format("`{}` is {}, but the prototype's `{}` is {}", link.field, to_text(access), name,
                       to_text(field->declared->access)));
  }
  field->links.push_back(link);
  return field;
}

}  // namespace plugc
