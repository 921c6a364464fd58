#pragma once
// The scenes that benchmarks compile.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "compile.h"

namespace plugc {

/// Scenes that are taken together, as one scene alone is too short to time well.
struct SceneSet {
  std::string name;
  std::vector<std::filesystem::path> scenes;  ///< In name order.
};

/// `own` (tests/bench/scenes) and, where it lies beside the sources, `corpus` (../shared/corpus/scenes).
std::vector<SceneSet> scene_sets();

/// Compiles each scene by itself, as a user would, and adds the statistics up.
CompileStatistics compile_each(const SceneSet& set, Validator& validator);

/// The scenes as packages; those that yield no program are left out.
std::vector<std::vector<std::uint8_t>> packages_of(const SceneSet& set);

/// Registers `function` once a set, as `name/set`.
template <typename Function>
void register_for_sets(const std::string& name, Function function) {
  for (const SceneSet& set : scene_sets()) {
    benchmark::RegisterBenchmark((name + "/" + set.name).c_str(), [set, function](benchmark::State& state) {
      function(state, set);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace plugc
