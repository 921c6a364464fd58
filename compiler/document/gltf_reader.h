#pragma once
// glTF as the X3D 4 nodes that mean the same (X3D 4.0 part 1, 12.2.4: PhysicalMaterial is glTF's material). Each function
// writes the nodes of one thing at the place where they belong; what several places use is DEFined once and USEd from then on.

#include <map>
#include <set>

#include "document/gltf_file.h"
#include "document/node_writer.h"

namespace plugc {

class GltfReader {
 public:
  explicit GltfReader(GltfFile& file) : file_(file), write_(file.build) {}

  /// The scene that the file shows; without one, every node that is nobody's child.
  void read();

 private:
  using Numbers = std::optional<std::vector<double>>;
  using Indices = Numbers;
  using Primitive = tinygltf::Primitive;
  /// A field of a material that holds a texture, and the one that names its coordinates.
  struct TextureFields {
    std::string_view texture, mapping;
  };

  // read_gltf.cpp: the tree of nodes
  std::vector<int> root_nodes();
  void node(int index, std::uint32_t depth);
  void transform(const tinygltf::Node& node, GltfAt at);
  void matrix(const std::vector<double>& matrix, GltfAt at);
  void mesh(int index, const Span& place);
  void report_unread();

  // gltf_geometry.cpp
  void shape(const Primitive& primitive, GltfAt at);
  void geometry(const Primitive& primitive, GltfAt at);
  void triangles(const Primitive& primitive, GltfAt at, const Indices& indices);
  void lines(const Primitive& primitive, GltfAt at, const Indices& indices);
  void points(const Primitive& primitive, GltfAt at, const Indices& indices);
  void vertex_field(std::string_view field, std::string_view type, int element, const Primitive& primitive, GltfAt at,
                    const std::string& name);
  void vertex_list(std::string_view type, std::string_view list, int accessor, const Numbers& numbers, const Span& span);
  void color(const Primitive& primitive, GltfAt at, const Indices& only);
  void texture_coordinates(const Primitive& primitive, GltfAt at);
  void texture_coordinate_set(const Primitive& primitive, GltfAt at, const std::string& name);
  GltfAt attribute(GltfAt primitive, std::string_view name) const;
  Numbers attribute_numbers(const Primitive& primitive, GltfAt at, const std::string& name, std::initializer_list<int> types);

  // gltf_material.cpp
  static std::string texture_set_name(int set);
  int main_texture_set(int material) const;
  void appearance(int material, bool lit, const Span& place);
  void physical_material(const tinygltf::Material& material, GltfAt at);
  void unlit_material(const tinygltf::Material& material, GltfAt at);
  void base_color(std::string_view field, const tinygltf::Material& material, GltfAt at);
  template <typename Info>
  void texture(const TextureFields& fields, const Info& info, GltfAt at);
  void texture_transforms(const tinygltf::Material& material, GltfAt at);

  // gltf_textures.cpp
  void image_texture(int index, const Span& place);
  void image_url(int image);
  void texture_properties(int sampler);
  void texture_transform(const tinygltf::Value& transform, int set, GltfAt at);

  // gltf_lights.cpp
  void light(const tinygltf::Node& node, GltfAt at);
  void camera(int index, const Span& place);

  /// Of a member of an object, or of the object where it has no such member.
  Span place(GltfAt object, std::string_view member) const;

  GltfFile& file_;
  NodeWriter write_;
  std::set<int> visited_;                                          // nodes
  std::map<int, Name> meshes_, textures_;                          // what was DEFined
  std::map<std::pair<int, bool>, Name> appearances_;               // of materials, lit or not
  std::map<std::pair<int, std::string_view>, Name> vertex_lists_;  // of accessors, by the type of the node
};

}  // namespace plugc
