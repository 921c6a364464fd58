// A material of glTF is an Appearance with a PhysicalMaterial, or an UnlitMaterial where the material says so and for lines and
// points without normals, which glTF does not light. Alpha is transparency the other way round. Each texture names its set of
// coordinates by a mapping: set 1 is `TEXCOORD_1`, as the geometry calls it.

#include <fmt/format.h>

#include "document/gltf_reader.h"

namespace plugc {
namespace {

/// KHR_texture_transform of a texture, or null.
template <typename Info>
const tinygltf::Value* transform_of(const Info& info) {
  const auto found = info.extensions.find("KHR_texture_transform");
  return found == info.extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

/// The set of coordinates that a texture is laid on by; the transform may name another one.
template <typename Info>
int texture_set(const Info& info) {
  const tinygltf::Value* transform = transform_of(info);
  if (transform != nullptr && transform->Get("texCoord").IsInt()) return transform->Get("texCoord").GetNumberAsInt();
  return info.texCoord;
}

}  // namespace

std::string GltfReader::texture_set_name(int set) {
  return fmt::format("TEXCOORD_{}", set);
}

int GltfReader::main_texture_set(int material) const {
  if (material < 0) return 0;
  return texture_set(file_.model.materials[static_cast<std::size_t>(material)].pbrMetallicRoughness.baseColorTexture);
}

void GltfReader::appearance(int index, bool lit, const Span& place) {
  const std::pair key(index, lit);
  if (const auto known = appearances_.find(key); known != appearances_.end()) return write_.use(known->second, place);
  const GltfAt at = file_.item("materials", index);
  const Span span = at.valid() ? file_.text.place(at) : place;
  const tinygltf::Material none = [] {
    tinygltf::Material material;
    material.emissiveFactor = {0, 0, 0};
    return material;
  }();
  const tinygltf::Material& material = index < 0 ? none : file_.model.materials[static_cast<std::size_t>(index)];
  const std::string otherwise = index < 0 ? "material" : fmt::format("material_{}", index);
  const Name& def = appearances_[key] = write_.define(material.name, otherwise, at.valid() ? this->place(at, "name") : place);
  const bool unlit = !lit || material.extensions.contains("KHR_materials_unlit");
  write_.node("Appearance", def, span, [&] {
    write_.string("alphaMode", material.alphaMode, this->place(at, "alphaMode"));
    if (material.alphaMode == "MASK") write_.numbers("alphaCutoff", {material.alphaCutoff}, this->place(at, "alphaCutoff"));
    write_.nodes("material", span, [&] {
      write_.node(unlit ? "UnlitMaterial" : "PhysicalMaterial", {}, span,
                  [&] { unlit ? unlit_material(material, at) : physical_material(material, at); });
    });
    texture_transforms(material, at);
  });
}

void GltfReader::base_color(std::string_view field, const tinygltf::Material& material, GltfAt at) {
  const std::vector<double>& color = material.pbrMetallicRoughness.baseColorFactor;
  const Span span = place(file_.text.member(at, "pbrMetallicRoughness"), "baseColorFactor");
  write_.numbers(field, std::span(color).first(3), span);
  if (color[3] != 1 && material.alphaMode != "OPAQUE") write_.numbers("transparency", {1 - color[3]}, span);
}

void GltfReader::unlit_material(const tinygltf::Material& material, GltfAt at) {
  base_color("emissiveColor", material, at);
  texture({"emissiveTexture", "emissiveTextureMapping"}, material.pbrMetallicRoughness.baseColorTexture,
          file_.text.member(file_.text.member(at, "pbrMetallicRoughness"), "baseColorTexture"));
}

void GltfReader::physical_material(const tinygltf::Material& material, GltfAt at) {
  const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  const GltfAt written = file_.text.member(at, "pbrMetallicRoughness");
  const auto part = [&](std::string_view name) { return file_.text.member(at, name); };
  base_color("baseColor", material, at);
  write_.numbers("metallic", {pbr.metallicFactor}, place(written, "metallicFactor"));
  write_.numbers("roughness", {pbr.roughnessFactor}, place(written, "roughnessFactor"));
  write_.numbers("emissiveColor", material.emissiveFactor, place(at, "emissiveFactor"));
  texture({"baseTexture", "baseTextureMapping"}, pbr.baseColorTexture, file_.text.member(written, "baseColorTexture"));
  texture({"metallicRoughnessTexture", "metallicRoughnessTextureMapping"}, pbr.metallicRoughnessTexture,
          file_.text.member(written, "metallicRoughnessTexture"));
  texture({"emissiveTexture", "emissiveTextureMapping"}, material.emissiveTexture, part("emissiveTexture"));
  if (material.normalTexture.index >= 0) {
    write_.numbers("normalScale", {material.normalTexture.scale}, place(part("normalTexture"), "scale"));
    texture({"normalTexture", "normalTextureMapping"}, material.normalTexture, part("normalTexture"));
  }
  if (material.occlusionTexture.index >= 0) {
    write_.numbers("occlusionStrength", {material.occlusionTexture.strength}, place(part("occlusionTexture"), "strength"));
    texture({"occlusionTexture", "occlusionTextureMapping"}, material.occlusionTexture, part("occlusionTexture"));
  }
}

template <typename Info>
void GltfReader::texture(const TextureFields& fields, const Info& info, GltfAt at) {
  if (info.index < 0) return;
  const Span span = place(at, "index");
  write_.nodes(fields.texture, span, [&] { image_texture(info.index, span); });
  write_.string(fields.mapping, texture_set_name(texture_set(info)), place(at, "texCoord"));
}

/// One texture with a transform is a TextureTransform, several are a MultiTextureTransform, the main one's first.
void GltfReader::texture_transforms(const tinygltf::Material& material, GltfAt at) {
  const GltfAt pbr = file_.text.member(at, "pbrMetallicRoughness");
  std::vector<std::tuple<const tinygltf::Value*, int, GltfAt>> all;
  const auto note = [&](const auto& info, GltfAt written) {
    if (const auto* transform = transform_of(info); transform != nullptr && info.index >= 0) {
      const GltfAt extensions = file_.text.member(written, "extensions");
      all.emplace_back(transform, texture_set(info), file_.text.member(extensions, "KHR_texture_transform"));
    }
  };
  note(material.pbrMetallicRoughness.baseColorTexture, file_.text.member(pbr, "baseColorTexture"));
  note(material.pbrMetallicRoughness.metallicRoughnessTexture, file_.text.member(pbr, "metallicRoughnessTexture"));
  note(material.emissiveTexture, file_.text.member(at, "emissiveTexture"));
  note(material.normalTexture, file_.text.member(at, "normalTexture"));
  note(material.occlusionTexture, file_.text.member(at, "occlusionTexture"));
  if (all.empty()) return;
  const Span span = file_.text.place(std::get<2>(all[0]));
  write_.nodes("textureTransform", span, [&] {
    const auto write_all = [&] {
      std::set<int> sets;  // a mapping has one transform; materials give the textures of one set the same
      for (const auto& [transform, set, written] : all) {
        if (sets.insert(set).second) texture_transform(*transform, set, written);
      }
    };
    if (all.size() == 1) return write_all();
    write_.node("MultiTextureTransform", {}, span, [&] { write_.nodes("textureTransform", span, write_all); });
  });
}

}  // namespace plugc
