// A perspective's planes are found in the two numbers of its matrix that make depth.

#include "runtime/sight_limit.h"

#include <algorithm>
#include <cmath>

namespace plugc {

double sight_limit(const PackedScene& scene, const Slots& slots) {
  const double limit = slots.number(scene.visibility_limit(), 0);
  return std::isfinite(limit) && limit > 0 ? limit : 0;
}

void limit_sight(View& view, double limit) {
  glm::dmat4& projection = view.projection;
  const bool is_perspective = projection[2][3] == -1.0;
  if (limit <= 0 || !is_perspective) return;
  constexpr double kNearestRatio = 1e-4;
  const double far = projection[3][2] / (projection[2][2] + 1);
  if (!(far > limit)) return;
  const double near = std::clamp(projection[3][2] / (projection[2][2] - 1), kNearestRatio * limit, limit / 2);
  projection[2][2] = -(limit + near) / (limit - near);
  projection[3][2] = -2 * limit * near / (limit - near);
}

}  // namespace plugc
