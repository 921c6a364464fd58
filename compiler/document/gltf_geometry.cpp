// A primitive is a Shape. Its mode chooses the geometry node; each attribute becomes one node of vertex data. Four things
// differ between glTF and X3D: without normals glTF shades flat; a colour of glTF is multiplied by the material's, one of X3D
// takes its place, so the product is written; v runs down from the top of an image, t up from its bottom; and points may be
// indexed.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "document/gltf_reader.h"

namespace plugc {
namespace {

int attribute_of(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

bool is_triangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

std::string_view in_words(int accessor_type) {
  switch (accessor_type) {
    case TINYGLTF_TYPE_SCALAR: return "SCALAR";
    case TINYGLTF_TYPE_VEC2: return "VEC2";
    case TINYGLTF_TYPE_VEC3: return "VEC3";
    case TINYGLTF_TYPE_VEC4: return "VEC4";
    default: return "a matrix";
  }
}

std::vector<double> counted(std::size_t count) {
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<double>(i);
  return numbers;
}

/// The elements that a list of indices names; those that do not exist are left out.
std::vector<double> gathered(const std::vector<double>& numbers, std::size_t components, const std::vector<double>& indices) {
  std::vector<double> result;
  for (const double index : indices) {
    const auto first = static_cast<std::size_t>(index) * components;
    if (first + components > numbers.size()) continue;
    result.insert(result.end(), numbers.begin() + static_cast<std::ptrdiff_t>(first),
                  numbers.begin() + static_cast<std::ptrdiff_t>(first + components));
  }
  return result;
}

}  // namespace

GltfAt GltfReader::attribute(GltfAt primitive, std::string_view name) const {
  return file_.text.member(file_.text.member(primitive, "attributes"), name);
}

/// The numbers of an attribute, when its accessor has one of the types that it may have.
std::optional<std::vector<double>> GltfReader::attribute_numbers(const tinygltf::Primitive& primitive, GltfAt at,
                                                                 const std::string& name, std::initializer_list<int> types) {
  const int accessor = attribute_of(primitive, name);
  if (accessor < 0 || file_.is_refused(file_.item("accessors", accessor))) return std::nullopt;
  const int type = file_.model.accessors[static_cast<std::size_t>(accessor)].type;
  if (std::ranges::find(types, type) == types.end()) {
    file_.text.mistake(attribute(at, name), fmt::format("`{}` takes {}, but accessor {} is {}", name, in_words(*types.begin()),
                                                        accessor, in_words(type)));
    return std::nullopt;
  }
  return file_.numbers(accessor);
}

void GltfReader::shape(const tinygltf::Primitive& primitive, GltfAt at) {
  if (file_.is_refused(at)) return;
  const int position = attribute_of(primitive, "POSITION");
  if (position < 0) return file_.text.mistake(at, "a primitive without `POSITION` cannot be drawn");
  const bool lit = is_triangles(primitive.mode) || attribute_of(primitive, "NORMAL") >= 0;
  write_.node("Shape", {}, file_.text.place(at), [&] {
    write_.nodes("appearance", file_.text.place(at), [&] { appearance(primitive.material, lit, place(at, "material")); });
    write_.nodes("geometry", file_.text.place(at), [&] { geometry(primitive, at); });
  });
}

void GltfReader::geometry(const tinygltf::Primitive& primitive, GltfAt at) {
  std::optional<std::vector<double>> indices;
  if (primitive.indices >= 0) {
    const GltfAt written = file_.text.member(at, "indices");
    if (file_.model.accessors[static_cast<std::size_t>(primitive.indices)].type != TINYGLTF_TYPE_SCALAR) {
      return file_.text.mistake(written, "indices are read from an accessor of type `SCALAR`");
    }
    indices = file_.numbers(primitive.indices);
    if (!indices) return;
    const auto odd = std::ranges::find_if(*indices, [](double index) { return index < 0 || index != std::trunc(index); });
    if (odd != indices->end()) return file_.text.mistake(written, fmt::format("{} is no index", *odd));
  }
  if (is_triangles(primitive.mode)) return triangles(primitive, at, indices);
  if (primitive.mode == TINYGLTF_MODE_POINTS) return points(primitive, at, indices);
  if (primitive.mode < 0 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    return file_.text.mistake(file_.text.member(at, "mode"), fmt::format("there is no mode {}; 0 to 6 are", primitive.mode));
  }
  lines(primitive, at, indices);
}

void GltfReader::triangles(const tinygltf::Primitive& primitive, GltfAt at, const Indices& indices) {
  const int position = attribute_of(primitive, "POSITION");
  const bool known = vertex_lists_.contains({position, "Coordinate"});
  const Numbers points = known ? Numbers() : attribute_numbers(primitive, at, "POSITION", {TINYGLTF_TYPE_VEC3});
  if (!known && !points) return;
  const bool strip = primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP, fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
  const std::string_view type = strip ? (indices ? "IndexedTriangleStripSet" : "TriangleStripSet")
                                : fan ? (indices ? "IndexedTriangleFanSet" : "TriangleFanSet")
                                      : (indices ? "IndexedTriangleSet" : "TriangleSet");
  const Span span = place(at, "indices");
  write_.node(type, {}, file_.text.place(at), [&] {
    if (indices) {
      write_.numbers("index", *indices, span);
    } else if (strip || fan) {
      const auto count = static_cast<double>(file_.model.accessors[static_cast<std::size_t>(position)].count);
      write_.numbers(strip ? "stripCount" : "fanCount", {count}, span);
    }
    if (primitive.material >= 0 && file_.model.materials[static_cast<std::size_t>(primitive.material)].doubleSided) {
      write_.boolean("solid", false, place(file_.item("materials", primitive.material), "doubleSided"));
    }
    if (attribute_of(primitive, "NORMAL") < 0) write_.boolean("normalPerVertex", false, file_.text.place(at));
    write_.nodes("coord", file_.text.place(attribute(at, "POSITION")),
                 [&] { vertex_list("Coordinate", "point", position, points, file_.text.place(attribute(at, "POSITION"))); });
    vertex_field("normal", "Normal", TINYGLTF_TYPE_VEC3, primitive, at, "NORMAL");
    vertex_field("tangent", "Tangent", TINYGLTF_TYPE_VEC4, primitive, at, "TANGENT");
    color(primitive, at, std::nullopt);
    texture_coordinates(primitive, at);
  });
}

/// A polyline ends at -1: pairs, one line through all, or one that also closes.
void GltfReader::lines(const tinygltf::Primitive& primitive, GltfAt at, const Indices& indices) {
  const auto position = static_cast<std::size_t>(attribute_of(primitive, "POSITION"));
  // Without indices the vertices are meant in order; reading them first bounds how many there can be.
  const auto points = attribute_numbers(primitive, at, "POSITION", {TINYGLTF_TYPE_VEC3});
  if (!points) return;
  const std::vector<double> order = indices ? *indices : counted(file_.model.accessors[position].count);
  std::vector<double> index;
  for (std::size_t i = 0; i < order.size(); ++i) {
    index.push_back(order[i]);
    if (primitive.mode == TINYGLTF_MODE_LINE && i % 2 == 1) index.push_back(-1);
  }
  if (primitive.mode == TINYGLTF_MODE_LINE_LOOP && !order.empty()) index.push_back(order.front());
  write_.node("IndexedLineSet", {}, file_.text.place(at), [&] {
    write_.numbers("coordIndex", index, place(at, "indices"));
    const Span span = file_.text.place(attribute(at, "POSITION"));
    write_.nodes("coord", span, [&] { write_.node("Coordinate", {}, span, [&] { write_.numbers("point", *points, span); }); });
    color(primitive, at, std::nullopt);
  });
}

void GltfReader::points(const tinygltf::Primitive& primitive, GltfAt at, const Indices& indices) {
  constexpr std::size_t kComponents = 3;
  auto points = attribute_numbers(primitive, at, "POSITION", {TINYGLTF_TYPE_VEC3});
  if (!points) return;
  if (indices) points = gathered(*points, kComponents, *indices);
  const Span span = file_.text.place(attribute(at, "POSITION"));
  write_.node("PointSet", {}, file_.text.place(at), [&] {
    write_.nodes("coord", span, [&] { write_.node("Coordinate", {}, span, [&] { write_.numbers("point", *points, span); }); });
    color(primitive, at, indices);
  });
}

/// A field with the vectors of one attribute.
void GltfReader::vertex_field(std::string_view field, std::string_view type, int element, const Primitive& primitive, GltfAt at,
                              const std::string& name) {
  const int accessor = attribute_of(primitive, name);
  if (accessor < 0) return;
  const Span span = file_.text.place(attribute(at, name));
  const bool known = vertex_lists_.contains({accessor, type});
  const Numbers numbers = known ? Numbers() : attribute_numbers(primitive, at, name, {element});
  if (known || numbers) write_.nodes(field, span, [&] { vertex_list(type, "vector", accessor, numbers, span); });
}

/// A node with the numbers of an accessor; without numbers, the one that was written for it before.
void GltfReader::vertex_list(std::string_view type, std::string_view list, int accessor, const Numbers& numbers,
                             const Span& span) {
  Name& def = vertex_lists_[{accessor, type}];
  if (!numbers) return write_.use(def, span);
  def = write_.define("", fmt::format("{}_{}", type, accessor), span);
  write_.node(type, def, span, [&] { write_.numbers(list, *numbers, span); });
}

void GltfReader::color(const tinygltf::Primitive& primitive, GltfAt at, const Indices& only) {
  const int accessor = attribute_of(primitive, "COLOR_0");
  if (accessor < 0) return;
  auto colors = attribute_numbers(primitive, at, "COLOR_0", {TINYGLTF_TYPE_VEC4, TINYGLTF_TYPE_VEC3});
  if (!colors) return;
  const bool alpha = file_.model.accessors[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC4;
  const std::size_t components = alpha ? 4 : 3;
  if (only) colors = gathered(*colors, components, *only);
  if (primitive.material >= 0) {
    const auto& factor =
        file_.model.materials[static_cast<std::size_t>(primitive.material)].pbrMetallicRoughness.baseColorFactor;
    for (std::size_t i = 0; i < colors->size(); ++i) (*colors)[i] *= factor[i % components];
  }
  const Span span = file_.text.place(attribute(at, "COLOR_0"));
  write_.nodes("color", span,
               [&] { write_.node(alpha ? "ColorRGBA" : "Color", {}, span, [&] { write_.numbers("color", *colors, span); }); });
}

/// The set of the main texture comes first, because a renderer that knows no mappings takes the sets in order.
void GltfReader::texture_coordinates(const tinygltf::Primitive& primitive, GltfAt at) {
  std::vector<int> sets;
  while (attribute_of(primitive, texture_set_name(static_cast<int>(sets.size()))) >= 0) {
    sets.push_back(static_cast<int>(sets.size()));
  }
  if (sets.empty()) return;
  const auto main = std::ranges::find(sets, main_texture_set(primitive.material));
  if (main != sets.end()) std::rotate(sets.begin(), main, main + 1);
  const Span span = file_.text.place(file_.text.member(at, "attributes"));
  write_.nodes("texCoord", span, [&] {
    const auto write_sets = [&] {
      for (const int set : sets) texture_coordinate_set(primitive, at, texture_set_name(set));
    };
    if (sets.size() == 1) return write_sets();
    write_.node("MultiTextureCoordinate", {}, span, [&] { write_.nodes("texCoord", span, write_sets); });
  });
}

void GltfReader::texture_coordinate_set(const tinygltf::Primitive& primitive, GltfAt at, const std::string& name) {
  const Span span = file_.text.place(attribute(at, name));
  const std::pair key(attribute_of(primitive, name), std::string_view("TextureCoordinate"));
  const auto known = vertex_lists_.find(key);
  if (known != vertex_lists_.end()) return write_.use(known->second, span);
  auto numbers = attribute_numbers(primitive, at, name, {TINYGLTF_TYPE_VEC2});
  if (!numbers) return;
  for (std::size_t i = 1; i < numbers->size(); i += 2) (*numbers)[i] = 1 - (*numbers)[i];
  const Name& def = vertex_lists_[key] = write_.define("", fmt::format("{}_{}", key.second, key.first), span);
  write_.node("TextureCoordinate", def, span, [&] {
    write_.string("mapping", name, span);
    write_.numbers("point", *numbers, span);
  });
}

}  // namespace plugc
