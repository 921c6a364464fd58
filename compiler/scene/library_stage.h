#pragma once
// The built-in shapes on which each effect of a library is composed alone: one for everything that its plugs may be able to
// tell apart.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace plugc {

struct StageKind {
  std::string_view name;
  bool lit = true, gouraud = false, textured = false, shadow = false;
};

/// The first has most of what plugs can be called for.
inline constexpr std::array<StageKind, 10> kStageKinds = {{{"phong, texture, shadow", true, false, true, true},
                                                           {"phong, texture", true, false, true, false},
                                                           {"phong, shadow", true, false, false, true},
                                                           {"phong", true, false, false, false},
                                                           {"gouraud, texture", true, true, true, false},
                                                           {"gouraud", true, true, false, false},
                                                           {"unlit, texture", false, false, true, false},
                                                           {"unlit", false, false, false, false},
                                                           {"unlit gouraud, texture", false, true, true, false},
                                                           {"unlit gouraud", false, true, false, false}}};

/// What effects are tried on, as `--on` names it.
inline constexpr std::array<std::string_view, 4> kStageGeometries = {"teapot", "sphere", "box", "plane"};

/// DEF names in library_stage_scene(). The light and the texture are those that effects of lights and textures are put on.
inline constexpr std::string_view kLibraryStage = "PlugcStage", kLibraryLight = "PlugcLight", kLibraryTexture = "PlugcTexture";

/// The child of the Switch `PlugcStage` that has that geometry and kind.
constexpr std::size_t stage_choice(std::size_t geometry, std::size_t kind) {
  return geometry * kStageKinds.size() + kind;
}

/// A classic X3D scene for build_graph to append to a library: a lit, shadowed floor, and above it a Switch with a shape for
/// each geometry and each kind.
std::string library_stage_scene();

}  // namespace plugc
