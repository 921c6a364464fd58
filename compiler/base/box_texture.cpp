// The longest axis of the box gives S, the next one T, and both are divided by the first's length. Of axes that are as long the
// first counts; a hundredth less is as long, since the corners of a round mesh need not reach its sides.

#include "base/box_texture.h"

#include <algorithm>

namespace plugc {

Box3 box_of(std::span<const glm::vec3> points) {
  if (points.empty()) return {};
  Box3 box{points[0], points[0]};
  for (const glm::vec3& point : points) {
    box.low = glm::min(box.low, point);
    box.high = glm::max(box.high, point);
  }
  return box;
}

namespace {

/// Of the axes other than `taken` (-1: all).
int longest_axis(const glm::vec3& size, int taken) {
  constexpr float kAsLong = 0.99f;
  float longest = 0;
  for (int axis = 0; axis < 3; ++axis) longest = axis == taken ? longest : std::max(longest, size[axis]);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != taken && size[axis] >= kAsLong * longest) return axis;
  }
  return taken;  // a size that is no number
}

}  // namespace

std::vector<glm::vec4> box_texture(std::span<const glm::vec3> points) {
  const Box3 box = box_of(points);
  const glm::vec3 size = box.high - box.low;
  const int s = longest_axis(size, -1), t = longest_axis(size, s);
  const float longest = size[s];
  std::vector<glm::vec4> result;
  result.reserve(points.size());
  for (const glm::vec3& point : points) {
    const glm::vec3 place = longest > 0 ? (point - box.low) / longest : glm::vec3(0);
    result.push_back({place[s], place[t], 0, 1});
  }
  return result;
}

std::vector<glm::vec4> box_texture_3d(std::span<const glm::vec3> points) {
  const Box3 box = box_of(points);
  const glm::vec3 size = box.high - box.low;
  std::vector<glm::vec4> result;
  result.reserve(points.size());
  for (const glm::vec3& point : points) {
    glm::vec4 coord{0, 0, 0, 1};
    for (int axis = 0; axis < 3; ++axis) {
      if (size[axis] > 0) coord[axis] = (axis == 2 ? box.high[axis] - point[axis] : point[axis] - box.low[axis]) / size[axis];
    }
    result.push_back(coord);
  }
  return result;
}

}  // namespace plugc
