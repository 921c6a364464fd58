// Shapes. What the properties hold for one is written into its geometry node, lists of vertices once for all that use them.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "document/vrml1_binding.h"
#include "document/vrml1_scene.h"

namespace plugc {

void Vrml1Scene::shape(std::uint32_t node, const Vrml1State& state, const Name& def) {
  if (has_bound_parts(node, state)) return bound_parts(node, state, def);
  const Span place = place_of(node);
  write_.node("Shape", def, place, [&] {
    write_.nodes("appearance", place, [&] { appearance(node, state, 0); });
    write_.nodes("geometry", place, [&] { geometry(node, state, place); });
  });
}

void Vrml1Scene::geometry(std::uint32_t node, const Vrml1State& state, const Span& place) {
  const std::string_view type = tree_.nodes[node].info->name;
  if (type == "IndexedFaceSet") return face_set(node, state, place);
  if (type == "IndexedLineSet") return line_set(node, state, place);
  if (type == "PointSet") return point_set(node, state, place);
  if (type == "Cube") return box(node, place);
  if (type == "AsciiText") return text(node, state, place);
  round_solid(node, place);
}

void Vrml1Scene::box(std::uint32_t node, const Span& place) {
  const glm::dvec3 size = cube_size(node);
  write_.node("Box", {}, place, [&] {
    write_.numbers("size", {size.x, size.y, size.z}, place);
    write_.boolean("solid", false, place);
  });
}

/// A Sphere, Cone or Cylinder. ShapeHints are for faces: the inside of a solid shows where one looks into it.
void Vrml1Scene::round_solid(std::uint32_t node, const Span& place) {
  const bool whole = find(node, "parts") == nullptr || has_word(node, "parts", "ALL");
  write_.node(tree_.nodes[node].info->name, {}, place, [&] {
    pass(node, {"radius", "bottomRadius", "height"});
    write_.boolean("solid", false, place);
    if (whole) return;
    const Span parts = find(node, "parts")->value.span;
    for (const auto& [word, field] : kRoundParts) {
      if (has_part(node, field) && !has_word(node, "parts", word)) write_.boolean(field, false, parts);
    }
  });
}

void Vrml1Scene::text(std::uint32_t node, const Vrml1State& state, const Span& place) {
  constexpr double kSize = 10;
  const std::uint32_t font = state.at(Vrml1Slot::font_style);
  const std::string_view justification = word(node, "justification");
  const bool bold = has_word(font, "style", "BOLD"), italic = has_word(font, "style", "ITALIC");
  write_.node("Text", {}, place, [&] {
    pass(node, {"string"});
    pass(node, "width", "length");
    write_.nodes("fontStyle", place, [&] {
      write_.node("FontStyle", {}, place, [&] {
        write_.numbers("size", {number(font, "size", kSize)}, place);
        pass(font, {"family"});
        if (bold || italic) write_.string("style", bold && italic ? "BOLDITALIC" : bold ? "BOLD" : "ITALIC", place);
        pass(node, {"spacing"});
        if (justification == "CENTER") write_.string("justify", "MIDDLE", place);
        if (justification == "RIGHT") write_.string("justify", "END", place);
      });
    });
  });
}

void Vrml1Scene::face_set(std::uint32_t node, const Vrml1State& state, const Span& place) {
  write_.node("IndexedFaceSet", {}, place, [&] {
    pass(node, {"coordIndex"});
    vertices("coord", "Coordinate", "point", state.at(Vrml1Slot::coordinate), place);
    if (has_texture(state.at(Vrml1Slot::texture)) && state.at(Vrml1Slot::texture_coordinate) != kNoVrml1Node) {
      if (!indices(node, "textureCoordIndex").empty()) pass(node, "textureCoordIndex", "texCoordIndex");
      vertices("texCoord", "TextureCoordinate", "point", state.at(Vrml1Slot::texture_coordinate), place);
    }
    normals(node, state, place);
    colors(node, state, place);
    face_hints(state.at(Vrml1Slot::shape_hints), place);
  });
}

void Vrml1Scene::face_hints(std::uint32_t hints, const Span& place) {
  constexpr double kCreaseAngle = 0.5;
  const bool is_clockwise = has_word(hints, "vertexOrdering", "CLOCKWISE");
  const bool is_ordered = is_clockwise || has_word(hints, "vertexOrdering", "COUNTERCLOCKWISE");
  if (is_clockwise) write_.boolean("ccw", false, place);
  if (!is_ordered || !has_word(hints, "shapeType", "SOLID")) write_.boolean("solid", false, place);
  if (has_word(hints, "faceType", "UNKNOWN_FACE_TYPE")) write_.boolean("convex", false, place);
  write_.numbers("creaseAngle", {number(hints, "creaseAngle", kCreaseAngle)}, place);
}

void Vrml1Scene::line_set(std::uint32_t node, const Vrml1State& state, const Span& place) {
  if (material_binding(state).per == Vrml1Per::part && color_count(node, state) > 1) {
    build_.diagnostics.report(DiagnosticId::not_drawn, place,
                              "materials are bound to segments of these lines; each line is drawn with the first one");
  }
  write_.node("IndexedLineSet", {}, place, [&] {
    pass(node, {"coordIndex"});
    vertices("coord", "Coordinate", "point", state.at(Vrml1Slot::coordinate), place);
    if (material_binding(state).per != Vrml1Per::part) colors(node, state, place);
  });
}

/// `numPoints` from `startIndex` on, or all.
Vrml1Scene::PointRange Vrml1Scene::point_range(std::uint32_t node, const Vrml1State& state) const {
  const auto all = static_cast<double>(point_count(state));
  const double first = std::clamp(number(node, "startIndex", 0), 0.0, all);
  const double wanted = number(node, "numPoints", -1);
  return {static_cast<std::uint32_t>(first),
          static_cast<std::uint32_t>(wanted < 0 ? all - first : std::min(wanted, all - first))};
}

void Vrml1Scene::point_set(std::uint32_t node, const Vrml1State& state, const Span& place) {
  constexpr std::uint32_t kComponents = 3;
  const PointRange range = point_range(node, state);
  const Vrml1Field* points = find(state.at(Vrml1Slot::coordinate), "point");
  if (range.count == 0) return;
  ValueSyntax part = points->value;
  part.first += kComponents * range.first;
  part.count = kComponents * range.count;
  write_.node("PointSet", {}, place, [&] {
    write_.nodes("coord", place,
                 [&] { write_.node("Coordinate", {}, place, [&] { write_.value("point", part, points->name.span); }); });
    point_colors(node, state, range);
  });
}

/// A node with the list of a property, in the field of that name.
void Vrml1Scene::vertices(std::string_view field, std::string_view type, std::string_view list, std::uint32_t node,
                          const Span& place) {
  if (find(node, list) == nullptr) return;
  write_.nodes(field, place, [&] { shared(node, type, list, [&] { pass(node, {list}); }); });
}

std::size_t Vrml1Scene::point_count(const Vrml1State& state) const {
  return numbers(state.at(Vrml1Slot::coordinate), "point").size() / 3;
}

/// Where there are too few normals for the binding, none of them counts.
void Vrml1Scene::normals(std::uint32_t node, const Vrml1State& state, const Span& place) {
  const std::uint32_t normal = state.at(Vrml1Slot::normal);
  const std::size_t count = numbers(normal, "vector").size() / 3;
  const auto coord_index = numbers(node, "coordIndex");
  if (count == 0 || !spend(coord_index.size(), place)) return;
  const Vrml1Binding binding = read_binding(word(state.at(Vrml1Slot::normal_binding), "value"), {Vrml1Per::vertex, true});
  const std::vector<double> index =
      bound_indices(binding, coord_index, indices(node, "normalIndex"), {count, point_count(state)});
  if (std::ranges::any_of(index, [&](double one) { return one >= static_cast<double>(count); })) return;
  if (binding.per != Vrml1Per::vertex) write_.boolean("normalPerVertex", false, place);
  write_.numbers("normalIndex", index, place);
  vertices("normal", "Normal", "vector", normal, place);
}

}  // namespace plugc
