// Slots are made on demand and remembered by (node, field name). Array fields become slots of several elements; a field
// without a value (inputOnly) starts as zeros, which is what GLSL gives an unset uniform.

#include "scene/scene_values.h"

#include <algorithm>

#include <fmt/format.h>

namespace plugc {
std::optional<SlotType> slot_type(FieldType type) {
  if (type == FieldType::SFBool || type == FieldType::MFBool) return SlotType::bool_;
  if (type == FieldType::SFInt32 || type == FieldType::MFInt32) return SlotType::int_;
  if (type == FieldType::SFRotation || type == FieldType::MFRotation) return SlotType::rotation;
  switch (is_numeric(type) ? component_count(type) : 0) {
    case 1: return SlotType::float_;
    case 2: return SlotType::vec2;
    case 3: return SlotType::vec3;
    case 4: return SlotType::vec4;
    case 9: return SlotType::mat3;
    case 16: return SlotType::mat4;
    default: return std::nullopt;
  }
}

std::uint32_t component_count(SlotType type) {
  switch (type) {
    case SlotType::bool_:
    case SlotType::int_:
    case SlotType::float_: return 1;
    case SlotType::vec2: return 2;
    case SlotType::vec3: return 3;
    case SlotType::vec4:
    case SlotType::rotation: return 4;
    case SlotType::mat3: return 9;
    case SlotType::mat4: return 16;
  }
  return 1;
}

SlotTable::SlotTable(const NodeGraph& graph, std::vector<Slot>& slots, const std::vector<DynamicField>& dynamic)
    : graph_(graph), slots_(slots) {
  for (const GraphRoute& route : graph.routes()) routed_[{route.to, route.to_field}].emplace(route.from, route.from_field);
  for (const DynamicField& field : dynamic) dynamic_.emplace(field.node, field.name);
}

bool SlotTable::may_change(NodeId node, std::string_view field) const {
  return routed_.contains({node, field}) || dynamic_.contains({node, field});
}

const std::set<SlotTable::Field>& SlotTable::senders(NodeId node, std::string_view field) const {
  static const std::set<Field> none;
  const auto found = routed_.find({node, field});
  return found == routed_.end() ? none : found->second;
}

std::uint32_t SlotTable::add(NodeId node, std::string_view field, const FieldValue& value) {
  const auto key = std::make_pair(node, field);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const auto type = slot_type(value.type);
  if (!type) return kSceneNoSlot;
  Slot slot;
  slot.type = *type;
  slot.values.assign(value.numbers.begin(), value.numbers.end());
  if (slot.values.empty()) slot.values.assign(component_count(*type), 0.0);
  slot.count = static_cast<std::uint32_t>(slot.values.size() / component_count(*type));
  slot.routed = may_change(node, field);
  slot.dynamic = dynamic_.contains({node, field});
  if (!graph_[node].def.empty()) slot.name = fmt::format("{}.{}", graph_[node].def, field);
  slot.mirrors = find_mirrored(key, slot);
  slots_.push_back(std::move(slot));
  const auto index = static_cast<std::uint32_t>(slots_.size() - 1);
  known_.emplace(key, index);
  return index;
}

/// The first slot of that type that the same events reach and that starts with the same value. A host may part them.
std::uint32_t SlotTable::find_mirrored(const Field& field, const Slot& slot) {
  const auto senders = routed_.find(field);
  if (senders == routed_.end() || slot.dynamic) return kSceneNoSlot;
  const auto [first, added] =
      by_senders_.try_emplace({senders->second, slot.values}, static_cast<std::uint32_t>(slots_.size()));
  return added || slots_[first->second].type != slot.type ? kSceneNoSlot : first->second;
}

std::uint32_t SlotTable::slot(NodeId node, std::string_view field) {
  return add(node, field, graph_.field(node, field));
}

std::uint32_t SlotTable::slot_if_used(NodeId node, std::string_view field) {
  return graph_.is_written(node, field) || may_change(node, field) ? slot(node, field) : kSceneNoSlot;
}

std::uint32_t SlotTable::interface_slot(NodeId node, const InterfaceField& field) {
  FieldValue value = field.value;
  value.type = field.type;
  return add(node, field.name, value);
}

std::uint32_t SlotTable::slot_of_size(NodeId node, std::string_view field, std::size_t size) {
  return slot_of_values(node, field, std::vector<double>(size, 0.0));
}

std::uint32_t SlotTable::slot_of_values(NodeId node, std::string_view field, std::span<const double> numbers) {
  if (numbers.empty()) return kSceneNoSlot;
  FieldValue value = graph_.field(node, field);
  value.numbers = numbers;
  return add(node, field, value);
}

std::uint32_t SlotTable::own(SlotType type, std::vector<double> values) {
  slots_.push_back({type, 1, std::move(values), "", true, false, kSceneNoSlot});
  return static_cast<std::uint32_t>(slots_.size() - 1);
}

std::uint32_t SlotTable::list_slot(NodeId node, std::string_view field, std::size_t size) {
  const std::span<const InterfaceField> own = graph_[node].interface();
  const auto declared = std::ranges::find(own, field, &InterfaceField::name);
  if (declared == own.end() || !is_multiple(declared->type) || declared->value.numbers.size() == size)
    return declared_slot(node, field);
  const std::vector<double> zeros(size, 0.0);
  FieldValue value;
  value.type = declared->type;
  value.numbers = zeros;
  return add(node, field, value);
}

std::optional<std::uint32_t> SlotTable::find(NodeId node, std::string_view field) const {
  const auto found = known_.find({node, field});
  if (found == known_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::pair<NodeId, std::string_view>> SlotTable::routed_fields() const {
  std::vector<Field> fields;
  for (const auto& [field, slot] : known_) {
    if (routed_.contains(field)) fields.push_back(field);
  }
  return fields;
}

std::uint32_t SlotTable::declared_slot(NodeId node, std::string_view field) {
  const std::span<const InterfaceField> own = graph_[node].interface();
  const auto declared = std::ranges::find(own, field, &InterfaceField::name);
  return declared == own.end() ? slot(node, field) : interface_slot(node, *declared);
}

std::uint32_t SlotTable::constant(SlotType type, std::vector<double> values) {
  const auto [found, added] = constants_.try_emplace({type, values}, static_cast<std::uint32_t>(slots_.size()));
  if (added) slots_.push_back({type, 1, std::move(values), "", false, false, kSceneNoSlot});
  return found->second;
}

}  // namespace plugc
