// The axes of the box are sorted by length, stably, so that ties keep the order x, y, z; the first gives S, the second T, and
// both are divided by the first's length.

#include "base/box_texture.h"

#include <algorithm>
#include <array>

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

std::vector<glm::vec4> box_texture(std::span<const glm::vec3> points) {
  const Box3 box = box_of(points);
  const glm::vec3 size = box.high - box.low;
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&size](int a, int b) { return size[a] > size[b]; });
  const float longest = size[axes[0]];
  std::vector<glm::vec4> result;
  result.reserve(points.size());
  for (const glm::vec3& point : points) {
    const glm::vec3 place = longest > 0 ? (point - box.low) / longest : glm::vec3(0);
    result.push_back({place[axes[0]], place[axes[1]], 0, 1});
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
