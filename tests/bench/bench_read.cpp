// The readers against the least that any reader of numbers does: a loop of std::from_chars over the same text; for XML behind
// pugixml's own parse. Number-heavy scenes are read up to the numbers; those of XML are typed from their attributes.

#include <benchmark/benchmark.h>

#include <charconv>

#include <pugixml.hpp>

#include "document/read_document.h"
#include "document/read_lexical.h"
#include "read_scenes.h"

namespace plugc {
namespace {

constexpr std::size_t kNumberBytes = 4'000'000;
constexpr std::size_t kNodeBytes = 4'000'000;

using Scene = std::string (*)(Encoding, std::size_t);

void count_bytes(benchmark::State& state, std::size_t size) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(size));
}

/// What the scene room does first with a document of XML: the attributes that hold numbers, as numbers.
std::size_t type_attributes(const Document& document, Diagnostics& diagnostics) {
  std::size_t count = 0;
  for (const FieldSyntax& field : document.fields) {
    if (field.value.kind != ValueKind::lexical) continue;
    for (const MappedText& text : document.of(field.value.strings()))
      count += read_lexical_numbers(text, LexicalKind::numbers, diagnostics).numbers.size();
  }
  return count;
}

void read_scene(benchmark::State& state, Encoding encoding, Scene scene, std::size_t size) {
  SourceSet sources;
  const SourceId source = sources.add("measured", scene(encoding, size));
  for (auto _ : state) {
    Diagnostics diagnostics(sources);
    const Document document = read_document(source, sources, diagnostics);
    std::size_t numbers = document.numbers.size();
    if (encoding == Encoding::xml) numbers += type_attributes(document, diagnostics);
    if (numbers == 0 || !diagnostics.all().empty()) return state.SkipWithError("the scene has mistakes");
    benchmark::DoNotOptimize(document);
  }
  count_bytes(state, sources.text(source).size());
}
BENCHMARK_CAPTURE(read_scene, classic_numbers, Encoding::classic, numbers_scene, kNumberBytes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_scene, xml_numbers, Encoding::xml, numbers_scene, kNumberBytes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_scene, json_numbers, Encoding::json, numbers_scene, kNumberBytes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_scene, classic_nodes, Encoding::classic, nodes_scene, kNodeBytes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_scene, xml_nodes, Encoding::xml, nodes_scene, kNodeBytes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_scene, json_nodes, Encoding::json, nodes_scene, kNodeBytes)->Unit(benchmark::kMillisecond);

bool starts_number(char c) {
  return c == '-' || (c >= '0' && c <= '9');
}

/// Every number in the text, by std::from_chars; a sign alone is none.
void take_all_numbers(const char* at, const char* end, std::vector<double>& numbers) {
  while (at != end) {
    double number = 0;
    const auto [behind, error] =
        starts_number(*at) ? std::from_chars(at, end, number) : std::from_chars_result{at, std::errc::invalid_argument};
    if (error == std::errc()) numbers.push_back(number);
    at = error == std::errc() ? behind : at + 1;
  }
}

void from_chars_loop(benchmark::State& state, Encoding encoding) {
  const std::string text = numbers_scene(encoding, kNumberBytes);
  for (auto _ : state) {
    std::vector<double> numbers;
    take_all_numbers(text.data(), text.data() + text.size(), numbers);
    benchmark::DoNotOptimize(numbers);
  }
  count_bytes(state, text.size());
}
BENCHMARK_CAPTURE(from_chars_loop, classic, Encoding::classic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(from_chars_loop, json, Encoding::json)->Unit(benchmark::kMillisecond);

/// pugixml as it comes, then the loop over the attribute that holds the numbers.
void pugixml_and_from_chars_loop(benchmark::State& state) {
  const std::string text = numbers_scene(Encoding::xml, kNumberBytes);
  for (auto _ : state) {
    pugi::xml_document tree;
    if (!tree.load_buffer(text.data(), text.size())) return state.SkipWithError("pugixml cannot read the scene");
    const std::string_view points = tree.select_node("//Coordinate").node().attribute("point").value();
    std::vector<double> numbers;
    take_all_numbers(points.data(), points.data() + points.size(), numbers);
    benchmark::DoNotOptimize(numbers);
  }
  count_bytes(state, text.size());
}
BENCHMARK(pugixml_and_from_chars_loop)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plugc
