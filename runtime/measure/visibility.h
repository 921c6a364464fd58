#pragma once
// How much of a light the runtime lets through, read from its own pictures.

#include <vector>

#include "runtime/measure/truth.h"

namespace plugc {

/// Pictures of one view with nothing but the measured light, dimmed: how bright a pixel is with the light unshadowed, and
/// without it.
struct Calibration {
  Shot unshadowed;
  Shot dark;
};

/// The light's share at each pixel, 0 to 1, from a picture with shadows; NaN where the light does not show (outside of a spot's
/// cone, on a black or unlit material).
/// (with shadow - without light) / (without shadow - without light): exact for whatever the light is multiplied with.
std::vector<float> measured_visibility(const Shot& shadowed, const Calibration& calibration);

/// Pixels where the light does not show are no longer counted.
void leave_out_unlit(TruthPicture& truth, const Calibration& calibration);

}  // namespace plugc
