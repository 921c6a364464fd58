// What a look-up costs: frames of a floor that fills the picture, its shadow map drawn once, by method. Methods differ by their
// look-ups alone.

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "compile.h"
#include "runtime/render.h"

namespace plugc {
namespace {

constexpr std::uint32_t kWidth = 1280, kHeight = 720;

constexpr std::string_view kScene = R"(#X3D V4.0 utf8
NavigationInfo { headlight FALSE }
OrthoViewpoint { position 0 10 0 orientation 1 0 0 -1.5707963267949 fieldOfView [ -4 -4 4 4 ] }
DirectionalLight { direction -1 -1 0.3 shadows TRUE
  defaultShadowMap GeneratedShadowMap { update "NEXT_FRAME_ONLY" size 1024 } }
Shape { appearance Appearance { material Material { } } geometry Box { size 30 0.1 30 } }
Transform { translation 0 1 0 children Shape { appearance Appearance { material Material { } } geometry Box { size 2 0.2 2 } } }
)";

std::vector<std::uint8_t> compile_scene(ShadowMethod method) {
  const std::filesystem::path scene = std::filesystem::temp_directory_path() / "plugc_bench_shadow_lookups.x3dv";
  std::ofstream(scene) << kScene;
  Validator validator({});
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions options;
  options.shadows.method = method;
  return write_package(compile({scene}, options, validator, sources, diagnostics).package);
}

void look_up(benchmark::State& state) {
  const std::vector<std::uint8_t> bytes = compile_scene(static_cast<ShadowMethod>(state.range(0)));
  std::string error;
  const auto renderer = Renderer::make({}, error);
  if (renderer == nullptr || !renderer->load(*open_package(bytes).package, 0, error)) return state.SkipWithError(error.c_str());
  FrameOptions frame;
  frame.width = kWidth;
  frame.height = kHeight;
  for (int warm_up = 0; warm_up < 3; ++warm_up) renderer->draw(frame);
  for (auto _ : state) benchmark::DoNotOptimize(renderer->draw(frame));
  state.SetLabel(std::string(to_text(static_cast<ShadowMethod>(state.range(0)))));
}

}  // namespace
}  // namespace plugc

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const auto last = static_cast<std::int64_t>(plugc::shadow_method_names().size()) - 1;
  benchmark::RegisterBenchmark("look_up", plugc::look_up)
      ->DenseRange(0, last)
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime();  // of all its threads, so that a busy machine may do it
  benchmark::RunSpecifiedBenchmarks();
}
