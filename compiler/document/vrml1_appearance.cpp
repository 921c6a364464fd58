// Materials, textures, and colours of parts. X3D has one material a shape, whose diffuse (or, unlit, emissive) colour alone
// may differ from vertex to vertex and face to face: of a list of materials the others count by their first.

#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "base/transform_matrix.h"
#include "document/vrml1_scene.h"

namespace plugc {
namespace {

constexpr double kDiffuse = 0.8;

}  // namespace

/// With the material of that number, where the list has several.
void Vrml1Scene::appearance(std::uint32_t shape, const Vrml1State& state, std::size_t number) {
  const Span place = place_of(shape);
  const std::uint32_t texture_node = state.at(Vrml1Slot::texture);
  write_.node("Appearance", {}, place, [&] {
    write_.nodes("material", place, [&] { material(shape, state, number); });
    if (has_transparencies(shape, state)) write_.string("alphaMode", "BLEND", place);
    if (!has_faces(shape) || !has_texture(texture_node)) return;
    write_.nodes("texture", place, [&] { texture(texture_node); });
    texture_transform(state.at(Vrml1Slot::texture_transform));
  });
}

void Vrml1Scene::material(std::uint32_t shape, const Vrml1State& state, std::size_t number) {
  const std::uint32_t node = state.at(Vrml1Slot::material);
  const Span place = node == kNoVrml1Node ? place_of(shape) : place_of(node);
  if (!has_faces(shape) || is_precomputed(node)) {
    return write_.node("UnlitMaterial", {}, place, [&] {
      const std::string_view color = color_field(shape, state);
      pass_element(node, color, number, "emissiveColor");
      if (numbers(node, color).empty()) write_.numbers("emissiveColor", {kDiffuse, kDiffuse, kDiffuse}, place);
      pass_element(node, "transparency", number, "transparency");
    });
  }
  write_.node("Material", {}, place, [&] {
    for (const std::string_view field : {"diffuseColor", "specularColor", "emissiveColor", "shininess", "transparency"}) {
      pass_element(node, field, number, field);
    }
    write_.numbers("ambientIntensity", {ambient_intensity(node)}, place);
  });
}

/// X3D has the ambient colour as a part of the diffuse one.
double Vrml1Scene::ambient_intensity(std::uint32_t material) const {
  constexpr double kAmbient = 0.2;
  const glm::dvec3 ambient = vector(material, "ambientColor", glm::dvec3(kAmbient));
  const glm::dvec3 diffuse = vector(material, "diffuseColor", glm::dvec3(kDiffuse));
  const auto largest = [](const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); };
  return largest(diffuse) > 0 ? std::clamp(largest(ambient) / largest(diffuse), 0.0, 1.0) : 0;
}

/// Whether a material says by `diffuseColor [ ]` that its emissive colours are the result of a lighting made before.
bool Vrml1Scene::is_precomputed(std::uint32_t material) const {
  const Vrml1Field* diffuse = find(material, "diffuseColor");
  return diffuse != nullptr && diffuse->value.count == 0 && !numbers(material, "emissiveColor").empty();
}

bool Vrml1Scene::has_faces(std::uint32_t shape) const {
  const std::string_view type = tree_.nodes[shape].info->name;
  return type != "IndexedLineSet" && type != "PointSet";
}

/// What tells the materials of a list apart. Lines and points are not lit: they glow, or show their diffuse colour.
std::string_view Vrml1Scene::color_field(std::uint32_t shape, const Vrml1State& state) {
  const std::uint32_t material = state.at(Vrml1Slot::material);
  const bool glows = !has_faces(shape) && exceeds_zero(material, "emissiveColor");
  return is_precomputed(material) || glows ? "emissiveColor" : "diffuseColor";
}

/// Whether any number of the list is above 0. Looked for once, as many shapes may have that material.
bool Vrml1Scene::exceeds_zero(std::uint32_t material, std::string_view field) {
  const auto [known, is_new] = exceeds_zero_.try_emplace({material, field});
  if (is_new) known->second = std::ranges::any_of(numbers(material, field), [](double number) { return number > 0; });
  return known->second;
}

// Textures

bool Vrml1Scene::has_texture(std::uint32_t node) const {
  return !word(node, "filename").empty() || !numbers(node, "image").empty();
}

/// Blender began names of files with `//`, meaning the folder of its own.
void Vrml1Scene::texture(std::uint32_t node) {
  constexpr std::string_view kOwnFolder = "//";
  const bool is_file = !word(node, "filename").empty();
  shared(node, is_file ? "ImageTexture" : "PixelTexture", "filename", [&] {
    if (!is_file) {
      pass(node, {"image"});
    } else if (const MappedText& name = strings(node, "filename")[0]; name.text().starts_with(kOwnFolder)) {
      MappedText url;
      url.append(name, static_cast<std::uint32_t>(kOwnFolder.size()), name.size());
      write_.string("url", std::move(url), find(node, "filename")->name.span);
    } else {
      pass(node, "filename", "url");
    }
    if (has_word(node, "wrapS", "CLAMP")) write_.boolean("repeatS", false, find(node, "wrapS")->value.span);
    if (has_word(node, "wrapT", "CLAMP")) write_.boolean("repeatT", false, find(node, "wrapT")->value.span);
  });
}

/// The product of all that hold: each is scaled first, then turned, both about its centre, then moved (X3D does that in the
/// other order, so that its matrix node says it).
void Vrml1Scene::texture_transform(std::uint32_t index) {
  if (index == kNoVrml1Node) return;
  const TextureTransform& transform = texture_transforms_[index];
  const Span place = place_of(transform.node);
  write_.nodes("textureTransform", place, [&] {
    write_.node("TextureTransformMatrix3D", {}, place,
                [&] { write_.numbers("matrix", std::span(glm::value_ptr(transform.matrix), 16), place); });
  });
}

/// The one that comes of another by a node; a number for each pair, so that equal states stay equal.
std::uint32_t Vrml1Scene::moved_texture(std::uint32_t before, std::uint32_t node) {
  const auto next = static_cast<std::uint32_t>(texture_transforms_.size());
  const auto [known, is_new] = texture_numbers_.try_emplace({before, node}, next);
  if (!is_new) return known->second;
  const auto plane = [&](std::string_view field, double otherwise, double depth) {
    const auto written = numbers(node, field);
    return written.empty() ? glm::dvec3(otherwise, otherwise, depth) : glm::dvec3(written[0], written[1], depth);
  };
  const glm::dvec4 turn(0, 0, 1, number(node, "rotation", 0));
  const glm::dmat4 own =
      transform_matrix(plane("translation", 0, 0), turn, plane("scaleFactor", 1, 1), {0, 0, 1, 0}, plane("center", 0, 0));
  const bool is_first = before == kNoVrml1Node;
  texture_transforms_.push_back({is_first ? own : texture_transforms_[before].matrix * own, node});
  return next;
}

// Colours

Vrml1Binding Vrml1Scene::material_binding(const Vrml1State& state) const {
  return read_binding(word(state.at(Vrml1Slot::material_binding), "value"), {});
}

std::size_t Vrml1Scene::count_of(std::uint32_t material, std::string_view field) const {
  const Vrml1Field* written = find(material, field);
  return written == nullptr ? 0 : written->value.count / component_count(written->info->type);
}

/// Materials behind the last one begin anew; how many there are is told by the field that has the most.
std::size_t Vrml1Scene::material_period(std::uint32_t material) const {
  std::size_t period = 1;
  for (const std::string_view field :
       {"ambientColor", "diffuseColor", "specularColor", "emissiveColor", "shininess", "transparency"}) {
    period = std::max(period, count_of(material, field));
  }
  return period;
}

/// Of colours that parts of a shape can have, with the alphas that several transparencies make of them.
std::size_t Vrml1Scene::color_count(std::uint32_t shape, const Vrml1State& state) {
  const std::uint32_t material = state.at(Vrml1Slot::material);
  const std::size_t colors = count_of(material, color_field(shape, state)), alphas = count_of(material, "transparency");
  return colors == 0 || alphas <= 1 ? colors : std::max(colors, alphas);
}

/// The colour of the material of that number. A field that has fewer values keeps its last one.
void Vrml1Scene::append_color(std::vector<double>& list, std::uint32_t material, std::string_view field,
                              std::size_t number) const {
  constexpr std::size_t kComponents = 3;
  const auto colors = numbers(material, field), transparency = numbers(material, "transparency");
  const std::size_t first = kComponents * std::min(number, colors.size() / kComponents - 1);
  list.insert(list.end(), {colors[first], colors[first + 1], colors[first + 2]});
  if (transparency.size() > 1) list.push_back(1 - transparency[std::min(number, transparency.size() - 1)]);
}

void Vrml1Scene::colors(std::uint32_t node, const Vrml1State& state, const Span& place) {
  const Vrml1Binding binding = material_binding(state);
  const auto coord_index = numbers(node, "coordIndex");
  const std::size_t count = color_count(node, state);
  if (count <= 1 || binding.per == Vrml1Per::overall || !spend(coord_index.size(), place)) return;
  const std::uint32_t material = state.at(Vrml1Slot::material);
  std::vector<double> index = bound_indices(binding, coord_index, indices(node, "materialIndex"), {count, point_count(state)});
  const auto period = static_cast<double>(material_period(material)), last = static_cast<double>(count - 1);
  for (double& one : index) one = std::min(one < period ? one : std::fmod(one, period), last);
  if (binding.per != Vrml1Per::vertex) write_.boolean("colorPerVertex", false, place);
  write_.numbers("colorIndex", index, place);
  write_.nodes("color", place, [&] { color_list(color_field(node, state), material, count); });
}

void Vrml1Scene::color_list(std::string_view field, std::uint32_t material, std::size_t count) {
  if (count_of(material, "transparency") <= 1) {
    return shared(material, "Color", field, [&] { pass(material, field, "color"); });
  }
  shared(material, "ColorRGBA", field, [&] {
    std::vector<double> list;
    for (std::size_t i = 0; i < count; ++i) append_color(list, material, field, i);
    write_.numbers("color", list, find(material, field)->name.span);
  });
}

/// Points have no indices: each gets a colour of its own, counted with the coordinates.
void Vrml1Scene::point_colors(std::uint32_t node, const Vrml1State& state, const PointRange& points) {
  const Span place = place_of(node);
  if (material_binding(state).per == Vrml1Per::overall || color_count(node, state) <= 1) return;
  if (!spend(points.count, place)) return;
  const std::uint32_t material = state.at(Vrml1Slot::material);
  const std::size_t period = material_period(material);
  std::vector<double> list;
  for (std::size_t i = 0; i < points.count; ++i) {
    append_color(list, material, color_field(node, state), (points.first + i) % period);
  }
  const std::string_view type = count_of(material, "transparency") > 1 ? "ColorRGBA" : "Color";
  write_.nodes("color", place, [&] { write_.node(type, {}, place, [&] { write_.numbers("color", list, place); }); });
}

/// Whether parts of a shape differ in transparency, which the alphas of colours say alone.
bool Vrml1Scene::has_transparencies(std::uint32_t shape, const Vrml1State& state) {
  const std::uint32_t material = state.at(Vrml1Slot::material);
  const bool is_bound = material_binding(state).per != Vrml1Per::overall && color_count(shape, state) > 1;
  return is_bound && count_of(material, "transparency") > 1 && exceeds_zero(material, "transparency");
}

}  // namespace plugc
