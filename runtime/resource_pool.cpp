// Lookup, upload when absent, hand out a reference. Nothing is dropped before the scene is.

#include "runtime/resource_pool.h"

namespace plugc {

namespace {

/// Whether the driver takes it, as the target has it: a picture is the first slice of a volume.
bool has_place(const PackedImage& image, GLenum target, std::uint32_t largest) {
  return image.width() <= largest && image.height() <= largest && (target != GL_TEXTURE_3D || image.depth() <= largest);
}

/// On the GPU, with its smaller copies.
std::uint64_t bytes_of(const PackedImage& image) {
  constexpr std::uint64_t kTexel = 4;
  return kTexel * image.width() * image.height() * image.depth() * 4 / 3;
}

}  // namespace

ResourcePool::ResourcePool(const gl::Functions& functions, const Package& package, std::uint64_t texture_bytes)
    : gl_(&functions), package_(&package), meshes_(package.meshes()->size()), texture_bytes_left_(texture_bytes) {}

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
  texture = upload(index, sampler, messages);
  if (!texture) texture = gl::make_white_texture(*gl_, gl::texture_target(sampler));
  return texture;
}

gl::Texture ResourcePool::upload(std::uint32_t index, PackedUniformType sampler, Messages& messages) {
  const PackedTexture& packed = *package_->textures()->Get(index);
  const PackedImage& image = *package_->images()->Get(packed.image());
  const GLenum target = gl::texture_target(sampler);
  const GLsizei largest = gl::max_texture_side(*gl_, target);
  gl::Texture made;
  if (!has_place(image, target, static_cast<std::uint32_t>(largest))) {
    messages.add("texture " + std::to_string(index) + " has more texels along a side than the driver's " +
                 std::to_string(largest) + ": it is white");
  } else if (bytes_of(image) > texture_bytes_left_) {
    messages.add("the scene's textures need more memory than they get: the last are white");
  } else {
    made = gl::upload_texture(*gl_, packed, image, sampler);
    if (made)
      texture_bytes_left_ -= bytes_of(image);
    else
      messages.add("texture " + std::to_string(index) + " does not fit the sampler that reads it: it is white");
  }
  return made;
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
