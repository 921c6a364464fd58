// Lists and texts: numbers one behind the other.

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/script_limits.h"
#include "runtime/script_operations.h"

namespace plugc {
namespace {

/// Where the element of that index begins; nullopt outside of the list.
std::optional<std::size_t> element_begin(const ScriptValue& list, const ScriptValue& index, std::size_t width) {
  const double last = std::floor(static_cast<double>(list.size()) / static_cast<double>(width)) - 1;
  if (index.size() != 1 || !(index[0] >= 0 && index[0] <= last)) return std::nullopt;
  return static_cast<std::size_t>(index[0]) * width;
}

ScriptResult out_of_range(const ScriptValue& list, const ScriptValue& index, std::size_t width) {
  return script_fault(
      fmt::format("it asks for element {} of {}, counted from 0", index.empty() ? 0.0 : index[0], list.size() / width));
}

}  // namespace

ScriptResult element(const ScriptValue& list, const ScriptValue& index, std::size_t width) {
  const auto begin = element_begin(list, index, width);
  if (!begin) return out_of_range(list, index, width);
  const auto first = list.begin() + static_cast<std::ptrdiff_t>(*begin);
  return {{first, first + static_cast<std::ptrdiff_t>(width)}, ""};
}

ScriptResult replace(ScriptValue list, const ScriptValue& index, const ScriptValue& value, std::size_t width) {
  const auto begin = element_begin(list, index, width);
  if (!begin) return out_of_range(list, index, width);
  if (value.size() != width) return script_fault("it puts into a text what is not one character");
  std::ranges::copy(value, list.begin() + static_cast<std::ptrdiff_t>(*begin));
  return {std::move(list), ""};
}

ScriptResult resize(ScriptValue list, const ScriptValue& count, std::size_t width) {
  if (count.size() != 1) return script_misfit();
  const double numbers = count[0] * static_cast<double>(width);
  if (!(numbers >= 0)) return script_fault(fmt::format("no list has {} elements", count[0]));
  if (numbers > static_cast<double>(kMaxScriptNumbers)) return script_fault("its lists grow beyond all bounds");
  list.resize(static_cast<std::size_t>(numbers), 0.0);
  return {std::move(list), ""};
}

ScriptResult join(ScriptArguments arguments) {
  ScriptResult made;
  for (const ScriptValue& one : arguments) made.value.insert(made.value.end(), one.begin(), one.end());
  return made;
}

ScriptResult script_text(std::string_view words) {
  ScriptResult made;
  for (const char c : words) made.value.push_back(static_cast<unsigned char>(c));
  return made;
}

}  // namespace plugc
