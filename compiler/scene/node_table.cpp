// The arrays come sorted by name from generate_node_table, so every look-up is a binary search. Whether a node is of an
// abstract type is answered by walking up its bases; the abstract types form a small graph without circles.

#include "scene/node_table.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/check.h"

namespace plugc {
namespace {

struct AbstractInfo {
  std::string_view name;
  std::string_view bases;
};

#include "node_table_data.inc"

struct TypeInfo {
  std::string_view name;
  std::uint8_t components;
};

/// In the order of FieldType.
constexpr std::array<TypeInfo, static_cast<std::size_t>(FieldType::unknown) + 1> kTypes = {{
    {"SFBool", 1},      {"MFBool", 1},      {"SFInt32", 1},     {"MFInt32", 1},     {"SFFloat", 1},     {"MFFloat", 1},
    {"SFDouble", 1},    {"MFDouble", 1},    {"SFTime", 1},      {"MFTime", 1},      {"SFVec2f", 2},     {"MFVec2f", 2},
    {"SFVec3f", 3},     {"MFVec3f", 3},     {"SFVec4f", 4},     {"MFVec4f", 4},     {"SFVec2d", 2},     {"MFVec2d", 2},
    {"SFVec3d", 3},     {"MFVec3d", 3},     {"SFVec4d", 4},     {"MFVec4d", 4},     {"SFRotation", 4},  {"MFRotation", 4},
    {"SFColor", 3},     {"MFColor", 3},     {"SFColorRGBA", 4}, {"MFColorRGBA", 4}, {"SFMatrix3f", 9},  {"MFMatrix3f", 9},
    {"SFMatrix4f", 16}, {"MFMatrix4f", 16}, {"SFMatrix3d", 9},  {"MFMatrix3d", 9},  {"SFMatrix4d", 16}, {"MFMatrix4d", 16},
    {"SFImage", 0},     {"MFImage", 0},     {"SFString", 0},    {"MFString", 0},    {"SFNode", 0},      {"MFNode", 0},
    {"unknown", 0},
}};

const TypeInfo& type_info(FieldType type) {
  return kTypes[static_cast<std::size_t>(type)];
}

template <typename Info>
const Info* find_named(std::span<const Info> sorted, std::string_view name) {
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), name,
                                      [](const Info& info, std::string_view wanted) { return info.name < wanted; });
  return found != sorted.end() && found->name == name ? &*found : nullptr;
}

std::string_view bases_of(std::string_view type) {
  if (const auto* abstract = find_named(std::span<const AbstractInfo>(kAbstracts), type)) return abstract->bases;
  const NodeInfo* node = find_node_info(type);
  return node == nullptr ? "" : node->bases;
}

bool any_base_is(std::string_view bases, std::string_view wanted) {
  return any_alternative(bases, [&](std::string_view base) { return base == wanted || any_base_is(bases_of(base), wanted); });
}

}  // namespace

std::uint32_t component_count(FieldType type) {
  return type_info(type).components;
}
bool is_multiple(FieldType type) {
  return to_text(type).starts_with("MF");
}
bool is_string(FieldType type) {
  return type == FieldType::SFString || type == FieldType::MFString;
}
bool is_node(FieldType type) {
  return type == FieldType::SFNode || type == FieldType::MFNode;
}
bool is_numeric(FieldType type) {
  return !is_string(type) && !is_node(type) && type != FieldType::unknown;
}
std::string_view to_text(FieldType type) {
  return type_info(type).name;
}

FieldType field_type(std::string_view name) {
  const auto found = std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeInfo& type) { return type.name == name; });
  return found == kTypes.end() ? FieldType::unknown : static_cast<FieldType>(found - kTypes.begin());
}

std::span<const NodeInfo> node_table() {
  return kNodes;
}
std::span<const FieldInfo> field_table() {
  return kFields;
}

std::span<const ComponentInfo> component_table() {
  return kComponents;
}

const NodeInfo* find_node_info(std::string_view name) {
  return find_named(std::span<const NodeInfo>(kNodes), name);
}

const FieldInfo* find_field_info(const NodeInfo& node, std::string_view name) {
  return find_named(node.fields, name);
}

bool is_a(const NodeInfo& node, std::string_view base) {
  return node.name == base || any_base_is(node.bases, base);
}

bool accepts(const FieldInfo& field, const NodeInfo& node) {
  return field.accepts.empty() || any_alternative(field.accepts, [&](std::string_view type) { return is_a(node, type); });
}

}  // namespace plugc
