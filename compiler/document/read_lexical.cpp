// One pass over the decoded attribute. Places come from its map, so that a number behind `&#10;` is marked where it stands
// in the file.

#include "document/read_lexical.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "document/characters.h"
#include "document/scan_number.h"

namespace plugc {
namespace {

constexpr std::size_t kLongestShown = 32;

std::size_t skip_space(std::string_view text, std::size_t at) {
  while (at < text.size() && is_a(text[at], kSpaceCharacter)) ++at;
  return at;
}

std::size_t item_end(std::string_view text, std::size_t at) {
  while (at < text.size() && !is_a(text[at], kSpaceCharacter)) ++at;
  return at;
}

void report(const MappedText& text, std::size_t begin, std::size_t end, std::string message, Diagnostics& diagnostics) {
  const Span place = text.locate(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
  diagnostics.report(DiagnosticId::field_type, place, std::move(message));
}

bool read_boolean(std::string_view item, double& value) {
  value = item == "true" || item == "TRUE" ? 1 : 0;
  return value != 0 || item == "false" || item == "FALSE";
}

/// The string whose opening quote is at `at`; moves `at` behind its closing quote. False when there is none.
bool read_quoted(const MappedText& text, std::size_t& at, MappedText& string) {
  const std::string_view bytes = text.text();
  std::size_t run = ++at;
  const auto append = [&](std::size_t end) {
    string.append(text, static_cast<std::uint32_t>(run), static_cast<std::uint32_t>(end));
  };
  for (; at < bytes.size() && bytes[at] != '"'; ++at) {
    const bool escape = bytes[at] == '\\' && at + 1 < bytes.size() && (bytes[at + 1] == '"' || bytes[at + 1] == '\\');
    if (!escape) continue;
    append(at);
    run = ++at;
  }
  append(at);
  return at++ < bytes.size();
}

}  // namespace

std::vector<double> read_lexical_numbers(const MappedText& text, Diagnostics& diagnostics) {
  std::vector<double> numbers;
  const std::string_view bytes = text.text();
  const char* const end = bytes.data() + bytes.size();
  std::size_t at = skip_space(bytes, 0);
  while (at < bytes.size()) {
    const auto next = static_cast<std::size_t>(scan_numbers(bytes.data() + at, end, numbers).next - bytes.data());
    if (next != at) {
      at = next;
      continue;
    }
    const std::size_t behind = item_end(bytes, at);
    const std::string_view item = bytes.substr(at, behind - at);
    double value = 0;
    if (!read_boolean(item, value)) {
      report(text, at, behind, fmt::format("`{}` is no number", item.substr(0, kLongestShown)), diagnostics);
      break;
    }
    numbers.push_back(value);
    at = skip_space(bytes, behind);
  }
  return numbers;
}

std::vector<MappedText> read_lexical_strings(const MappedText& text, Diagnostics& diagnostics) {
  std::vector<MappedText> strings;
  const std::string_view bytes = text.text();
  std::size_t at = skip_space(bytes, 0);
  if (at < bytes.size() && bytes[at] != '"') return {text};
  for (; at < bytes.size(); at = skip_space(bytes, at)) {
    const std::size_t begin = at;
    if (bytes[at] != '"') {
      at = std::min(bytes.find('"', at), bytes.size());
      report(text, begin, item_end(bytes, begin), "text between strings; put it into quotes", diagnostics);
      continue;
    }
    if (strings.size() == kMaxDocumentItems) {
      report(text, at, at + 1, fmt::format("a field holds more than {} strings", kMaxDocumentItems), diagnostics);
      break;
    }
    if (!read_quoted(text, at, strings.emplace_back())) {
      report(text, begin, begin + 1, "this `\"` begins a string that is not closed", diagnostics);
    }
  }
  return strings;
}

}  // namespace plugc
