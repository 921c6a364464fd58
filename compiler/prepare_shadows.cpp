// A map that only the renderer's own code reads may be stored and fitted as suits the renderer; here the others are found.

#include "prepare_shadows.h"

#include <algorithm>

#include <fmt/format.h>

#include "shadow_geometry.h"

namespace plugc {
namespace {

void mark(Scene& scene, int map) {
  if (map >= 0) scene.shadow_maps[static_cast<std::size_t>(map)].author_visible = true;
}

void mark_texture(Scene& scene, int texture) {
  if (texture >= 0) mark(scene, scene.textures[static_cast<std::size_t>(texture)].shadow_map);
}

void mark_fields(const std::vector<SceneEffect>& authors, Scene& scene) {
  for (const SceneEffect& author : authors) {
    for (const ShaderField& field : author.fields) {
      for (const int texture : field.textures) mark_texture(scene, texture);
    }
  }
}

bool names_a_map(const EffectCode& code) {
  return std::ranges::any_of(code.castle_names, [](const std::string& name) {
    return name.starts_with("castle_shadow_map") || name.starts_with("castle_projector_matrix") ||
           name.starts_with("castle_projected_tex_coord");
  });
}

/// Whether it fills a plug whose light need not come from the light's own colours.
bool adds_light(const EffectCode& code) {
  constexpr std::string_view kLightPlugs[] = {"add_light", "add_light_contribution", "material_light_ambient",
                                              "material_light_diffuse", "material_light_specular"};
  return std::ranges::any_of(kLightPlugs, [&](std::string_view plug) { return code.fills(plug); });
}

/// Why a map cannot be traced; empty when it can.
std::string obstacle(const SceneShadowMap& map, const std::vector<EffectCode>& effects, const std::vector<AlphaUse>& alpha,
                     const SceneParts& parts) {
  if (map.author_visible) return "its map is looked into";
  const Scene& scene = parts.scene;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const SceneShape& shape = scene.shapes[i];
    const bool shows = std::ranges::find(shape.receives, map.light, &ReceivedShadow::light) != shape.receives.end();
    if ((shape.casts_shadow || shows) && may_move_vertices(scene, shape, effects))
      return fmt::format("a shader may move the vertices of `{}`", shape.name);
    if ((shape.casts_shadow || shows) && !shape.clip_planes.empty()) return fmt::format("a `ClipPlane` cuts `{}`", shape.name);
    if (may_cut_holes(scene, shape, effects)) return fmt::format("an effect cuts holes into `{}`", shape.name);
    if (alpha[i] == AlphaUse::tested && lays_alpha_elsewhere(parts, shape))
      return fmt::format("the texture that cuts holes into `{}` does not lie by its own texture coordinates", shape.name);
  }
  return "";
}

}  // namespace

void replace_untraceable_maps(const NodeGraph& graph, const std::vector<EffectCode>& effects,
                              const std::vector<AlphaUse>& alpha, SceneParts& parts, Diagnostics& diagnostics) {
  for (SceneShadowMap& map : parts.scene.shadow_maps) {
    if (map.method != ShadowMethod::traced) continue;
    const std::string why = obstacle(map, effects, alpha, parts);
    if (why.empty()) continue;
    map.method = kDefaultShadowMethod;
    diagnostics.report(DiagnosticId::shadow_unsupported,
                       graph[parts.scene.lights[static_cast<std::size_t>(map.light)].node].type_span,
                       fmt::format("this light's shadow cannot be traced: {}; it comes from a map (`{}`)", why,
                                   to_text(kDefaultShadowMethod)));
  }
}

void mark_maps_of_other_light(const std::vector<EffectCode>& effects, Scene& scene) {
  const auto brings_light = [&](int effect) { return adds_light(effects[static_cast<std::size_t>(effect)]); };
  for (const SceneShape& shape : scene.shapes) {
    const auto texture_brings = [&](const TextureUse& use) {
      return use.texture >= 0 &&
             std::ranges::any_of(scene.textures[static_cast<std::size_t>(use.texture)].effects, brings_light);
    };
    const bool of_shape = shape.shader >= 0 || std::ranges::any_of(shape.effects, brings_light) ||
                          std::ranges::any_of(shape.textures, texture_brings);
    for (const ReceivedShadow& shadow : shape.receives) {
      const SceneLight& light = scene.lights[static_cast<std::size_t>(shadow.light)];
      if (shadow.shadow_map >= 0 && (of_shape || std::ranges::any_of(light.effects, brings_light)))
        scene.shadow_maps[static_cast<std::size_t>(shadow.shadow_map)].other_light = true;
    }
  }
}

void mark_author_visible_maps(const std::vector<EffectCode>& effects, const std::vector<EffectCode>& shaders, Scene& scene) {
  for (const SceneShape& shape : scene.shapes) {
    for (const TextureUse& use : shape.textures) {
      mark_texture(scene, use.texture);
      if (use.projector >= 0) mark(scene, scene.projectors[static_cast<std::size_t>(use.projector)].shadow_map);
    }
    for (const ReceivedShadow& shadow : shape.receives) {
      if (shadow.compare != DepthCompare::less_equal)
        mark(scene, shadow.shadow_map);  // a comparison that is not the renderer's
    }
  }
  mark_fields(scene.effects, scene);
  mark_fields(scene.shaders, scene);
  if (!std::ranges::any_of(effects, names_a_map) && !std::ranges::any_of(shaders, names_a_map)) return;
  for (SceneShadowMap& map : scene.shadow_maps) map.author_visible = true;
}

}  // namespace plugc
