#pragma once
// Where a surface lies in a shadow map, and how it moves there: texels per step on the surface.

#include "runtime/measure/truth.h"
#include "runtime/world.h"

namespace plugc {

/// A shadow map of `size` texels a side, as its light saw the scene.
struct MapProjection {
  glm::dmat4 world_to_texture{1.0};  ///< x and y from 0 to 1.
  double size = 1;
  bool cube = false;    ///< Of a point light: `world_to_texture` is that of the face that a point lies on.
  glm::dvec3 light{0};  ///< Of a cube: where it is.

  /// What the point is looked up by: one face of a cube, else the same.
  MapProjection at(const glm::dvec3& point) const;

  glm::dvec2 texel(const glm::dvec3& point) const;
};

/// Texels that a step of one pixel moves on the pixel's surface: first column to the right, second up.
glm::dmat2 texels_per_pixel(const MapProjection& map, const CameraRays& rays, const TruthPixel& pixel, double x, double y);

/// The point on the pixel's plane that lies that many texels away in the map.
glm::dvec3 moved_in_map(const MapProjection& map, const TruthPixel& pixel, const glm::dvec2& texels);

}  // namespace plugc
