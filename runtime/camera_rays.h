#pragma once
// Rays through the pixels of a picture, in double: what a pixel shows of a triangle that was drawn there.

#include "runtime/world.h"

namespace plugc {

/// All of it in world space.
struct Plane {
  glm::dvec3 point{0};
  glm::dvec3 normal{0};  ///< Unit; zero for a triangle without area.
};

class CameraRays {
 public:
  CameraRays(const View& camera, int width, int height);

  /// Where the ray through (x, y) meets the plane; not finite where it is parallel. Pixel centres are at halves, y counts from
  /// the bottom.
  glm::dvec3 on_plane(double x, double y, const Plane& plane) const;
  /// The way that the ray goes; not of unit length.
  glm::dvec3 direction(double x, double y) const { return along_ + x * along_x_ + y * along_y_; }

 private:
  glm::dvec3 begin_{0}, begin_x_{0}, begin_y_{0};  ///< On the near plane: at (0, 0), and how it changes along a pixel.
  glm::dvec3 along_{0}, along_x_{0}, along_y_{0};  ///< From there to the far plane.
};

}  // namespace plugc
