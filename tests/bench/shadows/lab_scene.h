#pragma once
// A scene on the bench: compiled, made measurable, loaded, and judged from a viewpoint.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "shadows/compare.h"
#include "shadows/instrument.h"
#include "shadows/studio.h"
#include "shadows/visibility.h"

namespace plugc {

/// A package for the renderer, on its GPU. What a scene points into lives as long as it.
struct LabScene {
  MeasurablePackage package;
  LoadedScene loaded;
};
std::unique_ptr<LabScene> load_lab_scene(Studio& studio, const std::vector<std::uint8_t>& bytes, const Settings& settings);

/// One map's shadow from one viewpoint: the truth, and what turns pictures into visibility. It holds for every method, size and
/// bias of the same scene.
struct JudgedView {
  FrameOptions frame;
  std::uint32_t map = 0;
  LightSource light;
  TruthPicture truth;
  Calibration calibration;
};

/// What is true of a scene whatever its maps are.
struct JudgedScene {
  std::vector<Surface> surfaces;
  std::unique_ptr<Tracer> tracer;
  std::vector<JudgedView> views;
};

/// Throws std::runtime_error where Embree cannot be loaded. `views` are the frames to judge; each with every map of the scene
/// that can be drawn. Lights of other maps are off.
JudgedScene judge_scene(Studio& studio, LabScene& scene, const std::vector<FrameOptions>& views);

/// Leaves only the light of that map on, dimmed for measurement (`share` 1) or dark (0).
void light_only(LabScene& scene, std::uint32_t map, double share);

/// The map's projection as the last picture was drawn.
MapProjection projection_of(const LabScene& scene, std::uint32_t map);

/// The picture's share of the map's light, the map moved by a part of a texel. Draws all of it anew.
std::vector<float> measure_visibility(Studio& studio, LabScene& scene, const JudgedView& view, const glm::dvec2& shift);

/// Means over sub-texel positions of the map. `floor` as hard_map_floor().
struct MeanErrors {
  ShadowErrors errors;
  double floor = 0;
};
MeanErrors measure_errors(Studio& studio, LabScene& scene, const JudgedScene& judged, const JudgedView& view, int shift_count);

/// mean_leak() of one picture.
double measure_leak(Studio& studio, LabScene& scene, const JudgedScene& judged, const JudgedView& view);

/// `count` positions within a texel, evenly spread: 1, 4 or 16.
std::vector<glm::dvec2> sub_texel_shifts(int count);

}  // namespace plugc
