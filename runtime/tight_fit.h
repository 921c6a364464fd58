#pragma once
// What a map must hold that nobody but the renderer sees: of what receives, as much as is in view; of that, as much as
// something casts on. All texels go there. The view changes in steps, so that a camera that moves a little needs no new map,
// and by whole texels, so that shadows keep their edges when it does.

#include "runtime/projection.h"

namespace plugc {

/// Of a fit: what the next one may go on with.
struct FitMemory {
  LightFrame light;
  glm::dvec4 window{0};  ///< Left, bottom, right, top in the light's own space: lengths, or tangents from a spot light.
  Interval depth;        ///< Along the light's direction.
  double coarseness = 1;
  bool any = false;  ///< False: nothing was fitted yet.
};

struct TightFit {
  View view;
  bool needed = false;  ///< False: nothing that receives is in view, or nothing casts on it. Then there is no view either.
  /// Steps of depth that positions far from the eye, floats too, are uncertain by; 1 or more. A constant offset in fewer steps
  /// would leave surfaces across the light spotted.
  double coarseness = 1;
};

/// Fits a map of reversed depths (fit_light says how they run). A written rectangle or angle is kept as it is; written
/// distances are not used, as every receiver has its place and casters before them are clamped. The result holds the whole of
/// `memory` while that still serves; else it becomes the new one.
TightFit fit_tightly(const LightFrame& light, const FitInput& input, FitMemory& memory);

}  // namespace plugc
