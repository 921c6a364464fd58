// Sums are taken in double relative to a polygon's first corner, so that large offsets do not eat the digits. The corners at
// each point come from one counting sort of all.

#include "base/face_normals.h"

namespace plugc {
namespace {

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-20f && std::isfinite(length) ? v / length : otherwise;
}

glm::dvec3 newell_sum(std::span<const std::uint32_t> polygon, std::span<const glm::vec3> positions) {
  glm::dvec3 sum{0};
  if (polygon.empty()) return sum;
  const glm::dvec3 origin = positions[polygon[0]];
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += glm::cross(glm::dvec3(positions[polygon[i]]) - origin, glm::dvec3(positions[polygon[i + 1]]) - origin);
  return sum;
}

}  // namespace

std::vector<glm::vec3> polygon_normals(const PolygonList& polygons, std::span<const glm::vec3> positions) {
  std::vector<glm::vec3> result;
  result.reserve(polygons.ends.size());
  for (std::size_t index = 0; index < polygons.ends.size(); ++index) {
    const glm::dvec3 sum = newell_sum(polygons.polygon(index), positions);
    const double length = glm::length(sum);
    const glm::dvec3 normal = length > 0 && std::isfinite(length) ? sum / length : glm::dvec3(0, 0, 1);
    result.emplace_back(polygons.clockwise ? -normal : normal);
  }
  return result;
}

CornersAtPoints corners_at_points(const PolygonList& polygons, std::size_t point_count) {
  CornersAtPoints result;
  std::vector<std::uint32_t> next(point_count + 1, 0);
  for (const std::uint32_t point : polygons.corners) ++next[point + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  result.places.resize(polygons.corners.size());
  for (std::uint32_t face = 0; face < polygons.ends.size(); ++face) {
    const std::uint32_t begin = face == 0 ? 0 : polygons.ends[face - 1];
    for (std::uint32_t corner = begin; corner < polygons.ends[face]; ++corner)
      result.places[next[polygons.corners[corner]]++] = {corner, face};
  }
  next.pop_back();  // each start has moved to its end
  result.ends = std::move(next);
  return result;
}

glm::vec3 smooth_normal(std::uint32_t face, std::span<const CornerPlace> around, std::span<const glm::vec3> of_faces,
                        float least_cosine) {
  const glm::vec3& own = of_faces[face];
  if (around.size() > kMaxValence || least_cosine >= 1) return own;
  glm::vec3 sum{0};
  for (const CornerPlace& other : around) {
    const glm::vec3& candidate = of_faces[other.face];
    if (other.face == face || glm::dot(own, candidate) > least_cosine) sum += candidate;
  }
  return unit_or(sum, own);
}

}  // namespace plugc
