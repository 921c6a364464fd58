#include "scene/stage.h"

#include <fmt/format.h>

namespace plugc {

std::string_view stage_geometry(std::string_view name) {
  if (name == "sphere") return "Sphere { radius 1.2 }";
  if (name == "box") return "Box { }";
  if (name == "plane")
    return "ElevationGrid { xDimension 2 zDimension 2 xSpacing 4 zSpacing 4 height [ 0 0 0 0 ] solid FALSE }";
  return "Teapot { }";
}

std::string stage_scene(std::string_view name) {
  return fmt::format(R"(#X3D V4.0 utf8
Viewpoint {{ position 0 1.6 7 orientation 1 0 0 -0.2 }}
NavigationInfo {{ headlight FALSE }}
DirectionalLight {{ direction -0.3 -0.4 -1 intensity 0.5 global TRUE }}
SpotLight {{ location 2.5 5 3 direction -2.5 -5.2 -3 cutOffAngle 0.6 beamWidth 0.5 shadows TRUE
  defaultShadowMap GeneratedShadowMap {{ update "ALWAYS" size 1024 }} }}
Shape {{ appearance Appearance {{ material Material {{ diffuseColor 0.8 0.6 0.4 specularColor 0.4 0.4 0.4 }} }} geometry {} }}
Transform {{ translation 0 -1.3 0 children Shape {{
  appearance Appearance {{ material Material {{ }} }} geometry Box {{ size 8 0.1 8 }} }} }}
)",
                     stage_geometry(name));
}

}  // namespace plugc
