// Two lights (the second casts a shadow where a shape receives it), an Appearance for each kind, a Shape for each kind and
// geometry.

#include "scene/library_stage.h"

#include <fmt/format.h>

#include "scene/stage.h"

namespace plugc {
namespace {

/// Two by two texels, light and dark grey in a chequer.
constexpr std::string_view kChequer =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAAAAABX3VL4AAAADklEQVR42mP4P41h2n8ACYQDK1KsyeEAAAAASUVORK5CYII=";

std::string appearance(std::size_t number, bool& textured_before) {
  const StageKind& kind = kStageKinds[number];
  const std::string_view material = kind.lit ? "Material { diffuseColor 0.8 0.6 0.4 specularColor 0.4 0.4 0.4 }"
                                             : "UnlitMaterial { emissiveColor 0.8 0.6 0.4 }";
  std::string texture;
  if (kind.textured) {
    texture = textured_before ? fmt::format(" texture USE {}", kLibraryTexture)
                              : fmt::format(" texture DEF {} ImageTexture {{ url \"{}\" }}", kLibraryTexture, kChequer);
    textured_before = true;
  }
  const std::string shadow = kind.shadow ? fmt::format(" receiveShadows USE {}", kLibraryLight) : "";
  return fmt::format("DEF PlugcLook{} Appearance {{ material {}{}{} }}", number, material, texture, shadow);
}

/// A shape's appearance and geometry are written where they come first, and USEd behind that.
std::string shape(std::size_t geometry, std::size_t kind, bool& textured_before) {
  const std::string look = geometry == 0 ? appearance(kind, textured_before) : fmt::format("USE PlugcLook{}", kind);
  const std::string form = kind == 0 ? fmt::format("DEF PlugcForm{} {}", geometry, stage_geometry(kStageGeometries[geometry]))
                                     : fmt::format("USE PlugcForm{}", geometry);
  return fmt::format("  Shape {{ shading \"{}\" appearance {} geometry {} }}\n",
                     kStageKinds[kind].gouraud ? "GOURAUD" : "PHONG", look, form);
}

}  // namespace

std::string library_stage_scene() {
  std::string shapes;
  bool textured_before = false;
  for (std::size_t geometry = 0; geometry < kStageGeometries.size(); ++geometry) {
    for (std::size_t kind = 0; kind < kStageKinds.size(); ++kind) shapes += shape(geometry, kind, textured_before);
  }
  return fmt::format(R"(#X3D V4.0 utf8
Viewpoint {{ position 0 1.6 7 orientation 1 0 0 -0.2 }}
NavigationInfo {{ headlight FALSE }}
DirectionalLight {{ direction -0.3 -0.4 -1 intensity 0.5 global TRUE }}
DEF {light} SpotLight {{ location 2.5 5 3 direction -2.5 -5.2 -3 cutOffAngle 0.6 beamWidth 0.5
  defaultShadowMap GeneratedShadowMap {{ update "ALWAYS" size 1024 }} }}
DEF {stage} Switch {{ whichChoice 0 children [
{shapes}] }}
Transform {{ translation 0 -1.3 0 children Shape {{
  appearance Appearance {{ material Material {{ }} receiveShadows USE {light} }} geometry Box {{ size 8 0.1 8 }} }} }}
)",
                     fmt::arg("light", kLibraryLight), fmt::arg("stage", kLibraryStage), fmt::arg("shapes", shapes));
}

}  // namespace plugc
