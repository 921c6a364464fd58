// What a package costs to load and to draw, in a process of its own: prints one line of JSON. Processor time counts all
// threads, so that a busy machine may measure; the memory is the peak. `quick` generates code as for a single picture, `tuned`
// as for many.
//
//     frame_times PACKAGE FRAMES quick|tuned

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

#include "runtime/load_package.h"
#include "runtime/render.h"

namespace plugc {
namespace {

struct Times {
  double wall = 0, processor = 0;  ///< Seconds.
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

rusage usage_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

Times now() {
  const rusage usage = usage_so_far();
  const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(since_boot).count(), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

template <typename Step>
Times times_of(const Step& step) {
  const Times start = now();
  step();
  const Times end = now();
  return {end.wall - start.wall, end.processor - start.processor};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Times median_frame(Renderer& renderer, const FrameOptions& frame, int count) {
  std::vector<double> wall, processor;
  for (int i = 0; i < count; ++i) {
    const Times times = times_of([&] { renderer.draw(frame); });
    wall.push_back(times.wall);
    processor.push_back(times.processor);
  }
  return {median(wall), median(processor)};
}

/// Of all shapes, seen or not.
std::size_t triangle_count(const Package& package) {
  std::size_t indices = 0;
  for (const PackedShape* shape : *package.scenes()->Get(0)->shapes())
    indices += package.meshes()->Get(shape->mesh())->indices()->size();
  return indices / 3;
}

int measure(const char* path, int frames, bool quick) {
  std::string error;
  RendererOptions options;
  options.single_picture = quick;
  const std::unique_ptr<Renderer> renderer = Renderer::make(options, error);
  LoadedPackage package;
  bool loaded = false;
  const Times load = times_of([&] {
    package = load_package_file(path, error);
    loaded = renderer != nullptr && package.package != nullptr && renderer->load(*package.package, 0, error);
  });
  if (!loaded) {
    std::cerr << error << "\n";
    return EXIT_FAILURE;
  }
  FrameOptions frame;
  frame.width = 800;
  frame.height = 600;
  const Times first = times_of([&] { renderer->draw(frame); });
  const Times later = median_frame(*renderer, frame, frames);
  fmt::print(
      "{{\"load\": {}, \"first_frame\": {}, \"frame\": {}, \"frame_wall\": {}, \"draw_calls\": {}, \"triangles\": {}, "
      "\"peak_kib\": {}}}\n",
      load.processor, first.processor, later.processor, later.wall, renderer->statistics().draw_calls,
      triangle_count(*package.package), usage_so_far().ru_maxrss);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace plugc

int main(int argc, char** argv) {
  const std::string mode = argc == 4 ? argv[3] : "";
  if (mode == "quick" || mode == "tuned") return plugc::measure(argv[1], std::max(std::atoi(argv[2]), 1), mode == "quick");
  std::cerr << "see the head of frame_times.cpp\n";
  return EXIT_FAILURE;
}
