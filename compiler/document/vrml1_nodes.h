#pragma once
// The nodes of VRML 1.0 with their fields, as its specification lists them (draft of 26 May 1995), and the few of VRML 2.0 that
// files of its time hold beside them. Nothing but data; what a node means is in vrml1_scene.h.

#include <cstdint>
#include <span>
#include <string_view>

namespace plugc {

/// Types of fields under their names in the specification.
enum class Vrml1Type : std::uint8_t {
  SFBool,
  SFEnum,     // a word of the field's `words`
  SFBitMask,  // one of them, or several: `(SIDES | TOP)`
  SFFloat,
  SFVec2f,
  SFVec3f,
  SFColor,
  SFRotation,
  SFMatrix,
  SFImage,
  SFString,
  MFFloat,
  MFLong,
  MFVec2f,
  MFVec3f,
  MFColor,
  MFString,
  SFLong,
};

bool is_multiple(Vrml1Type type);
/// Numbers in one element; 0 for what is no number or has no fixed count.
std::size_t component_count(Vrml1Type type);
std::string_view to_text(Vrml1Type type);

struct Vrml1FieldInfo {
  std::string_view name;
  Vrml1Type type;
  std::string_view words = {};  ///< With blanks between them.
};

/// What a node does to those behind it.
enum class Vrml1Kind : std::uint8_t {
  property,  ///< Holds for the shapes behind it, until the next one of its slot.
  transform,
  shape,
  light,  ///< Lights the shapes behind it.
  camera,
  group,                ///< What is set in it holds behind it, too.
  switch_group,         ///< The same, for the children that it chooses.
  transform_separator,  ///< The same, but for transforms.
  separator,            ///< Keeps all to itself; likewise those below.
  lod,
  anchor,
  inlined,
  information,
  world,  ///< A node of VRML 2.0, taken as it is.
};

inline bool holds_nodes(Vrml1Kind kind) {
  return kind >= Vrml1Kind::group && kind <= Vrml1Kind::anchor;
}

/// Properties of one kind replace each other.
enum class Vrml1Slot : std::uint8_t {
  coordinate,
  normal,
  texture_coordinate,
  material,
  material_binding,
  normal_binding,
  shape_hints,
  texture,
  texture_transform,
  font_style,
};
inline constexpr std::size_t kVrml1Slots = 10;

struct Vrml1NodeInfo {
  std::string_view name;
  Vrml1Kind kind;
  std::span<const Vrml1FieldInfo> fields;
  Vrml1Slot slot = {};  ///< Of a property.
};

/// Null when there is none.
const Vrml1NodeInfo* find_vrml1_node(std::string_view name);
const Vrml1FieldInfo* find_field(const Vrml1NodeInfo& node, std::string_view name);

}  // namespace plugc
