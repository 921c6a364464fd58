// The classic reader against the least that any reader of numbers does: a loop of std::from_chars over the same text.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "document/read_document.h"

namespace plugc {
namespace {

constexpr int kPoints = 100'000;

/// A scene that is nearly all numbers, written as modelling tools do.
std::string numbers_scene() {
  std::string text = "#X3D V4.0 utf8\nPROFILE Interchange\nShape { geometry PointSet { coord Coordinate { point [\n";
  for (int i = 0; i < kPoints; ++i) text += fmt::format("{:.6f} {:.5f} {:.4f},\n", std::sin(i), i * 0.37, -std::cos(i) * 100);
  return text + "] } } }\n";
}

void read_classic_numbers(benchmark::State& state) {
  SourceSet sources;
  const SourceId source = sources.add("numbers.x3dv", numbers_scene());
  for (auto _ : state) {
    Diagnostics diagnostics(sources);
    const Document document = read_classic(source, sources, diagnostics);
    if (!diagnostics.all().empty()) return state.SkipWithError("the scene has mistakes");
    benchmark::DoNotOptimize(document);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(sources.text(source).size()));
}
BENCHMARK(read_classic_numbers)->Unit(benchmark::kMillisecond);

bool starts_number(char c) {
  return c == '-' || (c >= '0' && c <= '9');
}

void from_chars_loop(benchmark::State& state) {
  const std::string text = numbers_scene();
  const std::size_t begin = text.find('[');
  std::vector<double> numbers;
  for (auto _ : state) {
    numbers.clear();
    const char* at = text.data() + begin;
    const char* const end = text.data() + text.size();
    while (at != end) {
      double number = 0;
      if (starts_number(*at)) {
        at = std::from_chars(at, end, number).ptr;
        numbers.push_back(number);
      } else {
        ++at;
      }
    }
    if (numbers.size() != std::size_t{3} * kPoints) return state.SkipWithError("numbers are missing");
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(from_chars_loop)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plugc
