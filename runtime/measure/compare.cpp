// How far a wrong pixel is from the true edge is found with rays, too: they leave the pixel's plane at points around it, one
// texel away in the map, then up to four. Where one of them says something else than the pixel's own ray, the edge is nearer
// than that.
//
// A plane ends. Where the surface bends towards the light, what lies a texel away is in front of the pixel's plane, whose
// points are in the dark below it. So shadow counts as whole only where points beside the pixel as deep as itself are dark as
// well: a map compares with that depth, too. By the planes alone, a map of nearest texels would let light into whole shadow of
// bent surfaces.

#include "runtime/measure/compare.h"

#include <cmath>
#include <numbers>

namespace plugc {
namespace {

constexpr int kDirections = 8;  // turned by half of a step between one distance and the next

constexpr TriangleId kNoTriangle{~0U, ~0U};

bool says(const Tracer& tracer, const glm::dvec3& point, const TriangleId& from, const LightSource& light, bool lit) {
  return std::isfinite(point.x + point.y + point.z) && tracer.shadowed(point, from, light) != lit;
}

/// The point that lies that many texels away in the map, and as deep as the pixel's.
glm::dvec3 moved_across(const MapProjection& map, const TruthPixel& pixel, const glm::dvec2& texels, const LightSource& light) {
  TruthPixel facing = pixel;
  facing.normal = towards_light(light, pixel.point);
  return moved_in_map(map, facing, texels);
}

bool changes_within(const TruthPixel& pixel, double texels, const MapProjection& map, const Tracer& tracer,
                    const LightSource& light) {
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * (i + texels / 2) / kDirections;
    const glm::dvec2 way = texels * glm::dvec2(std::cos(angle), std::sin(angle));
    if (says(tracer, moved_in_map(map, pixel, way), pixel.triangle, light, !pixel.lit)) return true;
    if (!pixel.lit && says(tracer, moved_across(map, pixel, way, light), kNoTriangle, light, true)) return true;
  }
  return false;
}

bool is_lit(float share) {
  return share > 0.5F;
}

enum class EdgeDistance { one_texel, four_texels, far };

EdgeDistance distance_from_edge(const TruthPixel& pixel, const MapProjection& map, const Tracer& tracer,
                                const LightSource& light) {
  if (changes_within(pixel, 1, map, tracer, light)) return EdgeDistance::one_texel;
  for (const double texels : {2.0, 3.0, 4.0}) {
    if (changes_within(pixel, texels, map, tracer, light)) return EdgeDistance::four_texels;
  }
  return EdgeDistance::far;
}

}  // namespace

ShadowErrors count_errors(const TruthPicture& truth, const std::vector<float>& visibility) {
  ShadowErrors sum;
  double facing = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const TruthPixel& pixel = truth.pixels[i];
    if (!pixel.counted) continue;
    const auto share = static_cast<double>(visibility[i]);
    facing += pixel.facing;
    sum.mean_absolute += std::abs(share - (pixel.lit ? 1 : 0));
    if (is_lit(visibility[i]) == pixel.lit) continue;
    (pixel.lit ? sum.false_shadow : sum.false_lit) += 1;
    sum.weighted += pixel.facing;
  }
  const double count = truth.counted > 0 ? truth.counted : 1;
  ShadowErrors errors;
  errors.false_shadow = sum.false_shadow / count;
  errors.false_lit = sum.false_lit / count;
  errors.mean_absolute = sum.mean_absolute / count;
  errors.weighted = facing > 0 ? sum.weighted / facing : 0;
  return errors;
}

ShadowErrors compare(const TruthPicture& truth, const std::vector<float>& visibility, const MapProjection& map,
                     const Tracer& tracer, const LightSource& light) {
  ShadowErrors errors = count_errors(truth, visibility);
  const double share = truth.counted > 0 ? 1.0 / truth.counted : 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const TruthPixel& pixel = truth.pixels[i];
    if (!pixel.counted || is_lit(visibility[i]) == pixel.lit) continue;
    switch (distance_from_edge(pixel, map, tracer, light)) {
      case EdgeDistance::one_texel: errors.at_edge += share; break;
      case EdgeDistance::four_texels: errors.near_edge += share; break;
      case EdgeDistance::far: errors.far_from_edge += share; break;
    }
  }
  return errors;
}

ShadowErrors errors_without_shadow(const TruthPicture& truth) {
  ShadowErrors errors;
  double facing = 0;
  for (const TruthPixel& pixel : truth.pixels) {
    if (!pixel.counted) continue;
    facing += pixel.facing;
    if (!pixel.lit) errors.weighted += pixel.facing;
  }
  if (truth.counted == 0) return errors;
  errors.false_lit = errors.mean_absolute = static_cast<double>(truth.shadowed) / truth.counted;
  errors.weighted /= facing;
  return errors;
}

double mean_leak(const TruthPicture& truth, const std::vector<float>& visibility, const MapProjection& map,
                 const Tracer& tracer, const LightSource& light) {
  double sum = 0;
  std::size_t deep = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const TruthPixel& pixel = truth.pixels[i];
    if (!pixel.counted || pixel.lit || distance_from_edge(pixel, map, tracer, light) != EdgeDistance::far) continue;
    sum += static_cast<double>(visibility[i]);
    ++deep;
  }
  return deep > 0 ? sum / static_cast<double>(deep) : 0;
}

}  // namespace plugc
