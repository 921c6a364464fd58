// Truth and calibration are made once a view; each trial is a picture or five of each view.

#include "runtime/measure/light_judge.h"

#include <algorithm>
#include <cmath>

namespace plugc {
namespace {

constexpr std::uint32_t kLearningSize = 1024;  // of the map whose footprint is looked at
constexpr int kShifts = 4;
constexpr std::uint32_t kMostShiftedSize = 2048;  // where texels of larger maps happen to lie hardly matters

void configure(Studio& studio, MeasuredScene& scene, std::uint32_t map, const ShadowConfiguration& configuration) {
  scene.loaded.slots.set(scene.package.scales[map], {&configuration.scale, 1});
  if (configuration.method != PackedShadowMethod::traced) studio.resize_map(scene.loaded, map, configuration.size);
}

/// The view's truth: traced, or of a map that is made as large as can be for it.
JudgedView judge(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const FrameOptions& frame,
                 std::uint32_t map) {
  if (judged.tracer == nullptr) studio.resize_map(scene.loaded, map, largest_map_size(*scene.loaded.packed, map));
  return judge_view(studio, scene, judged, frame, map);
}

double wrong(Studio& studio, MeasuredScene& scene, const JudgedView& view, const glm::dvec2& shift) {
  return count_errors(view.truth, measure_visibility(studio, scene, view, shift)).wrong();
}

/// Its map is drawn once for that.
double floor_of_texel(Studio& studio, MeasuredScene& scene, const JudgedView& view) {
  if (scene.loaded.packed->shadow_maps()->Get(view.map)->method() == PackedShadowMethod::traced) return 0;
  studio.resize_map(scene.loaded, view.map, kLearningSize);
  measure_visibility(studio, scene, view, glm::dvec2(0));
  return kLearningSize * floor_of(scene, view);
}

}  // namespace

std::vector<FrameOptions> viewpoint_frames(const PackedScene& scene, std::uint32_t width, std::uint32_t height,
                                           double most_pixels) {
  const std::uint32_t count = std::max(scene.viewpoints()->size(), 1U);
  const double factor = std::min(1.0, std::sqrt(most_pixels / (double(count) * width * height)));
  const auto scaled = [factor](std::uint32_t side) {
    return std::max(1U, static_cast<std::uint32_t>(std::lround(factor * side)));
  };
  std::vector<FrameOptions> frames;
  for (std::uint32_t i = 0; i < count; ++i) {
    FrameOptions frame;
    frame.width = scaled(width);
    frame.height = scaled(height);
    if (scene.viewpoints()->size() > 0) frame.viewpoint = std::to_string(i);
    frames.push_back(frame);
  }
  return frames;
}

LightJudge make_light_judge(Studio& studio, MeasuredScene& scene, const JudgedScene& judged,
                            const std::vector<FrameOptions>& frames, std::uint32_t map) {
  LightJudge made;
  made.map = map;
  double counted = 0;
  double shadowed = 0;
  for (const FrameOptions& frame : frames) {
    JudgedView view = judge(studio, scene, judged, frame, map);
    if (view.truth.counted == 0) continue;
    counted += view.truth.counted;
    shadowed += view.truth.shadowed;
    made.floor_of_texel += floor_of_texel(studio, scene, view);
    made.views.push_back(std::move(view));
  }
  if (made.views.empty()) return made;
  made.floor_of_texel /= double(made.views.size());
  made.counted_share = counted / (double(frames.size()) * frames.front().width * frames.front().height);
  made.shadowed_share = shadowed / counted;
  if (judged.tracer == nullptr) made.truth_error = made.floor_of_texel / largest_map_size(*scene.loaded.packed, map);
  return made;
}

double measured_error(Studio& studio, MeasuredScene& scene, const LightJudge& judge, const ShadowConfiguration& configuration) {
  configure(studio, scene, judge.map, configuration);
  double drawn = 0;
  double moved = 0;
  for (const JudgedView& view : judge.views) {
    drawn += wrong(studio, scene, view, glm::dvec2(0));
    if (configuration.method == PackedShadowMethod::traced || configuration.size > kMostShiftedSize) continue;
    for (const glm::dvec2& shift : sub_texel_shifts(kShifts)) moved += wrong(studio, scene, view, shift) / kShifts;
  }
  return std::max(drawn, moved) / double(judge.views.size()) + judge.truth_error;
}

double drawn_error(Studio& studio, MeasuredScene& scene, MeasuredScene& truth_scene, const JudgedScene& judged,
                   const std::vector<FrameOptions>& frames, const LightJudge& light, const ShadowConfiguration& configuration) {
  double sum = 0;
  int views = 0;
  for (const FrameOptions& frame : frames) {
    const JudgedView view = judge(studio, truth_scene, judged, frame, light.map);
    if (view.truth.counted == 0) continue;
    configure(studio, scene, light.map, configuration);
    sum += wrong(studio, scene, view, glm::dvec2(0));
    ++views;
  }
  return views > 0 ? sum / views + light.truth_error : 0;
}

}  // namespace plugc
