#pragma once
// What the shadow of one light is, pixel by pixel: by one ray a pixel, or by a map that is better than those to be judged.

#include <cstdint>
#include <vector>

#include "runtime/camera_rays.h"
#include "runtime/measure/studio.h"
#include "runtime/tracer.h"

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

/// Counts each pixel of `triangles` (Shot::triangles) that shows a surface which map `map` shadows, faces the light (normal . L
/// above 0.01) and is seen without a blended shape in front. All of them are lit.
TruthPicture find_receivers(const Shot& shot, const LoadedScene& scene, const std::vector<Surface>& surfaces, std::uint32_t map,
                            const View& camera);

/// Lit is what a ray says.
void trace_truth(TruthPicture& picture, const Tracer& tracer, const LightSource& light);
/// Lit is what gets more than half of the light. `visibility` as measured_visibility() gives it.
void take_for_truth(TruthPicture& picture, const std::vector<float>& visibility);

}  // namespace plugc
