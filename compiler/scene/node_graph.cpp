// Reading a finished graph. A node holds only the fields that were written, so a look-up first scans those few and then
// falls back on the table's default. build_graph checked the values: one element of the field's type is always there.

#include "scene/node_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "scene/default_values.h"

namespace plugc {

const GraphNode& NodeGraph::operator[](NodeId id) const {
  PLUGC_CHECK(id.value < nodes_.size(), "a node of this graph");
  return nodes_[id.value];
}

const std::filesystem::path& NodeGraph::base_path(NodeId id) const {
  return document_paths_[(*this)[id].document];
}

bool NodeGraph::is(NodeId id, std::string_view type) const {
  return id.valid() && is_a(*(*this)[id].info, type);
}

void NodeList::push_back(NodeId id) {
  if (!many_ && !one_.valid()) {
    one_ = id;
    return;
  }
  if (!many_) many_ = std::make_unique<std::vector<NodeId>>(1, one_);
  many_->push_back(id);
}

std::span<const InterfaceField> GraphNode::interface() const {
  return own ? std::span<const InterfaceField>(own->interface) : std::span<const InterfaceField>();
}

std::span<const MappedText> GraphNode::cdata() const {
  return own ? own->cdata : std::span<const MappedText>();
}

const WrittenField* NodeGraph::find_written(NodeId id, std::string_view name) const {
  const std::vector<WrittenField>& fields = (*this)[id].fields;
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const WrittenField& field) { return field.info->name == name; });
  return found == fields.end() ? nullptr : &*found;
}

bool NodeGraph::has_field(NodeId id, std::string_view name) const {
  return find_field_info(*(*this)[id].info, name) != nullptr;
}

const FieldValue& NodeGraph::field(NodeId id, std::string_view name) const {
  if (const WrittenField* written = find_written(id, name)) return written->value;
  const FieldInfo* info = find_field_info(*(*this)[id].info, name);
  PLUGC_CHECK(info != nullptr, "a field that the node's type has");
  return default_value(*info);
}

bool NodeGraph::is_written(NodeId id, std::string_view name) const {
  return find_written(id, name) != nullptr;
}

Span NodeGraph::field_span(NodeId id, std::string_view name) const {
  const WrittenField* written = find_written(id, name);
  return written != nullptr && written->value.span.valid() ? written->value.span : (*this)[id].type_span;
}

bool NodeGraph::boolean(NodeId id, std::string_view name) const {
  return number(id, name) != 0;
}

double NodeGraph::number(NodeId id, std::string_view name) const {
  const FieldValue& value = field(id, name);
  PLUGC_CHECK(!value.numbers.empty(), "a field of one number");
  return value.numbers[0];
}

int NodeGraph::integer(NodeId id, std::string_view name) const {
  const double value = number(id, name);
  if (std::isnan(value)) return 0;
  constexpr double kLowest = std::numeric_limits<int>::min();
  constexpr double kHighest = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(value, kLowest, kHighest));
}

glm::dvec2 NodeGraph::vec2(NodeId id, std::string_view name) const {
  const std::span<const double> n = field(id, name).numbers;
  PLUGC_CHECK(n.size() >= 2, "a field of two numbers");
  return {n[0], n[1]};
}

glm::dvec3 NodeGraph::vec3(NodeId id, std::string_view name) const {
  const std::span<const double> n = field(id, name).numbers;
  PLUGC_CHECK(n.size() >= 3, "a field of three numbers");
  return {n[0], n[1], n[2]};
}

glm::dvec4 NodeGraph::vec4(NodeId id, std::string_view name) const {
  const std::span<const double> n = field(id, name).numbers;
  PLUGC_CHECK(n.size() >= 4, "a field of four numbers");
  return {n[0], n[1], n[2], n[3]};
}

std::string_view NodeGraph::string(NodeId id, std::string_view name) const {
  const FieldValue& value = field(id, name);
  PLUGC_CHECK(!value.strings.empty(), "a field of one string");
  return value.strings[0].text();
}

NodeId NodeGraph::child(NodeId id, std::string_view name) const {
  const std::span<const NodeId> nodes = children(id, name);
  return nodes.empty() ? NodeId() : nodes[0];
}

std::span<const NodeId> NodeGraph::children(NodeId id, std::string_view name) const {
  return field(id, name).nodes;
}

}  // namespace plugc
