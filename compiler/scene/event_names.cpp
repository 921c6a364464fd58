// X3D 4.1 part 1, 4.4.2.2: an inputOutput field `x` is also the events `set_x` and `x_changed`. ISO/IEC 14772 (VRML 2.0)
// calls a few fields otherwise than X3D does; these names count only in files of that encoding. The names that X3D 3 had for
// the sides of a cube map count in every file.

#include "scene/event_names.h"

#include <algorithm>
#include <array>

namespace plugc {
namespace {

struct Renamed {
  std::string_view node, older, x3d;
  bool in_vrml2_alone = false;
};

constexpr std::array<Renamed, 9> kRenamed = {{
    {"Collision", "collide", "enabled", true},
    {"LOD", "level", "children", true},
    {"Switch", "choice", "children", true},
    {"ComposedCubeMapTexture", "back", "backTexture"},
    {"ComposedCubeMapTexture", "bottom", "bottomTexture"},
    {"ComposedCubeMapTexture", "front", "frontTexture"},
    {"ComposedCubeMapTexture", "left", "leftTexture"},
    {"ComposedCubeMapTexture", "right", "rightTexture"},
    {"ComposedCubeMapTexture", "top", "topTexture"},
}};

}  // namespace

bool holds_value(FieldAccess access) {
  return holds_value(as_access_type(access));
}

bool holds_value(AccessType access) {
  return access == AccessType::initialize_only || access == AccessType::input_output;
}

AccessType as_access_type(FieldAccess access) {
  switch (access) {
    case FieldAccess::initialize_only: return AccessType::initialize_only;
    case FieldAccess::input_only: return AccessType::input_only;
    case FieldAccess::output_only: return AccessType::output_only;
    case FieldAccess::input_output: break;
  }
  return AccessType::input_output;
}

bool may_join(AccessType inner, AccessType outer) {
  return inner == AccessType::input_output || inner == outer;
}

bool allows(FieldAccess access, EventUse use) {
  return allows(as_access_type(access), use);
}

bool allows(AccessType access, EventUse use) {
  switch (use) {
    case EventUse::any: return true;
    case EventUse::receive: return access == AccessType::input_only || access == AccessType::input_output;
    case EventUse::send: return access == AccessType::output_only || access == AccessType::input_output;
  }
  return false;
}

const FieldInfo* find_field_as_written(const NodeInfo& node, std::string_view name, Encoding encoding) {
  if (const FieldInfo* field = find_field_info(node, name)) return field;
  const auto renamed = std::ranges::find_if(kRenamed, [&](const Renamed& one) {
    return one.node == node.name && one.older == name && (encoding == Encoding::vrml2 || !one.in_vrml2_alone);
  });
  return renamed == kRenamed.end() ? nullptr : find_field_info(node, renamed->x3d);
}

std::string_view without_event_affix(std::string_view name, EventUse use) {
  constexpr std::string_view kSet = "set_";
  constexpr std::string_view kChanged = "_changed";
  if (use == EventUse::receive && name.starts_with(kSet)) return name.substr(kSet.size());
  if (use == EventUse::send && name.ends_with(kChanged)) return name.substr(0, name.size() - kChanged.size());
  return "";
}

}  // namespace plugc
