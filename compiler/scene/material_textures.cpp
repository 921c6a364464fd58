// The textures of a material beside its main one: X3D 4.1, 12.4.

#include <algorithm>

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

bool has_field(const NodeGraph& graph, NodeId node, std::string_view field) {
  return find_field_info(*graph[node].info, field) != nullptr;
}

}  // namespace

int coordinate_unit(const NodeGraph& graph, NodeId geometry, std::string_view mapping) {
  if (mapping.empty() || !has_field(graph, geometry, "texCoord")) return 0;
  const NodeId coordinates = graph.child(geometry, "texCoord");
  if (!graph.is(coordinates, "MultiTextureCoordinate")) return 0;
  const auto list = graph.children(coordinates, "texCoord");
  const auto found = std::find_if(list.begin(), list.end(), [&](NodeId unit) {
    return unit.valid() && has_field(graph, unit, "mapping") && graph.string(unit, "mapping") == mapping;
  });
  return found == list.end() ? 0 : static_cast<int>(found - list.begin());
}

void read_material_textures(SceneContext& context, NodeId material, NodeId transform, SceneShape& shape) {
  const NodeGraph& graph = context.graph;
  if (!material.valid() || graph.is(material, "UnlitMaterial")) return;
  for (const TextureField& field : kTextureFields) {
    if (!has_field(graph, material, field.texture)) continue;
    const int texture = texture_index(context, graph.child(material, field.texture));
    if (texture < 0) continue;
    const bool mapped = has_field(graph, material, field.mapping);
    const int unit = coordinate_unit(graph, shape.geometry, mapped ? graph.string(material, field.mapping) : "");
    shape.textures.push_back({.texture = texture,
                              .transform = unit_transform(context, transform, static_cast<std::size_t>(unit)),
                              .unit = unit,
                              .role = field.role});
  }
}

}  // namespace plugc
