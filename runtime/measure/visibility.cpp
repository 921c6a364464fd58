#include "runtime/measure/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plugc {
namespace {

constexpr float kFaintest = 1e-5F;  // of a brightness of 1: below, 32-bit floats leave less than two digits of the share

/// The share by the channel in which the light shows most.
float share(const glm::vec4& shadowed, const glm::vec4& unshadowed, const glm::vec4& dark) {
  const glm::vec3 light = glm::vec3(unshadowed) - glm::vec3(dark);
  const int channel = light.x >= light.y && light.x >= light.z ? 0 : light.y >= light.z ? 1 : 2;
  if (!(light[channel] > kFaintest)) return std::numeric_limits<float>::quiet_NaN();
  return std::clamp((shadowed[channel] - dark[channel]) / light[channel], 0.0F, 1.0F);
}

}  // namespace

std::vector<float> measured_visibility(const Shot& shadowed, const Calibration& calibration) {
  std::vector<float> visibility(shadowed.colors.size());
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    visibility[i] = share(shadowed.colors[i], calibration.unshadowed.colors[i], calibration.dark.colors[i]);
  }
  return visibility;
}

void leave_out_unlit(TruthPicture& truth, const Calibration& calibration) {
  const std::vector<float> all_lit = measured_visibility(calibration.unshadowed, calibration);
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    TruthPixel& pixel = truth.pixels[i];
    if (!pixel.counted || !std::isnan(all_lit[i])) continue;
    pixel.counted = false;
    --truth.counted;
    if (!pixel.lit) --truth.shadowed;
  }
}

}  // namespace plugc
