#include "document/vrml1_binding.h"

#include <algorithm>

namespace plugc {
namespace {

std::vector<double> vertex_indices(std::span<const double> coord_index, std::span<const double> own_index) {
  std::vector<double> indices(coord_index.begin(), coord_index.end());
  for (std::size_t i = 0; i < std::min(indices.size(), own_index.size()); ++i) {
    if (indices[i] >= 0) indices[i] = own_index[i];
  }
  return indices;
}

std::vector<double> counted_vertices(std::span<const double> coord_index) {
  std::vector<double> indices;
  double next = 0;
  for (const double point : coord_index) indices.push_back(point < 0 ? -1 : next++);
  return indices;
}

std::vector<double> face_indices(const Vrml1Binding& binding, std::span<const double> coord_index,
                                 std::span<const double> own_index) {
  std::vector<double> indices;
  for (std::size_t i = 0; i < coord_index.size(); ++i) {
    const bool ends = coord_index[i] < 0 || i + 1 == coord_index.size();
    if (!ends) continue;
    const std::size_t face = indices.size();
    const bool own = binding.indexed && face < own_index.size();
    indices.push_back(binding.per == Vrml1Per::overall ? 0 : own ? own_index[face] : static_cast<double>(face));
  }
  return indices;
}

}  // namespace

Vrml1Binding read_binding(std::string_view word, const Vrml1Binding& otherwise) {
  constexpr std::string_view kIndexed = "_INDEXED";
  Vrml1Binding binding;
  binding.indexed = word.ends_with(kIndexed);
  if (binding.indexed) word.remove_suffix(kIndexed.size());
  if (word == "OVERALL") return binding;
  if (word != "PER_PART" && word != "PER_FACE" && word != "PER_VERTEX") return otherwise;
  binding.per = word == "PER_PART" ? Vrml1Per::part : word == "PER_FACE" ? Vrml1Per::face : Vrml1Per::vertex;
  return binding;
}

std::vector<double> bound_indices(const Vrml1Binding& binding, std::span<const double> coord_index,
                                  std::span<const double> own_index, const Vrml1Choice& choice) {
  if (binding.per != Vrml1Per::vertex) return face_indices(binding, coord_index, own_index);
  if (binding.indexed) return vertex_indices(coord_index, own_index);
  const auto is_vertex = [](double point) { return point >= 0; };
  const auto vertices = static_cast<std::size_t>(std::ranges::count_if(coord_index, is_vertex));
  const bool counted = choice.count != choice.points && (choice.count == vertices || choice.count < choice.points);
  return counted ? counted_vertices(coord_index) : vertex_indices(coord_index, {});
}

}  // namespace plugc
