#pragma once
// Field values as slots: one slot for each (node, field), whoever asks, so that a shared node keeps one set of values.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/dynamic_fields.h"
#include "scene/node_graph.h"
#include "scene/scene.h"

namespace plugc {

class SlotTable {
 public:
  /// `dynamic`: fields that the host may change.
  SlotTable(const NodeGraph& graph, std::vector<Slot>& slots, const std::vector<DynamicField>& dynamic);

  /// The slot of a field. The node's type must have the field.
  std::uint32_t slot(NodeId node, std::string_view field);
  /// The same, or none when nobody wrote the field and no ROUTE leads to it.
  std::uint32_t slot_if_used(NodeId node, std::string_view field);
  /// The slot of a node's own interface field; none for types that no uniform takes.
  std::uint32_t interface_slot(NodeId node, const InterfaceField& field);
  /// The slot of a field that holds a list of that many numbers, all zero at first; none for no numbers.
  std::uint32_t slot_of_size(NodeId node, std::string_view field, std::size_t size);
  /// The slot of a field of the node's type that starts with these numbers; none for no numbers.
  std::uint32_t slot_of_values(NodeId node, std::string_view field, std::span<const double> numbers);
  /// A value of the renderer's own, which events change.
  std::uint32_t own(SlotType type, std::vector<double> values);
  /// The slot of a field, of the node's own interface or of its type.
  std::uint32_t declared_slot(NodeId node, std::string_view field);
  /// The same; one of the node's own interface that holds a list has that many numbers, zeros where it is written otherwise.
  std::uint32_t list_slot(NodeId node, std::string_view field, std::size_t size);
  /// A value that nothing changes; equal ones share a slot.
  std::uint32_t constant(SlotType type, std::vector<double> values);

  /// Whether a ROUTE or the host may change the field.
  bool may_change(NodeId node, std::string_view field) const;
  /// The fields that ROUTEs lead here from.
  const std::set<std::pair<NodeId, std::string_view>>& senders(NodeId node, std::string_view field) const;
  /// The slot that the field has already.
  std::optional<std::uint32_t> find(NodeId node, std::string_view field) const;
  /// The fields with a slot that a ROUTE leads to.
  std::vector<std::pair<NodeId, std::string_view>> routed_fields() const;

 private:
  std::uint32_t add(NodeId node, std::string_view field, const FieldValue& value);
  const NodeGraph& graph_;
  std::vector<Slot>& slots_;
  using Field = std::pair<NodeId, std::string_view>;
  std::uint32_t find_mirrored(const Field& field, const Slot& slot);
  std::map<Field, std::set<Field>> routed_;  // with the fields that send to them
  std::set<Field> dynamic_;
  std::map<std::pair<std::set<Field>, std::vector<double>>, std::uint32_t> by_senders_;
  std::map<std::pair<NodeId, std::string_view>, std::uint32_t> known_;
  std::map<std::pair<SlotType, std::vector<double>>, std::uint32_t> constants_;
};

}  // namespace plugc
