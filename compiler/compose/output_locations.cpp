// An array takes as many locations as it has elements.

#include "compose/output_locations.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace plugc {
namespace {

constexpr std::string_view kColor = "castle_FragColor";

struct Output {
  std::string_view name;  // final
  bool placed = false;    // by its author
  std::uint32_t location = 0, size = 1;
};

/// The number behind a word and blanks or `=`: of `location` in `layout(location = 1)`, of `[` in `[2]`.
std::optional<std::uint32_t> number_behind(std::string_view text, std::string_view word) {
  const std::size_t found = text.find(word);
  if (found == std::string_view::npos) return std::nullopt;
  text.remove_prefix(std::min(text.find_first_not_of(" \t=", found + word.size()), text.size()));
  std::uint32_t number = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc()) return std::nullopt;
  return number;
}

Output read_output(std::string_view name, const GlobalOutline& global) {
  const auto location = number_behind(global.layout, "location");
  return {name, !global.layout.empty(), location.value_or(0), number_behind(global.array, "[").value_or(1)};
}

/// Of the fragment stage, each once; what plugc declares itself comes first.
std::vector<Output> find_outputs(const Composition& c) {
  std::vector<Output> outputs;
  const auto add = [&](const Output& output) {
    if (std::ranges::find(outputs, output.name, &Output::name) == outputs.end()) outputs.push_back(output);
  };
  const auto stands_in_stage = [](const PlacedUnit& unit) { return unit.stage == ShaderStage::fragment && !unit.dropped; };
  const bool has_color = std::ranges::any_of(c.units, [&](const PlacedUnit& unit) {
    return stands_in_stage(unit) && std::ranges::find(unit.code->castle_names, kColor) != unit.code->castle_names.end();
  });
  if (has_color) add({kColor});
  for (const PlacedUnit& unit : c.units) {
    if (!stands_in_stage(unit)) continue;
    for (const GlobalOutline& global : unit.code->outline.globals) {
      if (global.storage == Storage::out) add(read_output(c.final_name(unit, global.name), global));
    }
  }
  return outputs;
}

bool is_free(const std::set<std::uint32_t>& taken, std::uint32_t first, std::uint32_t size) {
  const auto next = taken.lower_bound(first);
  return next == taken.end() || *next >= first + size;
}

}  // namespace

void note_output_locations(Composition& c) {
  const std::vector<Output> outputs = find_outputs(c);
  if (outputs.size() < 2) return;
  constexpr std::uint32_t kMost = 64;  // more than any driver has; compilers say so
  std::set<std::uint32_t> taken;
  const auto take = [&](const Output& output, std::uint32_t location) {
    for (std::uint32_t i = 0; i < std::min(output.size, kMost); ++i) taken.insert(location + i);
  };
  for (const Output& output : outputs) {
    if (output.placed) take(output, output.location);
  }
  for (const Output& output : outputs) {
    if (output.placed) continue;
    std::uint32_t location = 0;
    while (output.name != kColor && !is_free(taken, location, std::min(output.size, kMost))) ++location;
    c.output_locations.emplace(output.name, location);
    take(output, location);
  }
}

std::string location_text(const Composition& composition, std::string_view final_name) {
  const auto found = composition.output_locations.find(final_name);
  return found == composition.output_locations.end() ? "" : fmt::format("layout(location = {}) ", found->second);
}

}  // namespace plugc
