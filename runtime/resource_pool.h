#pragma once
// Meshes and textures of a package on the GPU, uploaded when first asked for and shared by all shapes.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/limits.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/texture.h"
#include "runtime/live_meshes.h"
#include "runtime/messages.h"

namespace plugc {

class ResourcePool {
 public:
  ResourcePool() = default;
  ResourcePool(const gl::Functions& functions, const Package& package, std::uint64_t texture_bytes = kMaxTextureBytes);

  const gl::Mesh& mesh(std::uint32_t index);
  /// Brings the mesh's vertices up to date.
  void rewrite_mesh(const LiveMesh& live);
  /// The mesh as that program reads it, where it reads attributes that only the mesh knows by name; else null: the mesh's own
  /// will do.
  const gl::VertexArray* custom_attributes(std::uint32_t mesh, std::uint32_t program);
  /// The texture as that sampler type reads it; white where the picture does not fit the sampler, the driver or the memory,
  /// which is reported.
  const gl::Texture& texture(std::uint32_t index, PackedUniformType sampler, Messages& messages);
  /// What a sampler reads that nothing feeds: white, or lit for one that compares. `reversed`: in place of such a map, with
  /// whose format a program keeps the driver's code for it.
  const gl::Texture& stand_in(PackedUniformType sampler, bool reversed = false);
  const gl::Sampler& depth_picture_sampler();
  const gl::Sampler& depth_texel_sampler();
  const gl::WholeTarget& whole_target();
  /// Of a map whose texels are lit where they are at most the reference depth.
  const gl::Sampler& greater_sampler();

 private:
  gl::Texture upload(std::uint32_t texture, PackedUniformType sampler, Messages& messages);

  const gl::Functions* gl_ = nullptr;
  const Package* package_ = nullptr;
  std::vector<std::optional<gl::Mesh>> meshes_;
  std::map<std::uint32_t, std::uint32_t> live_versions_;  ///< By mesh: LiveMesh::version of what was uploaded.
  std::map<std::pair<std::uint32_t, std::uint32_t>, gl::VertexArray> custom_attributes_;  ///< By mesh and program.
  std::uint64_t texture_bytes_left_ = 0;
  std::map<std::pair<std::uint32_t, GLenum>, gl::Texture> textures_;  ///< One picture can be read as 2D and as 3D.
  std::map<std::pair<PackedUniformType, bool>, gl::Texture> stand_ins_;
  gl::Sampler depth_picture_sampler_, depth_texel_sampler_, greater_sampler_;
  gl::WholeTarget whole_target_;
};

}  // namespace plugc
