// Lights (KHR_lights_punctual) and cameras look along -z of their node, as X3D's do when their fields say so. Light of glTF
// fades with the square of the distance; a radius of -1 ends it nowhere.

#include <algorithm>

#include <fmt/format.h>

#include "document/gltf_reader.h"

namespace plugc {

void GltfReader::light(const tinygltf::Node& node, GltfAt node_at) {
  const auto extension = node.extensions.find("KHR_lights_punctual");
  if (extension == node.extensions.end() || !extension->second.IsObject()) return;
  const tinygltf::Value& index = extension->second.Get("light");
  if (!index.IsInt()) return;
  const GltfAt extensions = file_.text.member(file_.text.root(), "extensions");
  const GltfAt lights = file_.text.member(file_.text.member(extensions, "KHR_lights_punctual"), "lights");
  const auto number = static_cast<std::size_t>(index.GetNumberAsInt());
  const GltfAt at = file_.text.item(lights, number);
  if (!at.valid() || file_.is_refused(at)) return;
  const tinygltf::Light& light = file_.model.lights[number];
  const bool directional = light.type == "directional", spot = light.type == "spot";
  const Name def = light.name.empty() ? Name() : write_.define(light.name, "", place(at, "name"));
  const Span span = place(node_at, "extensions");
  write_.node(directional ? "DirectionalLight"
              : spot      ? "SpotLight"
                          : "PointLight",
              def, span, [&] {
                if (!light.color.empty()) write_.numbers("color", light.color, place(at, "color"));
                write_.numbers("intensity", {light.intensity}, place(at, "intensity"));
                write_.boolean("global", true, span);
                if (directional) return;
                write_.numbers("attenuation", {0, 0, 1}, span);
                write_.numbers("radius", {light.range > 0 ? light.range : -1}, place(at, "range"));
                if (!spot) return;
                const GltfAt cone = file_.text.member(at, "spot");
                write_.numbers("beamWidth", {light.spot.innerConeAngle}, place(cone, "innerConeAngle"));
                write_.numbers("cutOffAngle", {light.spot.outerConeAngle}, place(cone, "outerConeAngle"));
              });
}

void GltfReader::camera(int index, const Span& place) {
  const GltfAt at = file_.item("cameras", index);
  if (file_.is_refused(at)) return;
  const tinygltf::Camera& camera = file_.model.cameras[static_cast<std::size_t>(index)];
  const bool perspective = camera.type == "perspective";
  const Name def = camera.name.empty() ? Name() : write_.define(camera.name, "", this->place(at, "name"));
  const GltfAt lens = file_.text.member(at, camera.type);
  write_.node(perspective ? "Viewpoint" : "OrthoViewpoint", def, place, [&] {
    write_.numbers("position", {0, 0, 0}, place);
    if (!camera.name.empty()) write_.string("description", camera.name, this->place(at, "name"));
    if (perspective) {
      write_.numbers("fieldOfView", {camera.perspective.yfov}, this->place(lens, "yfov"));
      write_.boolean("fieldOfViewForceVertical", true, this->place(lens, "yfov"));
    } else {
      const auto [x, y] = std::pair(camera.orthographic.xmag, camera.orthographic.ymag);
      write_.numbers("fieldOfView", {-x, -y, x, y}, this->place(lens, "xmag"));
    }
  });
}

}  // namespace plugc
