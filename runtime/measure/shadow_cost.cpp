// Processor time as the laboratory measures it on llvmpipe (tests/bench/shadows/run --clock processor). Look-ups: lookups.csv,
// whose map has 1024 texels, less their misses. Misses: how maps_kept of times.csv grows with the size, and texels: how
// maps_drawn less maps_kept does (scene foliage). Error factors: the wrong share over the floor at 1024 texels in the scenes
// layered and open, the mean; the other scenes had no say.

#include "runtime/measure/shadow_cost.h"

namespace plugc {
namespace {

struct MethodTraits {
  double error_factor;  // of the floor of a hard map
  double lookup;        // nanoseconds a pixel, from a map that stays in the cache
  double blur;          // nanoseconds a texel: moments along rows, then the blur along columns
};

constexpr double kTexel = 1.8;      // nanoseconds, cleared and drawn into
constexpr double kMisses = 0.0045;  // nanoseconds that a look-up takes longer for each texel of the map's side

constexpr MethodTraits traits_of(PackedShadowMethod method) {
  switch (method) {
    case PackedShadowMethod::hard: return {1.15, 1.5, 0};
    case PackedShadowMethod::bilinear: return {0.92, 2.3, 0};
    case PackedShadowMethod::pcf2: return {0.78, 10, 0};
    case PackedShadowMethod::pcf3: return {0.75, 10, 0};
    case PackedShadowMethod::pcf4: return {0.78, 21, 0};
    case PackedShadowMethod::pcf2_taps: return {0.78, 9.4, 0};
    case PackedShadowMethod::pcf3_taps: return {0.75, 21, 0};
    case PackedShadowMethod::pcf4_taps: return {0.78, 36, 0};
    case PackedShadowMethod::sharp3: return {0.75, 11.4, 0};
    case PackedShadowMethod::poisson: return {0.76, 42, 0};
    case PackedShadowMethod::traced: return {0, 90, 0};
    case PackedShadowMethod::vsm: return {1.5, 2, 22};
    case PackedShadowMethod::evsm: return {1.0, 3.5, 26};
    case PackedShadowMethod::msm: return {1.2, 4.7, 22};
  }
  return {1, 0, 0};
}

}  // namespace

double expected_error_factor(PackedShadowMethod method) {
  return traits_of(method).error_factor;
}

double shadow_cost(PackedShadowMethod method, std::uint32_t size, double receiver_pixels, int faces) {
  constexpr double kMilliseconds = 1e-6;
  const MethodTraits traits = traits_of(method);
  if (method == PackedShadowMethod::traced) return kMilliseconds * traits.lookup * receiver_pixels;
  const double texels = double(faces) * double(size) * double(size);
  return kMilliseconds * (receiver_pixels * (traits.lookup + kMisses * size) + texels * (kTexel + traits.blur));
}

}  // namespace plugc
