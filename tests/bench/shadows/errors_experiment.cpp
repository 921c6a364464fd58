// The truth of a scene is traced once. Then each method is compiled and each size drawn, and every picture compared with it.

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "runtime/measure/measured_scene.h"
#include "shadows/compile_scene.h"
#include "shadows/experiments.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

/// Small maps make large errors, whose mean needs more positions.
int shift_count(const Lab& lab, std::uint32_t size) {
  if (lab.quick || size == 0) return 1;
  return size <= 1024 ? 4 : 1;
}

/// A point light has not every method: others are replaced, and the scene then says nothing about them.
bool uses(const PackedScene& scene, const std::string& method) {
  return std::ranges::any_of(*scene.shadow_maps(),
                             [&](const PackedShadowMap* map) { return EnumNamePackedShadowMethod(map->method()) == method; });
}

class ErrorTable {
 public:
  ErrorTable(Lab& lab, std::ofstream& file) : lab_(lab), file_(file) {}

  void add_scene(const fs::path& scene) {
    std::string error;
    const std::vector<std::uint8_t> bytes = compile_scene(scene, "", lab_.validator, error);
    if (bytes.empty()) {
      fmt::print(stderr, "{}\n", error);
      return;
    }
    const auto loaded = load_measured_scene(lab_.studio, bytes, {});
    const JudgedScene judged = judge_scene(lab_.studio, *loaded, judged_frames(*loaded->package.package, lab_.quick));
    if (judged.views.empty())
      fmt::print(stderr, "{}: no light of it has a shadow map yet, so it is left out\n", scene.string());
    if (judged.views.empty()) return;
    for (const JudgedView& view : judged.views) write(scene, view, "none", 0, {errors_without_shadow(view.truth), 0}, 1);
    for (const std::string& method : lab_.methods) add_method(scene, judged, method);
  }

 private:
  void add_method(const fs::path& scene, const JudgedScene& judged, const std::string& method) {
    std::string error;
    const std::vector<std::uint8_t> bytes = compile_scene(scene, method, lab_.validator, error);
    if (bytes.empty()) fmt::print(stderr, "{}\n", error);
    if (bytes.empty()) return;
    for (const std::uint32_t size : map_sizes(lab_, method)) {
      const auto loaded = load_measured_scene(lab_.studio, bytes, sized(size));
      if (!uses(*loaded->loaded.packed, method)) return;
      for (const JudgedView& view : judged.views) {
        const MeanErrors mean = measure_errors(lab_.studio, *loaded, judged, view, shift_count(lab_, size));
        const double leak = method.ends_with("sm") ? measure_leak(lab_.studio, *loaded, judged, view) : 0;  // of moment maps
        write(scene, view, method, size, mean, leak);
      }
    }
  }

  void write(const fs::path& scene, const JudgedView& view, const std::string& method, std::uint32_t size,
             const MeanErrors& mean, double leak) {
    const ShadowErrors& e = mean.errors;
    file_ << csv_line({scene.stem().string(), view.frame.viewpoint, method},
                      {double(size), double(view.truth.counted), double(view.truth.shadowed), e.wrong(), e.false_shadow,
                       e.false_lit, e.mean_absolute, e.weighted, e.at_edge, e.near_edge, e.far_from_edge, mean.floor, leak});
    file_.flush();
  }

  Lab& lab_;
  std::ofstream& file_;
};

}  // namespace

void measure_all_errors(Lab& lab) {
  std::ofstream file(lab.output / "errors.csv");
  file << "scene,view,method,size,counted,shadowed,wrong,false_shadow,false_lit,mean_absolute,weighted,at_edge,near_edge,far_"
          "from_edge,"
          "floor,leak\n";
  ErrorTable table(lab, file);
  for (const fs::path& scene : lab.scenes) table.add_scene(scene);
}

}  // namespace plugc
