// The truth is traced once a view; the pictures are what is drawn again and again.

#include "runtime/measure/measured_scene.h"

#include <cmath>
#include <stdexcept>

#include "runtime/measure/floor.h"

namespace plugc {
namespace {

View camera_of(const LoadedScene& scene, const FrameOptions& frame) {
  Messages messages;
  return make_camera(*scene.packed, scene.slots, scene.world, frame.viewpoint, static_cast<double>(frame.width) / frame.height,
                     messages);
}

void add(ShadowErrors& sum, const ShadowErrors& one, double weight) {
  sum.false_shadow += weight * one.false_shadow;
  sum.false_lit += weight * one.false_lit;
  sum.mean_absolute += weight * one.mean_absolute;
  sum.weighted += weight * one.weighted;
  sum.at_edge += weight * one.at_edge;
  sum.near_edge += weight * one.near_edge;
  sum.far_from_edge += weight * one.far_from_edge;
}

}  // namespace

std::unique_ptr<MeasuredScene> load_measured_scene(Studio& studio, const std::vector<std::uint8_t>& bytes,
                                                   const Settings& settings) {
  auto scene = std::make_unique<MeasuredScene>();
  scene->package = make_measurable(bytes, settings);
  scene->loaded = studio.load(*scene->package.package);
  return scene;
}

JudgedScene read_judged_scene(MeasuredScene& scene) {
  JudgedScene judged;
  LoadedScene& loaded = scene.loaded;
  update_live_meshes(loaded.live_meshes, loaded.slots);
  loaded.world = place(*loaded.package, *loaded.packed, loaded.slots, nullptr, -1, &loaded.live_meshes);
  judged.surfaces = read_surfaces(*loaded.package, *loaded.packed, loaded.slots, loaded.world, loaded.live_meshes);
  judged.tracer = Tracer::make(judged.surfaces, judged.why_not_traced);
  return judged;
}

bool has_shadow(const MeasuredScene& scene, std::uint32_t map) {
  return scene.loaded.packed->shadow_maps()->Get(map)->update() != PackedShadowUpdate::none;
}

JudgedView judge_view(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const FrameOptions& frame,
                      std::uint32_t map) {
  JudgedView view;
  view.frame = frame;
  view.map = map;
  FrameOptions without = frame;
  without.shadows = false;
  light_only(scene, map, 1);
  view.calibration.unshadowed = studio.shoot(scene.loaded, without);
  light_only(scene, map, 0);
  view.calibration.dark = studio.shoot(scene.loaded, without);
  const LoadedScene& loaded = scene.loaded;
  view.light = light_source(*loaded.packed, *loaded.packed->shadow_maps()->Get(map), loaded.slots, loaded.world);
  view.truth = find_receivers(view.calibration.unshadowed, loaded, judged.surfaces, map, camera_of(loaded, frame));
  leave_out_unlit(view.truth, view.calibration);
  if (judged.tracer != nullptr)
    trace_truth(view.truth, *judged.tracer, view.light);
  else
    take_for_truth(view.truth, measure_visibility(studio, scene, view, glm::dvec2(0)));
  return view;
}

JudgedScene judge_scene(Studio& studio, MeasuredScene& scene, const std::vector<FrameOptions>& views) {
  JudgedScene judged = read_judged_scene(scene);
  if (judged.tracer == nullptr) throw std::runtime_error(judged.why_not_traced);
  for (const FrameOptions& frame : views) {
    for (std::uint32_t map = 0; map < scene.loaded.shadow_maps.size(); ++map) {
      if (has_shadow(scene, map)) judged.views.push_back(judge_view(studio, scene, judged, frame, map));
    }
  }
  return judged;
}

void light_only(MeasuredScene& scene, std::uint32_t map, double share) {
  const std::uint32_t measured = scene.loaded.packed->shadow_maps()->Get(map)->light();
  for (std::uint32_t i = 0; i < scene.package.lights.size(); ++i) {
    const LightSlots& slots = scene.package.lights[i];
    const double on = i == measured ? 1 : 0;
    const double intensity = i == measured ? share * kMeasuringIntensity : 0;
    scene.loaded.slots.set(slots.on, {&on, 1});
    scene.loaded.slots.set(slots.intensity, {&intensity, 1});
  }
}

MapProjection projection_of(const MeasuredScene& scene, std::uint32_t map) {
  const ShadowMap& drawn = scene.loaded.shadow_maps[map];
  const glm::dvec3 place(drawn.view.eye_to_world[3]);
  return {world_to_texture(drawn.view), static_cast<double>(drawn.size), drawn.view.all_around, place};
}

std::vector<float> measure_visibility(Studio& studio, MeasuredScene& scene, const JudgedView& view, const glm::dvec2& shift) {
  light_only(scene, view.map, 1);
  scene.loaded.shadow_maps[view.map].shift = shift;
  forget_maps(scene.loaded);
  return measured_visibility(studio.shoot(scene.loaded, view.frame), view.calibration);
}

double measure_leak(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const JudgedView& view) {
  const std::vector<float> visibility = measure_visibility(studio, scene, view, glm::dvec2(0));
  return mean_leak(view.truth, visibility, projection_of(scene, view.map), *judged.tracer, view.light);
}

MeanErrors measure_errors(Studio& studio, MeasuredScene& scene, const JudgedScene& judged, const JudgedView& view,
                          int shift_count) {
  MeanErrors mean;
  const std::vector<glm::dvec2> shifts = sub_texel_shifts(shift_count);
  const double weight = 1.0 / static_cast<double>(shifts.size());
  for (const glm::dvec2& shift : shifts) {
    const std::vector<float> visibility = measure_visibility(studio, scene, view, shift);
    add(mean.errors, compare(view.truth, visibility, projection_of(scene, view.map), *judged.tracer, view.light), weight);
  }
  mean.floor = floor_of(scene, view);
  return mean;
}

double floor_of(const MeasuredScene& scene, const JudgedView& view) {
  const CameraRays rays(camera_of(scene.loaded, view.frame), view.truth.width, view.truth.height);
  return hard_map_floor(view.truth, rays, projection_of(scene, view.map));
}

std::vector<glm::dvec2> sub_texel_shifts(int count) {
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(count))));
  std::vector<glm::dvec2> shifts;
  shifts.reserve(static_cast<std::size_t>(side * side));
  for (int i = 0; i < side * side; ++i) shifts.push_back((glm::dvec2(i % side, i / side) + 0.5) / double(side) - 0.5);
  return shifts;
}

}  // namespace plugc
