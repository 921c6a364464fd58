#pragma once
// Polygons as every composed geometry node describes them, before they become triangles.

#include <cstdint>
#include <span>
#include <vector>

#include "base/face_normals.h"
#include "mesh/geometry.h"
#include "mesh/live_vertices.h"

namespace plugc {

inline constexpr std::uint32_t kNoIndex = UINT32_MAX;

/// One corner of a face: a place in each of the lists below, or kNoIndex where the node has no such list.
struct Corner {
  std::uint32_t coord = kNoIndex;
  std::uint32_t normal = kNoIndex;
  std::uint32_t color = kNoIndex;
  std::uint32_t tex = kNoIndex;
  std::uint32_t tangent = kNoIndex;
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// All indices are valid and all coordinates that a face uses are finite. Faces run as written, whatever `ccw` says.
struct FaceSet {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> face_ends;  ///< Face i is corners [face_ends[i - 1], face_ends[i]).

  std::vector<glm::vec3> coords;
  std::vector<glm::vec3> normals;                 ///< Empty: to be generated.
  std::vector<glm::vec4> colors;                  ///< Empty: none.
  std::vector<glm::vec4> tangents;                ///< Empty: none are written.
  std::vector<std::vector<glm::vec4>> tex_units;  ///< An empty unit gets `default_tex`.
  std::vector<glm::vec4> default_tex;             ///< By coord; empty: the box texture.
  std::vector<float> fog_coords;                  ///< By coord; empty: none.
  std::vector<MeshAttribute> attributes;          ///< By coord.
  ListSlots lists;                                ///< Which of them events change.
  bool colors_have_alpha = false;

  float crease_angle = 0;         ///< For generated normals; pi smooths everything.
  bool normal_per_vertex = true;  ///< For generated normals: false makes each face flat.
  bool ccw = true;
  bool solid = true;
  bool convex = true;

  std::size_t face_count() const { return face_ends.size(); }
  std::size_t face_begin(std::size_t face) const { return face == 0 ? 0 : face_ends[face - 1]; }
  std::span<const Corner> face(std::size_t index) const {
    return {corners.data() + face_begin(index), face_ends[index] - face_begin(index)};
  }
  void add_face(std::span<const Corner> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    face_ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

/// The coordinates at the corners.
std::vector<std::uint32_t> corner_coords(const FaceSet& faces);

/// The normal of each face: see polygon_normals().
std::vector<glm::vec3> face_normals(const FaceSet& faces);

/// For generated normals: faces that meet at an angle with a smaller cosine have an edge between them.
float least_cosine(const FaceSet& faces);

/// Fills `normals` and the corners' places in them (X3D 4.1, 11.2.3 and 13.3.6: creaseAngle, normalPerVertex).
void generate_normals(FaceSet& faces, std::span<const glm::vec3> face_normals);

/// Triangles with one vertex for each different corner. Generates what is missing: normals and texture coordinates.
std::optional<Mesh> mesh_of_faces(FaceSet faces, const GeometrySource& source);

}  // namespace plugc
