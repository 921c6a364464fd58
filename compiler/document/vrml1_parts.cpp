// Cubes, cylinders and cones whose parts have materials of their own, bound PER_PART: a shape for each part.

#include <algorithm>

#include "document/vrml1_scene.h"

namespace plugc {
namespace {

// Corners of a cube: 1 is right, 2 up, 4 in front. Its faces in the order of their materials, each as its front is seen.
constexpr std::array<std::array<int, 4>, 6> kCubeFaces = {
    {{4, 5, 7, 6}, {1, 0, 2, 3}, {0, 4, 6, 2}, {5, 1, 3, 7}, {6, 7, 3, 2}, {0, 1, 5, 4}}};

}  // namespace

bool Vrml1Scene::has_part(std::uint32_t node, std::string_view field) const {
  const std::string_view type = tree_.nodes[node].info->name;
  return type == "Cylinder" || (type == "Cone" && field != "top");
}

/// Parts of a cube are its faces.
bool Vrml1Scene::has_bound_parts(std::uint32_t node, const Vrml1State& state) {
  const Vrml1Per per = material_binding(state).per;
  const bool is_cube = tree_.nodes[node].info->name == "Cube";
  const bool is_bound =
      is_cube ? per == Vrml1Per::part || per == Vrml1Per::face : has_part(node, "side") && per == Vrml1Per::part;
  return is_bound && color_count(node, state) > 1;
}

/// A part that is not drawn keeps its material.
void Vrml1Scene::bound_parts(std::uint32_t node, const Vrml1State& state, const Name& def) {
  const bool whole = find(node, "parts") == nullptr || has_word(node, "parts", "ALL");
  group({}, def, place_of(node), [&] {
    if (tree_.nodes[node].info->name == "Cube") {
      for (std::size_t face = 0; face < kCubeFaces.size(); ++face) bound_part(node, state, face, face);
      return;
    }
    std::size_t number = 0;
    for (std::size_t part = 0; part < kRoundParts.size(); ++part) {
      if (!has_part(node, kRoundParts[part].field)) continue;
      if (whole || has_word(node, "parts", kRoundParts[part].word)) bound_part(node, state, part, number);
      ++number;
    }
  });
}

void Vrml1Scene::bound_part(std::uint32_t node, const Vrml1State& state, std::size_t part, std::size_t number) {
  const Span place = place_of(node);
  const bool is_cube = tree_.nodes[node].info->name == "Cube";
  write_.node("Shape", {}, place, [&] {
    write_.nodes("appearance", place,
                 [&] { appearance(node, state, number % material_period(state.at(Vrml1Slot::material))); });
    write_.nodes("geometry", place, [&] { is_cube ? cube_face(node, part) : round_part(node, part); });
  });
}

glm::dvec3 Vrml1Scene::cube_size(std::uint32_t node) const {
  constexpr double kSide = 2;
  return {number(node, "width", kSide), number(node, "height", kSide), number(node, "depth", kSide)};
}

void Vrml1Scene::cube_face(std::uint32_t node, std::size_t face) {
  const Span place = place_of(node);
  const glm::dvec3 half = cube_size(node) / 2.0;
  std::vector<double> points;
  for (const int corner : kCubeFaces[face]) {
    points.push_back((corner & 1) != 0 ? half.x : -half.x);
    points.push_back((corner & 2) != 0 ? half.y : -half.y);
    points.push_back((corner & 4) != 0 ? half.z : -half.z);
  }
  write_.node("IndexedFaceSet", {}, place, [&] {
    write_.numbers("coordIndex", {0, 1, 2, 3}, place);
    write_.boolean("solid", false, place);
    write_.nodes("coord", place,
                 [&] { write_.node("Coordinate", {}, place, [&] { write_.numbers("point", points, place); }); });
    write_.nodes("texCoord", place, [&] {
      write_.node("TextureCoordinate", {}, place, [&] { write_.numbers("point", {0, 0, 1, 0, 1, 1, 0, 1}, place); });
    });
  });
}

void Vrml1Scene::round_part(std::uint32_t node, std::size_t part) {
  const Span place = place_of(node);
  write_.node(tree_.nodes[node].info->name, {}, place, [&] {
    pass(node, {"radius", "bottomRadius", "height"});
    for (const Vrml1Part& other : kRoundParts) {
      if (has_part(node, other.field) && other.field != kRoundParts[part].field) write_.boolean(other.field, false, place);
    }
    write_.boolean("solid", false, place);
  });
}

}  // namespace plugc
