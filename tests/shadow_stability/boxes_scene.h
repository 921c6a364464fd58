#pragma once
// The scene that most sweeps are done on: boxes on a ground, all under one Transform with its light and its viewpoints.

#include <string>

namespace plugc {

inline const char* const kSun =
    "DEF Lamp DirectionalLight { direction -0.55 -1 -0.4 intensity 0.8 shadows TRUE defaultShadowMap DEF Map "
    "GeneratedShadowMap "
    "{ update \"ALWAYS\" size 1024 } }";
inline const char* const kSpot =
    "DEF Lamp SpotLight { location 4 9 6 direction -4 -9 -6 cutOffAngle 0.9 beamWidth 0.9 intensity 0.8 radius 1e7 attenuation "
    "1 0 0 "
    "shadows TRUE defaultShadowMap DEF Map GeneratedShadowMap { update \"ALWAYS\" size 512 } }";

inline const char* const kBulb =
    "DEF Lamp PointLight { location 1 4 3 intensity 0.8 radius 1e7 attenuation 1 0 0 "
    "shadows TRUE defaultShadowMap DEF Map GeneratedShadowMap { update \"ALWAYS\" size 256 } }";

inline std::string box(const std::string& name, const std::string& place, const std::string& size) {
  return "DEF " + name + " Transform { " + place + " children Shape { appearance USE Grey geometry Box { size " + size +
         " } } }\n";
}

/// `light` goes first, `more` last among the Transform's children.
inline std::string boxes_scene(const std::string& light, const std::string& more = "") {
  return "#X3D V4.0 utf8\nPROFILE Full\nNavigationInfo { headlight FALSE }\n"
         "DEF Whole Transform { children [\n" +
         light +
         "\nDEF Near Viewpoint { position 5 5 9 orientation -0.73 0.65 0.2 0.68 }\n"
         "DEF High Viewpoint { position 0 14 0.1 orientation 1 0 0 -1.5637 }\n"
         "DEF Ground Transform { children Shape { appearance DEF Grey Appearance { material Material { diffuseColor 0.9 0.9 "
         "0.9 ambientIntensity 0 } } "
         "geometry IndexedFaceSet { coordIndex [0 1 2 3 -1] "
         "coord Coordinate { point [-30 0 30, 30 0 30, 30 0 -30, -30 0 -30] } } } }\n" +
         box("Tower", "translation 0.4 1.5 0 rotation 0 1 0 0.4", "1 3 1") +
         box("Wall", "translation -2.4 0.8 1.5 rotation 0 1 0 1.2", "3 1.6 0.4") +
         box("Table", "translation 2.2 1.2 1.4 rotation 0 1 0 0.2", "2 0.2 1.5") +
         box("Leg", "translation 2.2 0.55 1.4", "0.3 1.1 0.3") +
         box("Stone", "translation -1 0.35 -2.4 rotation 1 1 0 0.7", "1.5 1 1") + more + "] }\n";
}

}  // namespace plugc
