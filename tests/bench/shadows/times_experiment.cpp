// Each configuration is timed in turns with the same scene without shadows, so that both meet the same machine; what counts is
// the median of the differences. OpenGL's timer queries say nothing on llvmpipe: the queue is finished and the clock read.

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "runtime/measure/instrument.h"
#include "shadows/compile_scene.h"
#include "shadows/experiments.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWidth = 1280, kHeight = 720;
constexpr int kWarmUp = 2;  // frames: the first draw of a program generates its code

/// On the GPU, with the bytes that it points into.
struct TimedScene {
  std::vector<std::uint8_t> bytes;
  LoadedScene loaded;
};

std::unique_ptr<TimedScene> load_timed(Studio& studio, const std::vector<std::uint8_t>& bytes, const Settings& settings) {
  auto scene = std::make_unique<TimedScene>();
  scene->bytes = with_settings(bytes, settings);
  scene->loaded = studio.load(*open_package(scene->bytes).package);
  return scene;
}

std::string read_text(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// A scene of the same content whose programs know of no shadow.
std::vector<std::uint8_t> compile_without_shadows(Lab& lab, const fs::path& scene, std::string& error) {
  const fs::path copy = lab.output / ("unshadowed_" + scene.filename().string());
  std::ofstream(copy) << std::regex_replace(read_text(scene), std::regex("shadows TRUE"), "shadows FALSE");
  return compile_scene(copy, "", lab.validator, error);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Medians: the frame without shadows, and how much longer one takes with maps kept and with maps drawn anew.
struct ExtraTimes {
  FrameTime unshadowed;
  FrameTime maps_kept;
  FrameTime maps_drawn;
};

FrameTime medians(const std::vector<FrameTime>& times) {
  std::vector<double> wall, processor;
  for (const FrameTime& time : times) {
    wall.push_back(time.wall);
    processor.push_back(time.processor);
  }
  return {median(wall), median(processor)};
}

FrameTime beyond(const FrameTime& time, const FrameTime& before, const FrameTime& after) {
  return {time.wall - (before.wall + after.wall) / 2, time.processor - (before.processor + after.processor) / 2};
}

ExtraTimes time_in_turns(Studio& studio, LoadedScene& without, LoadedScene& with, int repetitions) {
  FrameOptions frame;
  frame.width = kWidth;
  frame.height = kHeight;
  std::vector<FrameTime> unshadowed, kept, drawn;
  FrameTime before = studio.time_frame(without, frame, true);
  for (int i = -kWarmUp; i < repetitions; ++i) {
    const FrameTime full = studio.time_frame(with, frame, true);
    const FrameTime still = studio.time_frame(with, frame, false);
    const FrameTime after = studio.time_frame(without, frame, true);
    if (i >= 0) {
      unshadowed.push_back(after);
      drawn.push_back(beyond(full, before, after));
      kept.push_back(beyond(still, before, after));
    }
    before = after;
  }
  return {medians(unshadowed), medians(kept), medians(drawn)};
}

void time_method(Lab& lab, const fs::path& scene, const std::string& method, LoadedScene& without, std::ofstream& file) {
  std::string error;
  const std::vector<std::uint8_t> bytes = compile_scene(scene, method, lab.validator, error);
  if (bytes.empty() || open_package(bytes).package->scenes()->Get(0)->shadow_maps()->size() == 0) return;
  for (const std::uint32_t size : map_sizes(lab, method)) {
    const auto with = load_timed(lab.studio, bytes, sized(size));
    const ExtraTimes times = time_in_turns(lab.studio, without, with->loaded, lab.quick ? 3 : 9);
    file << csv_line({scene.stem().string(), method},
                     {double(size), times.unshadowed.wall, times.maps_kept.wall, times.maps_drawn.wall,
                      times.unshadowed.processor, times.maps_kept.processor, times.maps_drawn.processor});
    file.flush();
  }
}

void time_scene(Lab& lab, const fs::path& scene, std::ofstream& file) {
  std::string error;
  const std::vector<std::uint8_t> plain = compile_without_shadows(lab, scene, error);
  if (plain.empty()) fmt::print(stderr, "{}\n", error);
  if (plain.empty()) return;
  const auto without = load_timed(lab.studio, plain, {});
  for (const std::string& method : lab.methods) time_method(lab, scene, method, without->loaded, file);
}

/// The whole picture is a receiver without much shadow in it, as a look-up costs the same in light and dark.
constexpr const char* kLookupScene = R"(#X3D V4.0 utf8
NavigationInfo { headlight FALSE }
Viewpoint { position 0 0 5 }
DirectionalLight { direction 0.3 -0.4 -1 shadows TRUE }
Shape { appearance Appearance { material Material { } } geometry Rectangle2D { size 40 20 } }
Transform { translation 0.4 0.3 0.5 children Shape { appearance Appearance { material Material { } } geometry Box { size 0.4 0.4 0.4 } } }
Transform { translation 3.5 -1.9 0.5 children Shape { appearance Appearance { material Material { } } geometry Box { size 0.4 0.4 0.4 } } }
Transform { translation -3.5 1.9 0.5 children Shape { appearance Appearance { material Material { } } geometry Box { size 0.4 0.4 0.4 } } }
)";

}  // namespace

void measure_all_times(Lab& lab) {
  std::ofstream file(lab.output / "times.csv");
  file << "scene,method,size,unshadowed,maps_kept,maps_drawn,unshadowed_processor,maps_kept_processor,maps_drawn_processor\n";
  for (const fs::path& scene : lab.scenes) time_scene(lab, scene, file);
}

void measure_lookups(Lab& lab) {
  const fs::path scene = lab.output / "lookups.x3dv";
  std::ofstream(scene) << kLookupScene;
  std::ofstream file(lab.output / "lookups.csv");
  file << "method,nanoseconds,nanoseconds_processor\n";
  std::string error;
  const auto without = load_timed(lab.studio, compile_without_shadows(lab, scene, error), {});
  for (const std::string& method : lab.methods) {
    const std::vector<std::uint8_t> bytes = compile_scene(scene, method, lab.validator, error);
    if (bytes.empty()) continue;
    const auto with = load_timed(lab.studio, bytes, sized(method == "traced" ? 0 : 1024));
    const ExtraTimes times = time_in_turns(lab.studio, without->loaded, with->loaded, lab.quick ? 5 : 25);
    constexpr double kNanosecondsAPixel = 1e6 / (double(kWidth) * kHeight);
    file << csv_line({method}, {times.maps_kept.wall * kNanosecondsAPixel, times.maps_kept.processor * kNanosecondsAPixel});
  }
}

}  // namespace plugc
