// The receiver of a pixel is not what a camera ray hits, but the triangle that OpenGL drew there: the pixel's ray is cut with
// that triangle's plane. So rasteriser and tracer cannot disagree about what is seen, and no depth is rounded.

#include "runtime/measure/truth.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "runtime/measure/instrument.h"

namespace plugc {
namespace {

constexpr double kGrazing = 0.01;  // normal . L at and below which a surface is as good as unlit

bool is_receiver(const PackedShape& shape, std::uint32_t map) {
  return std::find(shape.receives()->begin(), shape.receives()->end(), map) != shape.receives()->end();
}

/// A surface with its triangles in world space.
struct PlacedSurface {
  const Surface* surface = nullptr;
  std::vector<Plane> planes;
};

/// The pixel's ray cut with its triangle. Not counted where that has no area, or is seen from its edge.
TruthPixel find_receiver(const Plane& plane, const TriangleId& id, const CameraRays& rays, double x, double y) {
  TruthPixel pixel;
  pixel.triangle = id;
  pixel.point = rays.on_plane(x, y, plane);
  pixel.normal = glm::dot(plane.normal, rays.direction(x, y)) > 0 ? -plane.normal : plane.normal;
  pixel.counted = plane.normal != glm::dvec3(0) && std::isfinite(pixel.point.x + pixel.point.y + pixel.point.z);
  return pixel;
}

}  // namespace

TruthPicture find_receivers(const Shot& shot, const LoadedScene& scene, const std::vector<Surface>& surfaces, std::uint32_t map,
                            const View& camera) {
  TruthPicture picture{shot.width, shot.height, std::vector<TruthPixel>(shot.triangles.size()), 0, 0};
  const CameraRays rays(camera, shot.width, shot.height);
  const LightSource light = light_source(*scene.packed, *scene.packed->shadow_maps()->Get(map), scene.slots, scene.world);
  std::map<std::uint32_t, PlacedSurface> placed;
  for (const Surface& surface : surfaces) {
    const PackedShape& shape = scene.shape(surface.shape);
    const bool judged = !surface.may_move && !shape.blended() && is_receiver(shape, map);
    if (judged) placed[surface.shape] = {&surface, world_planes(surface)};
  }
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const glm::vec4& seen = shot.triangles[i];
    const auto found = placed.find(static_cast<std::uint32_t>(std::max(seen.x, 0.0F)));
    if (seen.w != kSeen || found == placed.end()) continue;
    const TriangleId id{found->first, static_cast<std::uint32_t>(seen.y)};
    if (id.triangle >= found->second.planes.size()) continue;  // a float rounds what is beyond 24 bits
    const double x = static_cast<double>(i % static_cast<std::size_t>(shot.width)) + 0.5;
    const double y = static_cast<double>(i / static_cast<std::size_t>(shot.width)) + 0.5;
    TruthPixel& pixel = picture.pixels[i] = find_receiver(found->second.planes[id.triangle], id, rays, x, y);
    pixel.facing = glm::dot(pixel.normal, towards_light(light, pixel.point));
    pixel.counted = pixel.counted && pixel.facing > kGrazing;
    if (!pixel.counted) continue;
    pixel.lit = true;
    ++picture.counted;
  }
  return picture;
}

void trace_truth(TruthPicture& picture, const Tracer& tracer, const LightSource& light) {
  picture.shadowed = 0;
  for (TruthPixel& pixel : picture.pixels) {
    if (!pixel.counted) continue;
    pixel.lit = !tracer.shadowed(pixel.point, pixel.triangle, light);
    picture.shadowed += pixel.lit ? 0 : 1;
  }
}

void take_for_truth(TruthPicture& picture, const std::vector<float>& visibility) {
  picture.shadowed = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    TruthPixel& pixel = picture.pixels[i];
    if (!pixel.counted) continue;
    pixel.lit = visibility[i] > 0.5F;
    picture.shadowed += pixel.lit ? 0 : 1;
  }
}

}  // namespace plugc
