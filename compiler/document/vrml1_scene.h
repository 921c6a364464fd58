#pragma once
// The meaning of VRML 1.0, as nodes of X3D. A file of VRML 1.0 is a sequence of orders: a property holds for the shapes behind
// it until the next one of its kind, transforms multiply, lights light what stands behind them, and a Separator ends all of
// that with itself. So its children are gathered first, each with what holds for it; then those with one transform are written
// together:
//
//     Separator { Translation { translation 1 0 0 } Material { } Cube { } Sphere { } }
//     ->   Transform { translation 1 0 0 children [ Shape { ... geometry Box { } } Shape { ... geometry Sphere { } } ] }
//
// What is used again where the same holds for it becomes a USE; elsewhere it is written anew.

#include <array>
#include <map>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "document/node_writer.h"
#include "document/vrml1_binding.h"
#include "document/vrml1_tree.h"

namespace plugc {

/// The property of each slot that holds: its node, or where it is made of several its number; kNoVrml1Node where none was set.
struct Vrml1State {
  std::array<std::uint32_t, kVrml1Slots> nodes;
  std::uint32_t at(Vrml1Slot slot) const { return nodes[static_cast<std::size_t>(slot)]; }
  friend auto operator<=>(const Vrml1State&, const Vrml1State&) = default;
};
inline constexpr std::uint32_t kNoVrml1Node = UINT32_MAX;

struct Vrml1Part {
  std::string_view word;   ///< Of `parts`.
  std::string_view field;  ///< Of the node of X3D.
};
/// Of a Cylinder, in the order of its materials; a Cone has no top.
inline constexpr std::array<Vrml1Part, 3> kRoundParts = {{{"SIDES", "side"}, {"TOP", "top"}, {"BOTTOM", "bottom"}}};

class Vrml1Scene {
 public:
  Vrml1Scene(const Vrml1Tree& tree, DocumentBuilder& build) : tree_(tree), build_(build), write_(build) {}

  /// The statements of the document.
  void write();

 private:
  /// Where something stands in its separator: the product of the transforms before it.
  struct Placement {
    glm::dmat4 matrix{1.0};
    bool is_identity = true;
    std::uint32_t only = kNoVrml1Node;  ///< The one transform that it is the product of.
  };
  /// Something to be written, with indices into the lists of its Gathering.
  struct Item {
    Vrml1Child child;
    std::uint32_t state = 0, placement = 0;
  };
  struct Gathering {
    std::vector<Item> items;
    std::vector<Vrml1State> states;
    std::vector<Placement> placements = {Placement{}};
    std::uint32_t placement = 0;  ///< Where the next one stands.
  };
  struct PointRange {
    std::uint32_t first = 0, count = 0;
  };
  using Items = std::span<const Item>;
  struct TextureTransform {
    glm::dmat4 matrix;
    std::uint32_t node;  ///< The last one that it is the product of.
  };

  // vrml1_scene.cpp: what holds where, and the groups
  Gathering gather(std::span<const Vrml1Child> children, const Vrml1State& state);
  void gather_all(std::span<const Vrml1Child> children, Gathering& all);
  void gather_one(const Vrml1Child& child, Gathering& all);
  void gather_chosen(std::uint32_t node, Gathering& all);
  void set_property(std::uint32_t node, Gathering& all);
  void move(std::uint32_t transform, Gathering& all) const;
  glm::dmat4 matrix_of(std::uint32_t node) const;
  void write_items(const Gathering& all, Items items);
  bool opens_group(const Span& light);
  void write_run(const Gathering& all, Items run);
  void write_item(const Vrml1Child& child, const Vrml1State& state);
  /// A Group, or what puts its children where the placement says.
  template <typename Fill>
  void group(const Placement& placement, const Name& def, const Span& place, Fill fill) {
    if (!enter(place)) return;
    write_.node(group_type(placement), def, place, [&] {
      place_group(placement, place);
      write_.nodes("children", place, fill);
    });
    --depth_;
  }
  std::string_view group_type(const Placement& placement) const;
  void place_group(const Placement& placement, const Span& place);
  void separator(std::uint32_t node, const Vrml1State& state, const Name& def);
  void anchor(std::uint32_t node, const Vrml1State& state, const Name& def);
  void lod(std::uint32_t node, const Vrml1State& state, const Name& def);
  void plain_node(std::uint32_t node, const Name& def);
  bool spend(std::size_t work, const Span& place);
  bool enter(const Span& place);

  // vrml1_lights.cpp: lights and cameras
  void light(std::uint32_t node, const Placement& placement);
  void cone(std::uint32_t node, const Span& place);
  void camera(std::uint32_t node, const Name& def);

  // vrml1_geometry.cpp
  void shape(std::uint32_t node, const Vrml1State& state, const Name& def);
  void geometry(std::uint32_t node, const Vrml1State& state, const Span& place);
  void box(std::uint32_t node, const Span& place);
  void round_solid(std::uint32_t node, const Span& place);
  void text(std::uint32_t node, const Vrml1State& state, const Span& place);
  void face_set(std::uint32_t node, const Vrml1State& state, const Span& place);
  void face_hints(std::uint32_t hints, const Span& place);
  void line_set(std::uint32_t node, const Vrml1State& state, const Span& place);
  PointRange point_range(std::uint32_t node, const Vrml1State& state) const;
  void point_set(std::uint32_t node, const Vrml1State& state, const Span& place);
  void vertices(std::string_view field, std::string_view type, std::string_view list, std::uint32_t node, const Span& place);
  void normals(std::uint32_t node, const Vrml1State& state, const Span& place);

  std::size_t point_count(const Vrml1State& state) const;

  // vrml1_parts.cpp: the parts of solids
  bool has_part(std::uint32_t node, std::string_view field) const;
  bool has_bound_parts(std::uint32_t node, const Vrml1State& state);
  void bound_parts(std::uint32_t node, const Vrml1State& state, const Name& def);
  void bound_part(std::uint32_t node, const Vrml1State& state, std::size_t part, std::size_t number);
  void cube_face(std::uint32_t node, std::size_t face);
  void round_part(std::uint32_t node, std::size_t part);
  glm::dvec3 cube_size(std::uint32_t node) const;

  // vrml1_appearance.cpp
  void appearance(std::uint32_t shape, const Vrml1State& state, std::size_t number);
  void material(std::uint32_t shape, const Vrml1State& state, std::size_t number);
  double ambient_intensity(std::uint32_t material) const;
  bool is_precomputed(std::uint32_t material) const;
  bool has_faces(std::uint32_t shape) const;
  bool has_texture(std::uint32_t node) const;
  void texture(std::uint32_t node);
  void texture_transform(std::uint32_t index);
  std::uint32_t moved_texture(std::uint32_t before, std::uint32_t node);
  Vrml1Binding material_binding(const Vrml1State& state) const;
  std::string_view color_field(std::uint32_t shape, const Vrml1State& state);
  bool exceeds_zero(std::uint32_t material, std::string_view field);
  std::size_t color_count(std::uint32_t shape, const Vrml1State& state);
  std::size_t count_of(std::uint32_t material, std::string_view field) const;
  std::size_t material_period(std::uint32_t material) const;
  void append_color(std::vector<double>& list, std::uint32_t material, std::string_view field, std::size_t number) const;
  void colors(std::uint32_t node, const Vrml1State& state, const Span& place);
  void color_list(std::string_view field, std::uint32_t material, std::size_t count);
  void point_colors(std::uint32_t node, const Vrml1State& state, const PointRange& points);
  bool has_transparencies(std::uint32_t shape, const Vrml1State& state);

  // vrml1_fields.cpp
  const Vrml1Field* find(std::uint32_t node, std::string_view name) const;
  std::span<const double> numbers(std::uint32_t node, std::string_view name) const;
  double number(std::uint32_t node, std::string_view name, double otherwise) const;
  glm::dvec3 vector(std::uint32_t node, std::string_view name, const glm::dvec3& otherwise) const;
  glm::dvec4 rotation(std::uint32_t node, std::string_view name) const;
  std::span<const MappedText> strings(std::uint32_t node, std::string_view name) const;
  std::string_view word(std::uint32_t node, std::string_view name) const;
  bool has_word(std::uint32_t node, std::string_view name, std::string_view word) const;
  std::span<const double> indices(std::uint32_t node, std::string_view name) const;
  Span place_of(std::uint32_t node) const;
  void pass(std::uint32_t node, std::string_view name, std::string_view as);
  void pass(std::uint32_t node, std::initializer_list<std::string_view> names);
  void pass_element(std::uint32_t node, std::string_view name, std::size_t number, std::string_view as);

  /// The node that is made of a property's list: written where it is first needed, and USEd from then on.
  template <typename Fill>
  void shared(std::uint32_t node, std::string_view type, std::string_view list, Fill fill) {
    const auto [known, is_new] = lists_.try_emplace({node, list});
    if (!is_new) return write_.use(known->second, place_of(node));
    known->second = write_.define(tree_.nodes[node].def.text, tree_.nodes[node].info->name, place_of(node));
    write_.node(type, known->second, place_of(node), fill);
  }

  const Vrml1Tree& tree_;
  DocumentBuilder& build_;
  NodeWriter write_;
  std::map<std::pair<std::uint32_t, Vrml1State>, Name> written_;             // nodes that USE names, with what held for them
  std::map<std::pair<std::uint32_t, std::string_view>, Name> lists_;         // properties, with the field whose list it is
  std::map<std::pair<std::uint32_t, std::string_view>, bool> exceeds_zero_;  // lists of materials, by field
  std::vector<TextureTransform> texture_transforms_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> texture_numbers_;  // of them, by what they are made of
  std::uint32_t depth_ = 0;
  bool lights_are_mixed_ = false;  // with shapes that they should not light; reported
  std::size_t work_ = 0;
};

}  // namespace plugc
