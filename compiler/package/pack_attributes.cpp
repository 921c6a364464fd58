// OpenGL has 16 places for vertex inputs. The renderer's own have theirs for good (PackedSemantic); an author's are laid from
// place 14 downwards, each matrix in neighbouring places, beside the texture coordinates that the program reads.

#include "package/pack_attributes.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "compose/castle_names.h"
#include "mesh/mesh_attribute.h"

namespace plugc {
namespace {

constexpr std::uint8_t kNoPlace = 255;
constexpr int kFirstCoord = 4, kLastCustom = 14;  // places, as runtime/gl/program.h has them

PackedSemantic semantic_of(std::string_view name, bool over_screen) {
  if (over_screen && name == "vertex") return PackedSemantic::position;
  if (over_screen && name == "tex_coord") return PackedSemantic::tex_coord;
  if (name == "castle_Vertex") return PackedSemantic::position;
  if (name == "castle_Normal") return PackedSemantic::normal;
  if (name == "castle_ColorPerVertex") return PackedSemantic::color;
  if (name == "castle_FogCoord") return PackedSemantic::fog_coord;
  if (name == "castle_Tangent") return PackedSemantic::tangent;
  return name.starts_with("castle_MultiTexCoord") ? PackedSemantic::tex_coord : PackedSemantic::custom;
}

/// Places that a variable takes.
int column_count(std::string_view type) {
  constexpr std::string_view kMatrix = "mat";
  if (!type.starts_with(kMatrix) || type.size() <= kMatrix.size()) return 1;
  return type[kMatrix.size()] - '0';
}

class Places {
 public:
  void take(int first, int count) {
    for (int i = std::max(first, 0); i < first + count && i <= kLastCustom; ++i) taken_[static_cast<std::size_t>(i)] = true;
  }
  /// The unit of the highest run of free places; kNoPlace where there is none.
  std::uint8_t take_run(int count) {
    for (int first = kLastCustom + 1 - count; first >= kFirstCoord; --first) {
      if (std::any_of(taken_.begin() + first, taken_.begin() + first + count, [](bool taken) { return taken; })) continue;
      take(first, count);
      return static_cast<std::uint8_t>(kLastCustom - first);
    }
    return kNoPlace;
  }

 private:
  std::array<bool, kLastCustom + 1> taken_{};
};

}  // namespace

std::int32_t pack_number(std::uint32_t number) {
  return number > INT32_MAX ? -1 : static_cast<std::int32_t>(number);
}

std::vector<std::unique_ptr<PackedAttributeT>> pack_attributes(const std::vector<ReflectedVariable>& variables,
                                                               bool over_screen) {
  std::vector<std::unique_ptr<PackedAttributeT>> packed;
  Places places;
  for (const ReflectedVariable& variable : variables) {
    auto attribute = std::make_unique<PackedAttributeT>();
    attribute->name = variable.name;
    attribute->location = pack_number(variable.location);
    attribute->semantic = semantic_of(variable.name, over_screen);
    if (attribute->semantic == PackedSemantic::tex_coord) {
      attribute->unit = static_cast<std::uint8_t>(std::max(find_castle_name(variable.name).value_or(CastleName{}).number, 0));
      places.take(kFirstCoord + attribute->unit, 1);
    }
    packed.push_back(std::move(attribute));
  }
  for (std::size_t i = 0; i < packed.size(); ++i) {
    if (packed[i]->semantic == PackedSemantic::custom) packed[i]->unit = places.take_run(column_count(variables[i].type));
  }
  return packed;
}

void add_mesh_attributes(const Mesh& mesh, PackedMeshT& packed) {
  for (const MeshAttribute& attribute : mesh.attributes) {
    auto added = std::make_unique<PackedMeshAttributeT>();
    added->name = attribute.name;
    added->columns = attribute.columns;
    added->components = attribute.components;
    added->offset = packed.stride;
    packed.stride += static_cast<std::uint32_t>(number_count(attribute) * sizeof(float));
    packed.attributes.push_back(std::move(added));
  }
}

void write_mesh_attributes(const Mesh& mesh, PackedMeshT& packed) {
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    const MeshAttribute& attribute = mesh.attributes[i];
    for (std::size_t vertex = 0; vertex < packed.vertex_count; ++vertex) {
      std::memcpy(packed.vertices.data() + vertex * packed.stride + packed.attributes[i]->offset,
                  numbers_at(attribute, vertex).data(), number_count(attribute) * sizeof(float));
    }
  }
}

bool are_equal(const std::vector<std::unique_ptr<PackedMeshAttributeT>>& a,
               const std::vector<std::unique_ptr<PackedMeshAttributeT>>& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) {
    return x->name == y->name && x->columns == y->columns && x->components == y->components && x->offset == y->offset;
  });
}

}  // namespace plugc
