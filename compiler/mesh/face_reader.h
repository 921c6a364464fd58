#pragma once
// Builds a FaceSet from the fields that all composed geometry nodes share, checking every index on the way.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "mesh/face_set.h"

namespace plugc {

/// Reads the lists once, then takes faces one by one. A face with a bad index is reported (the first of its kind in a node) and
/// left out; so is one with a coordinate that is no finite number.
class FaceReader {
 public:
  /// Reads normal, tangent, color, texCoord, ccw and solid. The index lists beside coordIndex are read where the node type has
  /// them.
  FaceReader(const GeometrySource& source, std::vector<glm::vec3> coords);

  /// A face given by its coordinates' indices. `position` is where they begin in coordIndex, for the lists that run beside it.
  void add_face(std::span<const std::int64_t> coord_indices, std::size_t position = 0);

  FaceSet faces;

 private:
  // An attribute: a list, and how a corner finds its place in it.
  struct Channel {
    std::string_view field;             // that holds the list
    std::string_view index_field = {};  // "" when the node type has none
    std::span<const double> index = {};
    std::size_t size = 0;  // of the list; 0: the node has none
    bool per_vertex = true;
    bool reported = false;
  };

  Channel channel(std::string_view field, std::string_view index_field, std::string_view per_vertex_field,
                  std::size_t size) const;
  bool is_usable(std::int64_t coord);
  bool find(Channel& channel, std::int64_t coord, std::size_t position, std::uint32_t& result);
  void report_index(Channel& channel, std::int64_t index);

  const GeometrySource& source_;
  Channel coord_, normal_, color_, tex_, tangent_;
  std::vector<Corner> face_;    // at hand
  std::size_t faces_seen_ = 0;  // left-out ones too: they have their places in the per-face lists
  bool reported_not_finite_ = false;
  bool reported_limit_ = false;
};

}  // namespace plugc
