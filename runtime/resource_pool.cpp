// Lookup, upload when absent, hand out a reference. Nothing is dropped before the scene is.

#include "runtime/resource_pool.h"

namespace plugc {

ResourcePool::ResourcePool(const gl::Functions& functions, const Package& package)
    : gl_(&functions), package_(&package), meshes_(package.meshes()->size()) {}

const gl::Mesh& ResourcePool::mesh(std::uint32_t index) {
  std::optional<gl::Mesh>& slot = meshes_[index];
  if (!slot) slot = gl::upload_mesh(*gl_, *package_->meshes()->Get(index));
  return *slot;
}

void ResourcePool::rewrite_mesh(const LiveMesh& live) {
  const std::uint32_t index = live.packed->mesh();
  std::uint32_t& uploaded = live_versions_[index];
  if (uploaded == live.version) return;
  gl::rewrite_vertices(*gl_, mesh(index), live.vertices);
  uploaded = live.version;
}

const gl::VertexArray* ResourcePool::custom_attributes(std::uint32_t index, std::uint32_t program) {
  const PackedMesh& packed = *package_->meshes()->Get(index);
  if (packed.attributes() == nullptr || packed.attributes()->size() == 0) return nullptr;
  const gl::Attributes& attributes = *package_->programs()->Get(program)->attributes();
  if (!gl::reads_custom(packed, attributes)) return nullptr;
  gl::VertexArray& array = custom_attributes_[{index, program}];
  if (!array) array = gl::make_vertex_array(*gl_, mesh(index), packed, {}, attributes);
  return &array;
}

const gl::Texture& ResourcePool::texture(std::uint32_t index, PackedUniformType sampler, Messages& messages) {
  gl::Texture& texture = textures_[{index, gl::texture_target(sampler)}];
  if (texture) return texture;
  const PackedTexture& packed = *package_->textures()->Get(index);
  texture = gl::upload_texture(*gl_, packed, *package_->images()->Get(packed.image()), sampler);
  if (!texture) {
    messages.add("texture " + std::to_string(index) + " does not fit the sampler that reads it: it is white");
    texture = gl::make_white_texture(*gl_, gl::texture_target(sampler));
  }
  return texture;
}

const gl::Texture& ResourcePool::stand_in(PackedUniformType sampler, bool reversed) {
  gl::Texture& texture = stand_ins_[{sampler, reversed}];
  if (texture) return texture;
  const bool compares = sampler == PackedUniformType::sampler2DShadow || sampler == PackedUniformType::samplerCubeShadow;
  const GLenum target = gl::texture_target(sampler);
  texture = compares ? gl::make_lit_texture(*gl_, target, reversed) : gl::make_white_texture(*gl_, target);
  return texture;
}

const gl::Sampler& ResourcePool::depth_picture_sampler() {
  if (!depth_picture_sampler_) depth_picture_sampler_ = gl::make_depth_picture_sampler(*gl_);
  return depth_picture_sampler_;
}

const gl::Sampler& ResourcePool::depth_texel_sampler() {
  if (!depth_texel_sampler_) depth_texel_sampler_ = gl::make_depth_texel_sampler(*gl_);
  return depth_texel_sampler_;
}

const gl::WholeTarget& ResourcePool::whole_target() {
  if (!whole_target_.vertex_array) whole_target_ = gl::make_whole_target(*gl_);
  return whole_target_;
}

const gl::Sampler& ResourcePool::greater_sampler() {
  if (!greater_sampler_) greater_sampler_ = gl::make_greater_sampler(*gl_);
  return greater_sampler_;
}

}  // namespace plugc
