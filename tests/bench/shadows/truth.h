#pragma once
// What the shadow of one light is, pixel by pixel, by one ray a pixel.

#include <cstdint>
#include <vector>

#include "shadows/studio.h"
#include "runtime/tracer.h"

namespace plugc {

/// Rays through a picture's pixels, in double. Pixel centres are at halves; y counts from the bottom.
class CameraRays {
 public:
  CameraRays(const View& camera, int width, int height);
  /// Where the ray through (x, y) meets a plane. World space; not finite where it is parallel.
  glm::dvec3 on_plane(double x, double y, const glm::dvec3& point, const glm::dvec3& normal) const;

 private:
  glm::dmat4 picture_to_eye_;
  glm::dmat4 eye_to_world_;
};

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

/// The light in world space.
LightSource light_source(const PackedScene& scene, std::uint32_t light, const Slots& slots, const World& world);

/// Judges each pixel of `triangles` (Shot::triangles) that shows a surface which map `map` shadows, faces the light (normal . L
/// above 0.01) and is seen without a blended shape in front.
TruthPicture trace_picture(const Shot& shot, const LoadedScene& scene, const std::vector<Surface>& surfaces,
                           const Tracer& tracer, std::uint32_t map, const View& camera);

}  // namespace plugc
