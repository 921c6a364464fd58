#pragma once
// The numbers of an author's attribute at one vertex.

#include <span>

#include "mesh/mesh.h"

namespace plugc {

/// Numbers a vertex.
inline std::size_t number_count(const MeshAttribute& attribute) {
  return std::size_t{attribute.columns} * attribute.components;
}

inline std::span<const float> numbers_at(const MeshAttribute& attribute, std::size_t vertex) {
  const std::size_t count = number_count(attribute);
  return {attribute.values.data() + vertex * count, count};
}

}  // namespace plugc
