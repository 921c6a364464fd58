#pragma once
// A measured shadow against the true one.

#include "runtime/measure/map_footprint.h"
#include "runtime/tracer.h"

namespace plugc {

/// Shares of the counted pixels.
struct ShadowErrors {
  double false_shadow = 0;   ///< Lit, but the picture has it more than half dark: acne.
  double false_lit = 0;      ///< The other way round: a detached shadow, a leak.
  double mean_absolute = 0;  ///< Of the measured share of light against 0 or 1: a soft edge counts, too.
  double weighted = 0;       ///< Wrong pixels by how much light they lose or gain: each counts as its normal . L.
  double at_edge = 0;        ///< Of the wrong pixels: within a texel of the true edge,
  double near_edge = 0;      ///< 1 to 4 texels,
  double far_from_edge = 0;  ///< farther: acne or a leak, whatever the map's size.

  double wrong() const { return false_shadow + false_lit; }
};

/// All but the distances from the edge. `visibility` as measured_visibility() gives it.
ShadowErrors count_errors(const TruthPicture& truth, const std::vector<float>& visibility);
/// All of it: the distances are found with rays.
ShadowErrors compare(const TruthPicture& truth, const std::vector<float>& visibility, const MapProjection& map,
                     const Tracer& tracer, const LightSource& light);

/// The errors of a picture without shadows: all that is shadowed is false light, wherever its edge is.
ShadowErrors errors_without_shadow(const TruthPicture& truth);

/// The mean share of light that is let through where the true shadow is farther than 4 texels from its edge.
double mean_leak(const TruthPicture& truth, const std::vector<float>& visibility, const MapProjection& map,
                 const Tracer& tracer, const LightSource& light);

}  // namespace plugc
