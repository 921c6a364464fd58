// Routes are noted in the order of the text, when their names mean what they mean there, and resolved when every node
// exists. An end at a prototype's instance follows the links that IS left, through as many prototypes as there are, to the
// nodes in the bodies; one route can so become several, or none.

#include <algorithm>

#include <fmt/format.h>

#include "scene/event_names.h"
#include "scene/graph_builder.h"

namespace plugc {
namespace {

Definition* find_definition(const Scope& scope, const Name& name) {
  const auto found = scope.definitions.find(name.text);
  return found == scope.definitions.end() ? nullptr : found->second;
}

EventUse use_of(bool outgoing) {
  return outgoing ? EventUse::send : EventUse::receive;
}

}  // namespace

const InterfaceField* GraphBuilder::find_interface(NodeId id, std::string_view name) {
  const std::span<const InterfaceField> fields = graph_.nodes_[id.value].interface();
  if (fields.empty()) return nullptr;
  const auto [entry, is_new] = interface_index_.try_emplace(id.value);
  for (std::uint32_t i = 0; is_new && i < fields.size(); ++i) entry->second.emplace(fields[i].name, i);
  const auto found = entry->second.find(name);
  return found == entry->second.end() ? nullptr : &fields[found->second];
}

bool GraphBuilder::inner_field_allows(NodeId id, std::string_view name, EventUse use) {
  if (const InterfaceField* field = find_interface(id, name)) return allows(field->access, use);
  const FieldInfo* field = find_field_info(*graph_.nodes_[id.value].info, name);
  return field != nullptr && allows(field->access, use);
}

void GraphBuilder::note_route(Scope& scope, const RouteSyntax& route) {
  if (!spend(1, route.span)) return;
  pending_routes_.push_back({&route, &scope, find_definition(scope, route.from_node), find_definition(scope, route.to_node)});
}

void GraphBuilder::resolve_route(const PendingRoute& pending) {
  const auto from = route_end(pending, true);
  const auto to = route_end(pending, false);
  if (!from || !to) return;
  const RouteSyntax& route = *pending.syntax;
  if (from->type != to->type && from->type != FieldType::unknown && to->type != FieldType::unknown) {
    return report(DiagnosticId::route_invalid, route.span,
                  fmt::format("`{}.{}` sends {}, but `{}.{}` receives {}", route.from_node.text, route.from_field.text,
                              to_text(from->type), route.to_node.text, route.to_field.text, to_text(to->type)));
  }
  std::vector<Link> senders, receivers;
  follow_links(from->link, true, senders, route.span);
  follow_links(to->link, false, receivers, route.span);
  for (const Link& sender : senders) {
    for (const Link& receiver : receivers) {
      if (!spend(1, route.span)) return;
      if (!joined_.insert({sender.node, receiver.node, sender.field, receiver.field}).second)
        continue;  // X3D 4.1 part 1, 4.4.8.3
      graph_.routes_.push_back({sender.node, receiver.node, sender.field, receiver.field, route.span});
    }
  }
}

std::optional<RouteEnd> GraphBuilder::route_end(const PendingRoute& pending, bool outgoing) {
  const Name& node = outgoing ? pending.syntax->from_node : pending.syntax->to_node;
  const Name& field = outgoing ? pending.syntax->from_field : pending.syntax->to_field;
  const Definition* definition = outgoing ? pending.from : pending.to;
  if (definition == nullptr) {
    definition = find_definition(*pending.scope, node);
    if (definition != nullptr && !definition->lost) {
      report(DiagnosticId::route_invalid, node.span,
             fmt::format("`DEF {}` stands behind this `ROUTE`; only nodes before it may be named", node.text));
    }
  }
  if (definition == nullptr) {
    if (!is_reported(DiagnosticId::route_invalid, node.span)) {
      report(DiagnosticId::route_invalid, node.span,
             fmt::format("no node is named `{}`{}", node.text, suggest_defined(*pending.scope, node.text)));
    }
    return std::nullopt;
  }
  if (definition->lost) return std::nullopt;
  if (definition->instance != nullptr) return instance_end(*definition->instance, field, outgoing);
  if (!definition->node.valid()) return std::nullopt;
  return node_end(definition->node, field, outgoing);
}

std::optional<RouteEnd> GraphBuilder::instance_end(Instance& instance, const Name& field, bool outgoing) {
  const auto find = [&](std::string_view name) {
    ProtoField* found = find_proto_field(instance, name);
    return found != nullptr && allows(found->declared->access, use_of(outgoing)) ? found : nullptr;
  };
  if (ProtoField* found = find_event(field.text, use_of(outgoing), find)) {
    return RouteEnd{{{}, &instance, found->declared->name.text}, found->type};
  }
  const auto names = [&] {
    std::vector<std::string_view> fitting;
    for (const ProtoField& one : instance.fields) {
      if (allows(one.declared->access, use_of(outgoing))) fitting.push_back(one.declared->name.text);
    }
    return fitting;
  };
  report_no_event(instance.prototype->syntax->name.text, field, outgoing, names);
  return std::nullopt;
}

std::optional<RouteEnd> GraphBuilder::node_end(NodeId id, const Name& field, bool outgoing) {
  const GraphNode& node = graph_.nodes_[id.value];
  const EventUse use = use_of(outgoing);
  const auto find_own = [&](std::string_view name) {
    const InterfaceField* found = find_interface(id, name);
    return found != nullptr && allows(found->access, use) ? found : nullptr;
  };
  const Encoding encoding = graph_.documents_[node.document].encoding;
  const auto find = [&](std::string_view name) {
    const FieldInfo* found = find_field_as_written(*node.info, name, encoding);
    return found != nullptr && allows(found->access, use) ? found : nullptr;
  };
  if (const InterfaceField* own = find_event(field.text, use, find_own)) return RouteEnd{{id, nullptr, own->name}, own->type};
  if (const FieldInfo* found = find_event(field.text, use, find)) return RouteEnd{{id, nullptr, found->name}, found->type};
  if (is_reported(DiagnosticId::route_invalid, field.span)) return std::nullopt;
  const auto names = [&] {
    std::vector<std::string_view> fitting;
    for (const InterfaceField& one : node.interface()) {
      if (allows(one.access, use)) fitting.push_back(one.name);
    }
    for (const FieldInfo& one : node.info->fields) {
      if (allows(one.access, use)) fitting.push_back(one.name);
    }
    return fitting;
  };
  report_no_event(node.info->name, field, outgoing, names);
  return std::nullopt;
}

void GraphBuilder::report_no_event(std::string_view type, const Name& field, bool outgoing,
                                   const std::function<std::vector<std::string_view>()>& names) {
  if (is_reported(DiagnosticId::route_invalid, field.span)) return;
  report(DiagnosticId::route_invalid, field.span,
         fmt::format("`{}` has no field `{}` that {} events{}", type, field.text, outgoing ? "sends" : "receives",
                     suggest(field.text, names)));
}

/// Each step leads one prototype deeper, so the recursion is no deeper than kMaxProtoDepth.
void GraphBuilder::follow_links(const Link& from, bool outgoing, std::vector<Link>& ends, const Span& span) {
  if (!spend(1, span)) return;
  if (from.instance == nullptr) {
    if (inner_field_allows(from.node, from.field, use_of(outgoing))) ends.push_back(from);
    return;
  }
  const ProtoField* field = find_proto_field(*from.instance, from.field);
  if (field == nullptr) return;
  for (const Link& link : field->links) follow_links(link, outgoing, ends, span);
}

}  // namespace plugc
