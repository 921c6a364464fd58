// Generated normals. A corner's normal is the sum of the normals of those faces around its coordinate that meet its own face at
// less than the crease angle. The faces around a coordinate come from one adjacency list for all (a counting sort of corners
// by coordinate), so the work is the sum of squared valences; a coordinate with more than kMaxValence corners, which only a
// hostile file or a huge fan has, keeps flat corners. Equal sums at one coordinate share one normal, so that their corners
// weld.

#include <cmath>
#include <numbers>

#include "mesh/face_set.h"

namespace plugc {

namespace {

constexpr std::size_t kMaxValence = 512;

struct CornerPlace {
  std::uint32_t corner;
  std::uint32_t face;
};

// The corners at each coordinate: those of coordinate i are places [ends[i - 1], ends[i]).
struct Adjacency {
  std::vector<CornerPlace> places;
  std::vector<std::uint32_t> ends;

  std::span<const CornerPlace> at(std::size_t coord) const {
    const std::uint32_t begin = coord == 0 ? 0 : ends[coord - 1];
    return {places.data() + begin, ends[coord] - begin};
  }
};

Adjacency corners_by_coord(const FaceSet& faces) {
  Adjacency result;
  std::vector<std::uint32_t> next(faces.coords.size() + 1, 0);
  for (const Corner& corner : faces.corners) ++next[corner.coord + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  result.places.resize(faces.corners.size());
  for (std::uint32_t face = 0; face < faces.face_count(); ++face) {
    for (auto corner = static_cast<std::uint32_t>(faces.face_begin(face)); corner < faces.face_ends[face]; ++corner)
      result.places[next[faces.corners[corner].coord]++] = {corner, face};
  }
  next.pop_back();  // each start has moved to its end
  result.ends = std::move(next);
  return result;
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-20f && std::isfinite(length) ? v / length : otherwise;
}

class NormalGenerator {
 public:
  NormalGenerator(FaceSet& faces, std::span<const glm::vec3> of_faces) : faces_(faces), of_faces_(of_faces) {
    const bool smooth_all = faces.crease_angle >= static_cast<float>(std::numbers::pi);
    least_cosine_ = smooth_all ? -2.0f : std::cos(faces.crease_angle);
  }

  void flat() {
    faces_.normals.assign(of_faces_.begin(), of_faces_.end());
    for (std::uint32_t face = 0; face < faces_.face_count(); ++face)
      for (std::size_t i = faces_.face_begin(face); i < faces_.face_ends[face]; ++i) faces_.corners[i].normal = face;
  }

  void smooth() {
    const Adjacency adjacency = corners_by_coord(faces_);
    for (std::size_t coord = 0; coord < faces_.coords.size(); ++coord) smooth_around(adjacency.at(coord));
  }

 private:
  void smooth_around(std::span<const CornerPlace> around) {
    const std::size_t first = faces_.normals.size();
    for (const CornerPlace& place : around) {
      const glm::vec3 normal = around.size() > kMaxValence ? of_faces_[place.face] : sum_for(place, around);
      faces_.corners[place.corner].normal = find_or_add(normal, first, around.size());
    }
  }

  glm::vec3 sum_for(const CornerPlace& own, std::span<const CornerPlace> around) const {
    const glm::vec3& normal = of_faces_[own.face];
    glm::vec3 sum{0};
    for (const CornerPlace& other : around) {
      const glm::vec3& candidate = of_faces_[other.face];
      if (other.face == own.face || glm::dot(normal, candidate) > least_cosine_) sum += candidate;
    }
    return unit_or(sum, normal);
  }

  std::uint32_t find_or_add(const glm::vec3& normal, std::size_t first, std::size_t valence) {
    for (std::size_t i = first; i < faces_.normals.size() && valence <= kMaxValence; ++i)
      if (faces_.normals[i] == normal) return static_cast<std::uint32_t>(i);
    faces_.normals.push_back(normal);
    return static_cast<std::uint32_t>(faces_.normals.size() - 1);
  }

  FaceSet& faces_;
  std::span<const glm::vec3> of_faces_;
  float least_cosine_;
};

}  // namespace

std::vector<glm::vec3> face_normals(const FaceSet& faces) {
  std::vector<glm::vec3> result;
  result.reserve(faces.face_count());
  for (std::size_t index = 0; index < faces.face_count(); ++index) {
    const std::span<const Corner> face = faces.face(index);
    const glm::dvec3 origin = faces.coords[face[0].coord];  // large offsets must not eat the digits
    glm::dvec3 sum{0};
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      sum += glm::cross(glm::dvec3(faces.coords[face[i].coord]) - origin, glm::dvec3(faces.coords[face[i + 1].coord]) - origin);
    const double length = glm::length(sum);
    const glm::dvec3 normal = length > 0 && std::isfinite(length) ? sum / length : glm::dvec3(0, 0, 1);
    result.emplace_back(faces.ccw ? normal : -normal);
  }
  return result;
}

void generate_normals(FaceSet& faces, std::span<const glm::vec3> of_faces) {
  NormalGenerator generator(faces, of_faces);
  if (!faces.normal_per_vertex || faces.crease_angle <= 0)
    generator.flat();
  else
    generator.smooth();
}

}  // namespace plugc
