#pragma once
// A scene on the bench: compiled, made measurable, loaded, and judged from a viewpoint.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/measure/compare.h"
#include "runtime/measure/instrument.h"
#include "runtime/measure/studio.h"
#include "runtime/measure/visibility.h"

namespace plugc {

/// A package for the renderer, on its GPU. What a scene points into lives as long as it.
struct MeasuredScene {
  MeasurablePackage package;
  LoadedScene loaded;
};
std::unique_ptr<MeasuredScene> load_measured_scene(Studio& studio, const std::vector<std::uint8_t>& bytes,
                                                   const Settings& settings);

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
  std::unique_ptr<Tracer> tracer;  ///< Null, with a reason, where nothing can be traced.
  std::string why_not_traced;
  std::vector<JudgedView> views;
};

/// The scene without any view. Its alpha tests point into the package of `scene`.
JudgedScene read_judged_scene(MeasuredScene& scene);
/// What map `map` shadows in a frame. Without a tracer the scene's own map, as it is now, stands for the truth.
JudgedView judge_view(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const FrameOptions& frame,
                      std::uint32_t map);

/// Throws std::runtime_error where Embree cannot be loaded. `views` are the frames to judge; each with every map of the scene
/// that can be drawn. Lights of other maps are off.
JudgedScene judge_scene(Studio& studio, MeasuredScene& scene, const std::vector<FrameOptions>& views);

/// Leaves only the light of that map on, dimmed for measurement (`share` 1) or dark (0).
void light_only(MeasuredScene& scene, std::uint32_t map, double share);

/// Whether a picture may show that map's shadow.
bool has_shadow(const MeasuredScene& scene, std::uint32_t map);

/// The map's projection as the last picture was drawn.
MapProjection projection_of(const MeasuredScene& scene, std::uint32_t map);

/// The picture's share of the map's light, the map moved by a part of a texel. Draws all of it anew.
std::vector<float> measure_visibility(Studio& studio, MeasuredScene& scene, const JudgedView& view, const glm::dvec2& shift);

/// hard_map_floor() of the view, for the map's projection as the last picture was drawn.
double floor_of(const MeasuredScene& scene, const JudgedView& view);

/// Means over sub-texel positions of the map. `floor` as hard_map_floor().
struct MeanErrors {
  ShadowErrors errors;
  double floor = 0;
};
MeanErrors measure_errors(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const JudgedView& view,
                          int shift_count);

/// mean_leak() of one picture.
double measure_leak(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const JudgedView& view);

/// `count` positions within a texel, evenly spread: 1, 4 or 16.
std::vector<glm::dvec2> sub_texel_shifts(int count);

}  // namespace plugc
