// Lines are filled element by element: one that would cross the margin begins the next line.

#include "document/layout.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace plugc {
namespace {

std::string_view trimmed_right(std::string_view text) {
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace

std::string number_text(double number) {
  if (!std::isfinite(number)) number = 0;  // no encoding has words for it, and no reader makes one
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), error == std::errc() ? end : text.data()};
}

void join_lines(std::string& text, std::size_t begin) {
  constexpr std::size_t kLongest = 8 * kLineWidth;  // blanks in front of the lines included
  if (begin == 0 || text.size() - begin > kLongest) return;
  std::string line;
  bool inside_string = false;
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '{' || (c == '\n' && inside_string)) return;
    if (c == '\n') {
      at = std::min(text.find_first_not_of(' ', at + 1), text.size()) - 1;
      line += ' ';
      continue;
    }
    line += c;
    if (inside_string && c == '\\' && at + 1 < text.size()) {
      line += text[++at];
    } else if (c == '"') {
      inside_string = !inside_string;
    }
  }
  const std::size_t line_begin = text.rfind('\n', begin - 1) + 1;
  if (begin - line_begin + line.size() <= kLineWidth) text.replace(begin, std::string::npos, line);
}

std::string numbers_text(const Document& document, const ValueSyntax& value, const NumberWords& words, std::size_t level) {
  const std::span<const double> numbers = document.of(value.numbers());
  const bool booleans = value.kind == ValueKind::booleans;
  const std::size_t components = std::max<std::size_t>(value.components, 1);
  const std::string indent = indentation(level);
  const std::string_view between_elements = components == 1 ? words.between : words.between_elements;
  std::string text, element;
  std::size_t line_begin = 0;
  for (std::size_t i = 0; i < numbers.size(); i += components) {
    element.clear();
    for (std::size_t k = i; k < std::min(i + components, numbers.size()); ++k) {
      if (k > i) element += words.between;
      element += booleans ? std::string(numbers[k] != 0 ? words.true_word : words.false_word) : number_text(numbers[k]);
    }
    if (i > 0 && indent.size() + text.size() - line_begin + element.size() > kLineWidth) {
      text.append(trimmed_right(between_elements)).append("\n");
      line_begin = text.size();
      text += indent;
      line_begin += indent.size();
    } else if (i > 0) {
      text += between_elements;
    }
    text += element;
  }
  return text;
}

std::string list_text(const std::string& items, std::size_t level) {
  if (fits_line(items, level)) return "[ " + items + " ]";
  return "[\n" + indentation(level + 1) + items + '\n' + indentation(level) + ']';
}

std::string strings_list_text(const std::vector<std::string>& strings, std::string_view between, std::size_t level) {
  if (strings.empty()) return "[ ]";
  const std::string line = fmt::format("{}", fmt::join(strings, between));
  if (fits_line(line, level)) return list_text(line, level);
  const std::string next_line = std::string(trimmed_right(between)) + '\n' + indentation(level + 1);
  return list_text(fmt::format("{}", fmt::join(strings, next_line)), level);
}

}  // namespace plugc
