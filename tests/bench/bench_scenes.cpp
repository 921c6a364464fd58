// Finds scene files below a folder and compiles them one by one. Mistakes in a scene are no matter here: what could be made
// of it is timed.

#include "tests/bench/bench_scenes.h"

#include <algorithm>

namespace plugc {
namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& path) {
  const fs::path extension = path.extension();
  return extension == ".x3dv" || extension == ".x3d" || extension == ".wrl";
}

SceneSet scenes_below(const fs::path& folder, std::string name) {
  SceneSet set{std::move(name), {}};
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, missing)) {
    if (is_scene(entry.path())) set.scenes.push_back(entry.path());
  }
  std::sort(set.scenes.begin(), set.scenes.end());
  return set;
}

}  // namespace

std::vector<SceneSet> scene_sets() {
  const fs::path sources = PLUGC_SOURCE_DIR;
  std::vector<SceneSet> sets = {scenes_below(sources / "tests/bench/scenes", "own"),
                                scenes_below(sources / "../shared/corpus/scenes", "corpus")};
  std::erase_if(sets, [](const SceneSet& set) { return set.scenes.empty(); });
  return sets;
}

CompileStatistics compile_each(const SceneSet& set, Validator& validator) {
  CompileStatistics sum;
  for (const fs::path& scene : set.scenes) {
    SourceSet sources;
    Diagnostics diagnostics(sources);
    const CompileStatistics one = compile({scene}, {}, validator, sources, diagnostics).statistics;
    sum.compose += one.compose;
    sum.validate += one.validate;
    sum.compositions += one.compositions;
  }
  return sum;
}

std::vector<std::vector<std::uint8_t>> packages_of(const SceneSet& set) {
  std::vector<std::vector<std::uint8_t>> packages;
  Validator validator({});
  for (const fs::path& scene : set.scenes) {
    SourceSet sources;
    Diagnostics diagnostics(sources);
    const Compilation made = compile({scene}, {}, validator, sources, diagnostics);
    if (!made.package.programs.empty()) packages.push_back(write_package(made.package));
  }
  return packages;
}

}  // namespace plugc
