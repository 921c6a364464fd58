#pragma once
// MaterialBinding and NormalBinding of VRML 1.0: which material or normal each face or vertex of an indexed shape takes.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace plugc {

enum class Vrml1Per : std::uint8_t { overall, part, face, vertex };

struct Vrml1Binding {
  Vrml1Per per = Vrml1Per::overall;
  bool indexed = false;  ///< By the shape's own list of indices, else counted.
};

/// `PER_FACE_INDEXED`. Any other word, such as `DEFAULT`, is `otherwise`.
Vrml1Binding read_binding(std::string_view word, const Vrml1Binding& otherwise);

/// A list that a binding chooses from, as far as it matters how the binding is meant.
struct Vrml1Choice {
  std::size_t count = 0;   ///< Of materials, or normals.
  std::size_t points = 0;  ///< Of the coordinates that the shape's indices are of.
};

/// An index for each face, or (bound per vertex) one for each vertex with the -1 between faces. All are 0 where the binding is
/// OVERALL. `own_index` may be empty: then vertices take the index of their coordinates, and faces are counted. Files have
/// PER_VERTEX in two meanings: a value for each vertex of each face, in order, where there are just as many values, or fewer
/// than points; else one for each point.
std::vector<double> bound_indices(const Vrml1Binding& binding, std::span<const double> coord_index,
                                  std::span<const double> own_index, const Vrml1Choice& choice);

}  // namespace plugc
