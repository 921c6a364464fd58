#pragma once
// Texture coordinates for geometry that has none of its own: the picture is laid over the bounding box.

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace plugc {

struct Box3 {
  glm::vec3 low{0}, high{0};
};

/// The box around the points; zero when there are none.
Box3 box_of(std::span<const glm::vec3> points);

/// S runs along the longest side of the box from 0 to 1, T along the second longest at the same scale; of equal sides x comes
/// before y and y before z (X3D 4.1, 13.3.6 IndexedFaceSet).
std::vector<glm::vec4> box_texture(std::span<const glm::vec3> points);

/// S, T and R run from 0 to 1 along x, y and -z of the box (X3D 4.1, 33.2.4; R as in the reference engine: the first slice of
/// a volume is in front).
std::vector<glm::vec4> box_texture_3d(std::span<const glm::vec3> points);

}  // namespace plugc
