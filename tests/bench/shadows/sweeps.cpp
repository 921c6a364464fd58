// One parameter at a time goes to where methods fail. The truth is traced again wherever the parameter moves light or scene.

#include <cmath>
#include <fstream>
#include <functional>

#include <fmt/format.h>

#include "runtime/measure/measured_scene.h"
#include "shadows/compile_scene.h"
#include "shadows/experiments.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSize = 1024;

/// The first viewpoint of a scene with one setting at each of several values.
struct Sweep {
  std::string name;
  std::string scene;  ///< Of lab.scenes, by its stem.
  std::vector<double> values;
  std::function<void(Settings&, double)> apply;
};

std::vector<double> powers_of_ten(int first, int last) {
  std::vector<double> values;
  for (int exponent = first; exponent <= last; ++exponent) values.push_back(std::pow(10.0, exponent));
  return values;
}

std::vector<Sweep> all_sweeps(bool quick) {
  // The spotlight's map reaches 17.5 units: its near plane is what far / near changes.
  constexpr double kSpotFar = 17.5;
  std::vector<Sweep> sweeps;
  sweeps.push_back({"elevation", "open", {2, 5, 10, 20, 30, 45, 60, 75, 85, 89, 90}, [](Settings& settings, double degrees) {
                      const double angle = degrees * std::acos(-1.0) / 180;
                      settings.light_direction = glm::dvec3(-0.8 * std::cos(angle), -std::sin(angle), -0.6 * std::cos(angle));
                    }});
  sweeps.push_back({"far_near", "spot", powers_of_ten(1, 7),
                    [](Settings& settings, double ratio) { settings.projection_near = kSpotFar / ratio; }});
  const auto scale = [](Settings& settings, double value) { settings.scene_scale = value; };
  const auto offset = [](Settings& settings, double value) { settings.scene_offset = glm::dvec3(value, value / 2, -value); };
  for (const char* scene : {"open", "spot"}) {
    sweeps.push_back({"scale", scene, powers_of_ten(-3, 6), scale});
    sweeps.push_back({"offset", scene, powers_of_ten(2, 6), offset});
  }
  if (quick) {
    for (Sweep& sweep : sweeps) sweep.values = {sweep.values.front(), sweep.values.back()};
  }
  return sweeps;
}

const fs::path* find_scene(const Lab& lab, const std::string& stem) {
  for (const fs::path& scene : lab.scenes) {
    if (scene.stem() == stem) return &scene;
  }
  return nullptr;
}

std::vector<FrameOptions> first_view(const MeasuredScene& scene) {
  std::vector<FrameOptions> frames = judged_frames(*scene.package.package, false);
  frames.resize(1);
  return frames;
}

void run(Lab& lab, const Sweep& sweep, const std::string& method, std::ofstream& file) {
  const fs::path* const scene = find_scene(lab, sweep.scene);
  std::string error;
  if (scene == nullptr) return;
  const std::vector<std::uint8_t> bytes = compile_scene(*scene, method, lab.validator, error);
  for (const double value : sweep.values) {
    if (bytes.empty()) return;
    Settings settings;
    settings.size = kSize;
    sweep.apply(settings, value);
    const auto loaded = load_measured_scene(lab.studio, bytes, settings);
    const JudgedScene judged = judge_scene(lab.studio, *loaded, first_view(*loaded));
    for (const JudgedView& view : judged.views) {
      const MeanErrors mean = measure_errors(lab.studio, *loaded, judged, view, lab.quick ? 1 : 16);
      file << csv_line({sweep.name, sweep.scene, method},
                       {value, mean.errors.false_shadow, mean.errors.false_lit, mean.errors.wrong(), mean.errors.weighted,
                        mean.floor, double(view.truth.counted)});
    }
  }
}

/// The grid for one method of one scene.
void run_bias(Lab& lab, const fs::path& scene, const std::string& method, std::ofstream& file) {
  std::string error;
  const std::vector<std::uint8_t> bytes = compile_scene(scene, method, lab.validator, error);
  if (bytes.empty()) fmt::print(stderr, "{}\n", error);
  if (bytes.empty()) return;
  const auto first = load_measured_scene(lab.studio, bytes, {});
  const JudgedScene judged = judge_scene(lab.studio, *first, first_view(*first));
  for (const double scale : {0.0, 0.5, 1.0, 1.1, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 16.0}) {
    for (const double bias : {0.0, 1.0, 4.0, 16.0, 256.0}) {
      if (lab.quick && bias != 4) continue;
      Settings settings = sized(kSize);
      settings.scale = scale;
      settings.bias = bias;
      const auto loaded = load_measured_scene(lab.studio, bytes, settings);
      for (const JudgedView& view : judged.views) {
        const MeanErrors mean = measure_errors(lab.studio, *loaded, judged, view, 1);
        file << csv_line({scene.stem().string(), method},
                         {scale, bias, mean.errors.false_shadow, mean.errors.false_lit, mean.errors.wrong(), mean.floor});
      }
    }
  }
}

}  // namespace

void sweep_stability(Lab& lab) {
  std::ofstream file(lab.output / "stability.csv");
  file << "sweep,scene,method,value,false_shadow,false_lit,wrong,weighted,floor,counted\n";
  for (const std::string& method : lab.methods) {
    if (method != "bilinear" && method != "sharp3" && method != "evsm") continue;
    for (const Sweep& sweep : all_sweeps(lab.quick)) run(lab, sweep, method, file);
  }
}

void sweep_bias(Lab& lab) {
  std::ofstream file(lab.output / "bias.csv");
  file << "scene,method,scale,bias,false_shadow,false_lit,wrong,floor\n";
  for (const char* stem : {"open", "street", "layered", "spot"}) {
    const fs::path* const scene = find_scene(lab, stem);
    for (const std::string& method : lab.methods) {
      if (scene != nullptr && (method == "hard" || method == "bilinear" || method == "pcf3"))
        run_bias(lab, *scene, method, file);
    }
  }
}

}  // namespace plugc
