// Lights and cameras. A light shines on what the group around it holds; it must not stand in a Transform of its own, so that
// its place is multiplied out.

#include <algorithm>
#include <cmath>

#include "document/vrml1_scene.h"

namespace plugc {

void Vrml1Scene::light(std::uint32_t node, const Placement& placement) {
  const std::string_view type = tree_.nodes[node].info->name;
  const Span place = place_of(node);
  const auto put = [&](std::string_view field, const glm::dvec4& at) {
    const glm::dvec4 moved = placement.matrix * at;
    write_.numbers(field, {moved.x, moved.y, moved.z}, place);
  };
  write_.node(type, {}, place, [&] {
    pass(node, {"on", "intensity", "color"});
    if (type != "PointLight") put("direction", glm::dvec4(vector(node, "direction", {0, 0, -1}), 0));
    if (type == "DirectionalLight") return;
    put("location", glm::dvec4(vector(node, "location", {0, 0, 1}), 1));
    write_.boolean("global", false, place);
    write_.numbers("radius", {-1}, place);  // it ends nowhere
    if (type == "SpotLight") cone(node, place);
  });
}

/// Within its cone a light of VRML 1.0 falls off as a power of the cosine, 128 * dropOffRate; one of X3D evenly from the
/// beamWidth to the cutOffAngle. Both are half as bright at the same angle.
void Vrml1Scene::cone(std::uint32_t node, const Span& place) {
  constexpr double kQuarterPi = 0.785398, kLargestPower = 128, kNarrowest = 1e-3;  // a beamWidth is above 0
  const double cut_off = number(node, "cutOffAngle", kQuarterPi);
  const double power = kLargestPower * number(node, "dropOffRate", 0);
  const double half = power > 0 ? std::acos(std::pow(0.5, 1 / power)) : cut_off;
  write_.numbers("cutOffAngle", {std::min(cut_off, power > 0 ? 2 * half : cut_off)}, place);
  write_.numbers("beamWidth", {power > 0 ? kNarrowest : cut_off}, place);
}

void Vrml1Scene::camera(std::uint32_t node, const Name& def) {
  constexpr double kHeightAngle = 0.785398, kHeight = 2;
  const bool perspective = tree_.nodes[node].info->name == "PerspectiveCamera";
  const Span place = place_of(node);
  write_.node(perspective ? "Viewpoint" : "OrthoViewpoint", def, place, [&] {
    const glm::dvec3 position = vector(node, "position", {0, 0, 1});
    write_.numbers("position", {position.x, position.y, position.z}, place);
    pass(node, {"orientation"});
    if (!def.empty()) write_.string("description", tree_.nodes[node].def.text, def.span);
    if (perspective) {
      write_.numbers("fieldOfView", {number(node, "heightAngle", kHeightAngle)}, place);
      write_.boolean("fieldOfViewForceVertical", true, place);
    } else {
      const double half = number(node, "height", kHeight) / 2;
      write_.numbers("fieldOfView", {-half, -half, half, half}, place);
    }
  });
}

}  // namespace plugc
