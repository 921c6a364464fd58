#pragma once
// The nodes and fields of X3D 4.1 and of the extensions that plugc knows, generated at build time from scene/nodes/*.tsv.

#include <cstdint>
#include <span>
#include <string_view>

namespace plugc {

enum class FieldType : std::uint8_t {
  SFBool,
  MFBool,
  SFInt32,
  MFInt32,
  SFFloat,
  MFFloat,
  SFDouble,
  MFDouble,
  SFTime,
  MFTime,
  SFVec2f,
  MFVec2f,
  SFVec3f,
  MFVec3f,
  SFVec4f,
  MFVec4f,
  SFVec2d,
  MFVec2d,
  SFVec3d,
  MFVec3d,
  SFVec4d,
  MFVec4d,
  SFRotation,
  MFRotation,
  SFColor,
  MFColor,
  SFColorRGBA,
  MFColorRGBA,
  SFMatrix3f,
  MFMatrix3f,
  SFMatrix4f,
  MFMatrix4f,
  SFMatrix3d,
  MFMatrix3d,
  SFMatrix4d,
  MFMatrix4d,
  SFImage,
  MFImage,
  SFString,
  MFString,
  SFNode,
  MFNode,
  unknown,
};

/// Numbers in one element (3 for SFVec3f and MFVec3f); 0 for strings, nodes and images.
std::uint32_t component_count(FieldType type);
bool is_multiple(FieldType type);  ///< MF...
bool is_numeric(FieldType type);   ///< Stored as numbers (booleans and images too).
bool is_string(FieldType type);
bool is_node(FieldType type);
std::string_view to_text(FieldType type);
FieldType field_type(std::string_view name);  ///< `unknown` when there is none of that name.

enum class FieldAccess : std::uint8_t { initialize_only, input_only, output_only, input_output };

struct FieldInfo {
  std::string_view name;
  FieldType type;
  FieldAccess access;
  std::string_view default_text;  ///< As in the table; parsed once by default_value().
  std::string_view minimum;       ///< ">=0", ">0" or "".
  std::string_view maximum;
  std::string_view accepts;  ///< Node types accepted, separated by `|`; "" when any.
  std::string_view words;    ///< Strings accepted, separated by `|`, `""` for the empty one; "" when any.
};

struct NodeInfo {
  std::string_view name;
  std::string_view component;
  std::string_view bases;            ///< Direct abstract bases, separated by `|`.
  std::string_view container_field;  ///< Default containerField of the XML encoding.
  std::span<const FieldInfo> fields;
  bool has_interface;  ///< May declare its own fields (Script, Effect, ComposedShader, ...).
};

/// A component that a file may ask for.
struct ComponentInfo {
  std::string_view name;
  std::uint32_t highest_level;  ///< Levels begin with 1.
};

/// Every node, sorted by name; every field of every node, in one array that NodeInfo::fields are parts of.
std::span<const NodeInfo> node_table();
std::span<const FieldInfo> field_table();
const NodeInfo* find_node_info(std::string_view name);
const FieldInfo* find_field_info(const NodeInfo& node, std::string_view name);
/// The components of all versions of X3D and of the extensions, sorted by name (X3D 4.1 part 1, annex F; 3.3 for `H-Anim`).
std::span<const ComponentInfo> component_table();
/// Whether `node` is of the type `base`, which may be abstract (X3DLightNode) or a node's own name.
bool is_a(const NodeInfo& node, std::string_view base);
/// Whether `field` takes nodes like `node`.
bool accepts(const FieldInfo& field, const NodeInfo& node);

/// Whether `test` holds for any of the names in `alternatives`, which are separated by `|`.
template <typename Test>
bool any_alternative(std::string_view alternatives, Test test) {
  while (!alternatives.empty()) {
    const std::size_t end = alternatives.find('|');
    if (test(alternatives.substr(0, end))) return true;
    alternatives.remove_prefix(end == std::string_view::npos ? alternatives.size() : end + 1);
  }
  return false;
}

}  // namespace plugc
