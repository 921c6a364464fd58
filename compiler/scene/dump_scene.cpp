// One line a thing, in the order of the scene's lists.

#include <fmt/format.h>

#include "scene/scene.h"

namespace plugc {
namespace {

constexpr std::string_view kLightKinds[] = {"directional", "point", "spot"};
constexpr std::string_view kFogKinds[] = {"none", "linear", "exponential", "either"};
constexpr std::string_view kParts[] = {"", " gradient", " back", " bottom", " front", " left", " right", " top"};
constexpr std::string_view kRenderedKinds[] = {"color", "depth", "cube"};
constexpr std::string_view kPartStages[] = {"VERTEX", "GEOMETRY", "FRAGMENT", "LIGHT"};

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:g}", text.empty() ? "" : " ", value);
  return text;
}

std::string indices(const std::vector<int>& list) {
  std::string text;
  for (const int index : list) text += fmt::format("{}{}", text.empty() ? "" : " ", index);
  return text.empty() ? "-" : text;
}

std::string received(const std::vector<ReceivedShadow>& shadows) {
  std::vector<int> lights;
  for (const ReceivedShadow& shadow : shadows) lights.push_back(shadow.light);
  return indices(lights);
}

std::string dump_effect(const SceneEffect& effect) {
  std::string text = fmt::format("`{}`", effect.label);
  for (const ShaderSource& part : effect.parts) {
    text += fmt::format(" {} ({} bytes)", kPartStages[static_cast<std::size_t>(part.stage)], part.text.size());
  }
  for (const ShaderField& field : effect.fields) {
    text += fmt::format("; {} {}", to_text(field.type), field.name);
    if (field.slot != kSceneNoSlot) text += fmt::format(" slot {}", field.slot);
    if (!field.textures.empty()) text += fmt::format(" textures {}", indices(field.textures));
  }
  return text;
}

}  // namespace

std::string dump_scene(const Scene& scene) {
  std::string text = fmt::format("scene {}\n", scene.name);
  for (std::size_t i = 0; i < scene.slots.size(); ++i) {
    const Slot& slot = scene.slots[i];
    text += fmt::format("slot {} {}{} = {}\n", i, slot.name.empty() ? "-" : slot.name, slot.routed ? " (routed)" : "",
                        numbers(slot.values));
  }
  for (std::size_t i = 0; i < scene.transforms.size(); ++i)
    text += fmt::format("transform {} parent {}\n", i, scene.transforms[i].parent);
  for (std::size_t i = 0; i < scene.effects.size(); ++i)
    text += fmt::format("effect {} {}\n", i, dump_effect(scene.effects[i]));
  for (std::size_t i = 0; i < scene.shaders.size(); ++i)
    text += fmt::format("shader {} {}\n", i, dump_effect(scene.shaders[i]));
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const SceneLight& light = scene.lights[i];
    text += fmt::format("light {} {} {}{} transform {} effects {}\n", i, kLightKinds[static_cast<std::size_t>(light.kind)],
                        light.label, light.shadow_map >= 0 ? fmt::format(" shadow map {}", light.shadow_map) : "",
                        light.transform, indices(light.effects));
  }
  for (std::size_t i = 0; i < scene.shadow_maps.size(); ++i) {
    const SceneShadowMap& map = scene.shadow_maps[i];
    text += fmt::format("shadow map {} light {} {} size {}{}{}\n", i, map.light, to_text(map.method), map.size,
                        map.scale_written ? " scale" : "", map.bias_written ? " bias" : "");
  }
  for (std::size_t i = 0; i < scene.fogs.size(); ++i) {
    const SceneFog& fog = scene.fogs[i];
    text += fmt::format("fog {} {} transform {}\n", i, kFogKinds[static_cast<std::size_t>(fog.kind)], fog.transform);
  }
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const SceneShape& shape = scene.shapes[i];
    text += fmt::format("shape {} {}{} transform {} lights {} receives {} textures {} effects {}{}{}\n", i, shape.name,
                        kParts[static_cast<std::size_t>(shape.part)], shape.transform, indices(shape.lights),
                        received(shape.receives), shape.textures.size(), indices(shape.effects),
                        shape.shader >= 0 ? fmt::format(" shader {}", shape.shader) : "",
                        shape.fog >= 0 ? fmt::format(" fog {}", shape.fog) : "");
  }
  for (std::size_t i = 0; i < scene.rendered_textures.size(); ++i) {
    const SceneRenderedTexture& texture = scene.rendered_textures[i];
    text += fmt::format("rendered texture {} {} {} x {} viewpoint {}{}{}{}{}\n", i,
                        kRenderedKinds[static_cast<std::size_t>(texture.kind)], texture.width, texture.height,
                        texture.viewpoint, texture.own_scene ? " own scene" : "", texture.in_mirror ? " in mirror" : "",
                        texture.own_backdrop ? " own backdrop" : "", texture.loans.empty() ? "" : " own fog");
  }
  for (std::size_t i = 0; i < scene.screen_effects.size(); ++i) {
    const SceneScreenEffect& effect = scene.screen_effects[i];
    text += fmt::format("screen effect {} {} shader {} transform {}{}\n", i, effect.label, effect.shader, effect.transform,
                        effect.needs_depth ? " depth" : "");
  }
  return text;
}

}  // namespace plugc
