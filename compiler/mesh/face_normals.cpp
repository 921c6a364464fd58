// Generated normals. A corner's normal is the sum of the normals of those faces around its coordinate that meet its own face at
// less than the crease angle. Equal sums at one coordinate share one normal, so that their corners weld. Where events will move
// the points no two need stay equal: then only those weld that are one sum whatever happens.

#include "base/face_normals.h"

#include <cmath>
#include <numbers>

#include "mesh/face_set.h"

namespace plugc {

namespace {

class NormalGenerator {
 public:
  NormalGenerator(FaceSet& faces, std::span<const glm::vec3> of_faces)
      : faces_(faces), of_faces_(of_faces), least_cosine_(least_cosine(faces)) {}

  void flat() {
    faces_.normals.assign(of_faces_.begin(), of_faces_.end());
    for (std::uint32_t face = 0; face < faces_.face_count(); ++face)
      for (std::size_t i = faces_.face_begin(face); i < faces_.face_ends[face]; ++i) faces_.corners[i].normal = face;
  }

  void smooth() {
    const std::vector<std::uint32_t> coords = corner_coords(faces_);
    const CornersAtPoints at_coords = corners_at_points({coords, faces_.face_ends}, faces_.coords.size());
    for (std::size_t coord = 0; coord < faces_.coords.size(); ++coord) smooth_around(at_coords.at(coord));
  }

 private:
  void smooth_around(std::span<const CornerPlace> around) {
    const std::size_t first = faces_.normals.size();
    const bool may_part = faces_.lists.coord.changes() && least_cosine_ != kSmoothAll;
    for (const CornerPlace& place : around) {
      const glm::vec3 normal = smooth_normal(place.face, around, of_faces_, least_cosine_);
      faces_.corners[place.corner].normal = find_or_add(normal, first, !may_part && around.size() <= kMaxValence);
    }
  }

  std::uint32_t find_or_add(const glm::vec3& normal, std::size_t first, bool may_share) {
    for (std::size_t i = first; i < faces_.normals.size() && may_share; ++i)
      if (faces_.normals[i] == normal) return static_cast<std::uint32_t>(i);
    faces_.normals.push_back(normal);
    return static_cast<std::uint32_t>(faces_.normals.size() - 1);
  }

  FaceSet& faces_;
  std::span<const glm::vec3> of_faces_;
  float least_cosine_;
};

}  // namespace

float least_cosine(const FaceSet& faces) {
  if (!faces.normal_per_vertex || faces.crease_angle <= 0) return kFlat;
  const bool smooth_all = faces.crease_angle >= static_cast<float>(std::numbers::pi);
  return smooth_all ? kSmoothAll : std::cos(faces.crease_angle);
}

std::vector<std::uint32_t> corner_coords(const FaceSet& faces) {
  std::vector<std::uint32_t> coords;
  coords.reserve(faces.corners.size());
  for (const Corner& corner : faces.corners) coords.push_back(corner.coord);
  return coords;
}

std::vector<glm::vec3> face_normals(const FaceSet& faces) {
  return polygon_normals({corner_coords(faces), faces.face_ends, !faces.ccw}, faces.coords);
}

void generate_normals(FaceSet& faces, std::span<const glm::vec3> of_faces) {
  NormalGenerator generator(faces, of_faces);
  if (least_cosine(faces) == kFlat)
    generator.flat();
  else
    generator.smooth();
}

}  // namespace plugc
