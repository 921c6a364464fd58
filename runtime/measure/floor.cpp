// An edge of direction normal n and length dl is crossed by n.x dl rows and n.y dl columns of pixels. Each crossing that the
// mask shows stands for a piece of edge: a crossing between columns for |n.x| of its length, one between rows for |n.y|, which
// add up to dl. A texel centre lies J^-1 d away on screen, d within half a texel: along the normal that is |n . J^-1 d|.

#include "runtime/measure/floor.h"

#include <algorithm>
#include <cmath>

namespace plugc {
namespace {

constexpr int kReach = 3;                 // pixels around an edge from which its direction is estimated
constexpr double kSameSurface = 0.9;      // cosine between normals
constexpr double kLargestFootprint = 64;  // pixels: a texel that covers more is not resolved by the picture

/// The direction in which light grows, from the mask around a pixel; 0 where it has none.
glm::dvec2 edge_normal(const TruthPicture& truth, int x, int y) {
  glm::dvec2 gradient(0);
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const int px = x + dx;
      const int py = y + dy;
      if (px < 0 || py < 0 || px >= truth.width || py >= truth.height || !truth.at(px, py).counted) continue;
      const double weight = std::exp(-0.25 * (dx * dx + dy * dy));
      gradient += weight * (truth.at(px, py).lit ? 1.0 : -1.0) * glm::dvec2(dx, dy);
    }
  }
  const double length = glm::length(gradient);
  return length > 1e-9 ? gradient / length : glm::dvec2(0);
}

/// Whether the shadow's edge runs between two pixels of one surface. Between two surfaces the picture has an edge of its own.
bool is_shadow_edge(const TruthPixel& a, const TruthPixel& b) {
  if (!a.counted || !b.counted || a.lit == b.lit || glm::dot(a.normal, b.normal) < kSameSurface) return false;
  const glm::dvec3 step = b.point - a.point;
  return std::abs(glm::dot(a.normal, step)) <= 0.5 * glm::length(step);
}

/// The distance on screen along `normal` that a texel centre lies away, on the average.
double mean_distance(const TruthPicture& truth, const CameraRays& rays, const MapProjection& map, int x, int y,
                     const glm::dvec2& normal) {
  const glm::dmat2 texels = texels_per_pixel(map, rays, truth.at(x, y), x + 0.5, y + 0.5);
  if (!(std::abs(glm::determinant(texels)) > 1e-12)) return 0;
  const double distance = mean_distance_from_texel_centre(glm::transpose(glm::inverse(texels)) * normal);
  return std::min(distance, kLargestFootprint);
}

}  // namespace

double mean_distance_from_texel_centre(const glm::dvec2& m) {
  const double longer = std::max(std::abs(m.x), std::abs(m.y));
  const double shorter = std::min(std::abs(m.x), std::abs(m.y));
  return longer > 0 ? longer / 4 + shorter * shorter / (12 * longer) : 0;
}

double hard_map_floor(const TruthPicture& truth, const CameraRays& rays, const MapProjection& map) {
  double wrong = 0;
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const bool to_right = x + 1 < truth.width && is_shadow_edge(truth.at(x, y), truth.at(x + 1, y));
      const bool to_top = y + 1 < truth.height && is_shadow_edge(truth.at(x, y), truth.at(x, y + 1));
      if (!to_right && !to_top) continue;
      const glm::dvec2 normal = edge_normal(truth, x, y);
      const double length = (to_right ? std::abs(normal.x) : 0) + (to_top ? std::abs(normal.y) : 0);
      wrong += length * mean_distance(truth, rays, map, x, y, normal);
    }
  }
  return truth.counted == 0 ? 0 : wrong / truth.counted;
}

}  // namespace plugc
