#pragma once
// Normals that come of the polygons around a point. The compiler makes them when a geometry has none, the renderer makes them
// anew when its points move.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace plugc {

/// Polygons by the points at their corners: polygon i has the corners from ends[i - 1] up to ends[i].
struct PolygonList {
  std::span<const std::uint32_t> corners, ends;
  bool clockwise = false;  ///< How corners run, seen from the front.

  std::span<const std::uint32_t> polygon(std::size_t index) const {
    const std::size_t begin = index == 0 ? 0 : ends[index - 1];
    return corners.subspan(begin, ends[index] - begin);
  }
};

/// Toward the front of each polygon, by Newell's sum, unit length; (0, 0, 1) for one without an area. Every corner names one of
/// `positions`.
std::vector<glm::vec3> polygon_normals(const PolygonList& polygons, std::span<const glm::vec3> positions);

struct CornerPlace {
  std::uint32_t corner;  ///< Place in PolygonList::corners.
  std::uint32_t face;
};

/// The corners at each point.
struct CornersAtPoints {
  std::vector<CornerPlace> places;
  std::vector<std::uint32_t> ends;  ///< Those of point i are places [ends[i - 1], ends[i]).

  std::span<const CornerPlace> at(std::size_t point) const {
    const std::uint32_t begin = point == 0 ? 0 : ends[point - 1];
    return {places.data() + begin, ends[point] - begin};
  }
};

/// Every corner is less than `point_count`.
CornersAtPoints corners_at_points(const PolygonList& polygons, std::size_t point_count);

/// A point with more corners, which only a hostile file or a huge fan has, keeps flat ones: the work is the sum of squares.
inline constexpr std::size_t kMaxValence = 512;

/// With these for `least_cosine`, all faces around a point are summed, or none but a corner's own.
inline constexpr float kSmoothAll = -2, kFlat = 2;

/// The normal of the corner that `face` has at a point: the sum over the faces there that meet it at an angle with a cosine of
/// more than `least_cosine`, unit length.
glm::vec3 smooth_normal(std::uint32_t face, std::span<const CornerPlace> around, std::span<const glm::vec3> of_faces,
                        float least_cosine);

}  // namespace plugc
