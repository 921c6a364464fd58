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

/// `true`, `false`; other ways to say so are reported and understood.
double read_boolean(std::string_view item, std::string& message) {
  if (item == "true" || item == "false") return item == "true" ? 1 : 0;
  if (item == "TRUE" || item == "FALSE") {
    message = fmt::format("`{}` is spelled `{}` here", item, item == "TRUE" ? "true" : "false");
    return item == "TRUE" ? 1 : 0;
  }
  message = fmt::format("`{}` is neither `true` nor `false`", item.substr(0, kLongestShown));
  return item == "1" ? 1 : 0;
}

double read_number(std::string_view item, std::string& message) {
  double value = 0;
  const auto [end, error] = scan_number(item.data(), item.data() + item.size(), value);
  const bool whole = end == item.data() + item.size();
  if (error == std::errc() && whole) return value;
  if (error == std::errc::result_out_of_range && whole) {
    if (item.find("e-") != std::string_view::npos) return 0;  // too small to tell from zero
    message = fmt::format("`{}` is larger than any number that plugc reads", item.substr(0, kLongestShown));
  } else {
    message = fmt::format("`{}` is no number", item.substr(0, kLongestShown));
  }
  return 0;
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

LexicalNumbers read_lexical_numbers(const MappedText& text, LexicalKind kind, Diagnostics& diagnostics, std::size_t most) {
  constexpr std::size_t kUsualNumbers = 4;  // a vector, a colour, a rotation
  LexicalNumbers read;
  read.numbers.reserve(kUsualNumbers);
  std::size_t mistakes = 0;
  const std::string_view bytes = text.text();
  const char* const end = bytes.data() + bytes.size();
  std::size_t at = skip_space(bytes, 0);
  while (at < bytes.size()) {
    const bool run = kind == LexicalKind::numbers;
    const auto next =
        !run ? at : static_cast<std::size_t>(scan_numbers(bytes.data() + at, end, read.numbers, most).next - bytes.data());
    if (next != at) {
      at = next;
      continue;
    }
    if ((read.cut = read.numbers.size() >= most)) break;
    const std::size_t behind = item_end(bytes, at);
    const std::string_view item = bytes.substr(at, behind - at);
    std::string message;
    read.numbers.push_back(kind == LexicalKind::numbers ? read_number(item, message) : read_boolean(item, message));
    if (!message.empty() && ++mistakes <= kMaxSyntaxMistakes) report(text, at, behind, std::move(message), diagnostics);
    at = skip_space(bytes, behind);
  }
  read.damaged = mistakes > 0;
  return read;
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
