// How far a wrong pixel is from the true edge is found with rays, too: they leave the pixel's plane at points around it, one
// texel away in the map, then four. Where one of them says something else than the pixel's own ray, the edge is nearer than
// that.

#include "runtime/measure/compare.h"

#include <cmath>
#include <numbers>

namespace plugc {
namespace {

constexpr int kDirections = 8;

bool changes_within(const TruthPixel& pixel, double texels, const MapProjection& map, const Tracer& tracer,
                    const LightSource& light) {
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const glm::dvec3 point = moved_in_map(map, pixel, texels * glm::dvec2(std::cos(angle), std::sin(angle)));
    const bool usable = std::isfinite(point.x + point.y + point.z);
    if (usable && tracer.shadowed(point, pixel.triangle, light) == pixel.lit) return true;
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
