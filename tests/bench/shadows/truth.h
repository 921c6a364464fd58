#pragma once
// What the shadow of one light is, pixel by pixel, by one ray a pixel.

#include <cstdint>
#include <vector>

#include "runtime/camera_rays.h"
#include "runtime/tracer.h"
#include "shadows/studio.h"

namespace plugc {

/// One pixel: what it shows, and whether the light's shadow is judged there.
struct TruthPixel {
  bool counted = false;
  bool lit = false;
  TriangleId triangle;
  glm::dvec3 point{0};   ///< World space.
  glm::dvec3 normal{0};  ///< Unit, towards the viewer.
  double facing = 0;     ///< normal . L, with L the direction to the light.
};

struct TruthPicture {
  int width = 0;
  int height = 0;
  std::vector<TruthPixel> pixels;
  std::uint32_t counted = 0;
  std::uint32_t shadowed = 0;  ///< Of those counted.

  const TruthPixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

/// Judges each pixel of `triangles` (Shot::triangles) that shows a surface which map `map` shadows, faces the light (normal . L
/// above 0.01) and is seen without a blended shape in front.
TruthPicture trace_picture(const Shot& shot, const LoadedScene& scene, const std::vector<Surface>& surfaces,
                           const Tracer& tracer, std::uint32_t map, const View& camera);

}  // namespace plugc
