#pragma once
// The shadow of one light, judged from all viewpoints of its scene: how far each way of drawing it is from the truth.

#include <vector>

#include "runtime/measure/measured_scene.h"
#include "runtime/measure/shadow_search.h"

namespace plugc {

/// One frame a viewpoint (one of the whole scene where there is none), as large as `width` x `height`, or smaller in the same
/// shape where all of them together would have more than `most_pixels`: shares of pixels hardly depend on it.
std::vector<FrameOptions> viewpoint_frames(const PackedScene& scene, std::uint32_t width, std::uint32_t height,
                                           double most_pixels);

/// What the errors of map `map` are measured against. It holds for every method of the same scene.
struct LightJudge {
  std::uint32_t map = 0;
  std::vector<JudgedView> views;  ///< Those that show something which the map shadows.
  double floor_of_texel = 0;      ///< hard_map_floor() of a map, times its size; the mean of the views.
  double counted_share = 0;       ///< Of a picture: pixels that the map shadows; the mean of all frames.
  double shadowed_share = 0;      ///< Of those.
  double truth_error = 0;         ///< What the truth itself may have wrong: none, where it is traced.
};

/// `scene` must draw that map by the method `hard`, or by whatever its author wrote. Without a tracer its map, as large as
/// can be, is the truth.
LightJudge make_light_judge(Studio& studio, MeasuredScene& scene, const JudgedScene& judged,
                            const std::vector<FrameOptions>& frames, std::uint32_t map);

/// The share of wrong pixels, the mean of the views: as drawn, or the mean over positions of the map within a texel, whichever
/// is larger, so that it does not hang on where texels happen to lie. `scene` has the method of the configuration.
double measured_error(Studio& studio, MeasuredScene& scene, const LightJudge& judge, const ShadowConfiguration& configuration);
/// As drawn, in these frames: each is judged, drawn, and forgotten.
double drawn_error(Studio& studio, MeasuredScene& scene, MeasuredScene& truth_scene, const JudgedScene& judged,
                   const std::vector<FrameOptions>& frames, const LightJudge& light, const ShadowConfiguration& configuration);

}  // namespace plugc
