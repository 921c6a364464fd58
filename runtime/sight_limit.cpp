// A perspective's far plane is found in the two numbers of its matrix that make depth. The near plane then cuts, too, so it
// comes as near as the numbers of a depth buffer allow, wherever the boxes of what is seen begin.

#include "runtime/sight_limit.h"

#include <cmath>

namespace plugc {

double sight_limit(const PackedScene& scene, const Slots& slots) {
  const double limit = slots.number(scene.visibility_limit(), 0);
  return std::isfinite(limit) && limit > 0 ? limit : 0;
}

bool limit_sight(View& view, double limit) {
  glm::dmat4& projection = view.projection;
  const bool is_perspective = projection[2][3] == -1.0;
  if (limit <= 0 || !is_perspective) return false;
  const double far = projection[3][2] / (projection[2][2] + 1);
  if (!(far > limit)) return false;
  constexpr double kNearestRatio = 1e-4;
  const double near = kNearestRatio * limit;
  projection[2][2] = -(limit + near) / (limit - near);
  projection[3][2] = -2 * limit * near / (limit - near);
  return true;
}

}  // namespace plugc
