// A package against the scene that it was made from, both up to data that can be drawn: bytes to a verified package, and
// scene files to a package in memory, with glslang asked for every program and with its verdicts remembered.

#include "tests/bench/bench_scenes.h"

#include <cstdlib>

namespace plugc {
namespace {

std::size_t bytes_in(const std::vector<std::vector<std::uint8_t>>& packages) {
  std::size_t sum = 0;
  for (const auto& bytes : packages) sum += bytes.size();
  return sum;
}

void count_bytes(benchmark::State& state, std::size_t bytes_an_iteration) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes_an_iteration));
}

void open_packages(benchmark::State& state, const SceneSet& set) {
  const auto packages = packages_of(set);
  for (auto _ : state) {
    for (const auto& bytes : packages) {
      const PackageView view = open_package(bytes);
      if (view.package == nullptr) return state.SkipWithError(view.error.c_str());
    }
  }
  count_bytes(state, bytes_in(packages));
}

void write_packages(benchmark::State& state, const SceneSet& set) {
  const auto packages = packages_of(set);
  std::vector<PackageT> unpacked(packages.size());
  for (std::size_t i = 0; i < packages.size(); ++i) open_package(packages[i]).package->UnPackTo(&unpacked[i]);
  for (auto _ : state) {
    for (const PackageT& package : unpacked) benchmark::DoNotOptimize(write_package(package));
  }
  count_bytes(state, bytes_in(packages));
}

void compile_without_cache(benchmark::State& state, const SceneSet& set) {
  Validator validator({});
  compile_each(set, validator);  // warm
  for (auto _ : state) compile_each(set, validator);
}

void compile_with_cache(benchmark::State& state, const SceneSet& set) {
  std::string folder = std::filesystem::temp_directory_path() / "plugc-bench-XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) return state.SkipWithError("no folder for the cache");
  Validator validator({.cache_folder = folder});
  compile_each(set, validator);  // fills the cache
  for (auto _ : state) compile_each(set, validator);
  std::filesystem::remove_all(folder);
}

const bool registered = (register_for_sets("open_packages", open_packages), register_for_sets("write_packages", write_packages),
                         register_for_sets("compile_without_cache", compile_without_cache),
                         register_for_sets("compile_with_cache", compile_with_cache), true);

}  // namespace
}  // namespace plugc
