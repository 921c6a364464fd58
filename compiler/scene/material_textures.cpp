// The textures of a material beside its main one: X3D 4.1, 12.4.

#include <algorithm>

#include <fmt/format.h>

#include "scene/scene_context.h"

namespace plugc {
namespace {

struct TextureField {
  std::string_view texture, mapping;
  TextureRole role;
};

/// UnlitMaterial's emissiveTexture is its main one, and nothing lights what its normalTexture bends.
constexpr TextureField kTextureFields[] = {
    {"ambientTexture", "ambientTextureMapping", TextureRole::ambient},
    {"specularTexture", "specularTextureMapping", TextureRole::specular},
    {"shininessTexture", "shininessTextureMapping", TextureRole::shininess},
    {"emissiveTexture", "emissiveTextureMapping", TextureRole::emissive},
    {"occlusionTexture", "occlusionTextureMapping", TextureRole::occlusion},
    {"metallicRoughnessTexture", "metallicRoughnessTextureMapping", TextureRole::metallic_roughness},
    {"normalTexture", "normalTextureMapping", TextureRole::normal},
};

/// Volumes and cubes say nothing of a surface.
bool is_picture(SceneContext& context, NodeId node, int texture, std::string_view field) {
  if (context.scene.textures[static_cast<std::size_t>(texture)].kind == TextureKind::image_2d) return true;
  context.diagnostics.report(
      DiagnosticId::not_drawn, context.graph[node].type_span,
      fmt::format("a `{}` is not drawn as `{}`, which takes a picture", context.graph[node].info->name, field));
  return false;
}

}  // namespace

int coordinate_unit(const NodeGraph& graph, NodeId geometry, std::string_view mapping) {
  if (mapping.empty() || !graph.has_field(geometry, "texCoord")) return 0;
  const NodeId coordinates = graph.child(geometry, "texCoord");
  if (!graph.is(coordinates, "MultiTextureCoordinate")) return 0;
  const auto list = graph.children(coordinates, "texCoord");
  const auto found = std::find_if(list.begin(), list.end(), [&](NodeId unit) {
    return unit.valid() && graph.has_field(unit, "mapping") && graph.string(unit, "mapping") == mapping;
  });
  return found == list.end() ? 0 : static_cast<int>(found - list.begin());
}

void read_material_textures(SceneContext& context, NodeId material, NodeId transform, SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  if (!material.valid() || graph.is(material, "UnlitMaterial")) return;
  for (const TextureField& field : kTextureFields) {
    if (!graph.has_field(material, field.texture)) continue;
    const NodeId node = graph.child(material, field.texture);
    const int texture = texture_index(context, node);
    if (texture < 0 || !is_picture(context, node, texture, field.texture)) continue;
    const bool mapped = graph.has_field(material, field.mapping);
    const int unit = coordinate_unit(graph, shape.geometry, mapped ? graph.string(material, field.mapping) : "");
    shape.textures.push_back({.texture = texture,
                              .combination = {},
                              .transform = unit_transform(context, transform, static_cast<std::size_t>(unit)),
                              .unit = unit,
                              .role = field.role});
  }
}

void read_normal_map(SceneContext& context, NodeId appearance, SceneShape& shape) {
  const NodeId node = context.graph.child(appearance, "normalMap");
  if (!node.valid() || shape.material < 0) return;
  const bool is_bent = std::ranges::find(shape.textures, TextureRole::normal, &TextureUse::role) != shape.textures.end();
  const int texture = is_bent ? -1 : texture_index(context, node);
  if (texture < 0 || !is_picture(context, node, texture, "normalMap")) return;
  const int transform = unit_transform(context, context.graph.child(appearance, "textureTransform"), 0);
  shape.textures.push_back({.texture = texture, .combination = {}, .transform = transform, .role = TextureRole::normal});
}

}  // namespace plugc
