#pragma once
// How written documents are laid out: two blanks a level, lines of about kLineWidth, long lists broken between elements.

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"

namespace plugc {

inline constexpr std::size_t kLineWidth = 100;

/// The blanks in front of a line. Very deep nodes all stand at one depth: their blanks would outweigh their text.
inline std::string indentation(std::size_t level) {
  constexpr std::size_t kMaxLevels = 40;
  return std::string(2 * std::min(level, kMaxLevels), ' ');
}

/// What stands between the numbers of one element, between elements, and for booleans.
struct NumberWords {
  std::string_view between = " ";
  std::string_view between_elements = " ";
  std::string_view true_word = "true", false_word = "false";
};

/// The shortest text that reads back to the same double.
std::string number_text(double number);

/// The numbers or booleans of a value; what does not fit into one line goes on in lines that are indented to `level`.
std::string numbers_text(const Document& document, const ValueSyntax& value, const NumberWords& words, std::size_t level);

/// Puts what was written since `begin`, behind an opening bracket, into one line, if it fits there and holds no braces.
void join_lines(std::string& text, std::size_t begin);

/// Whether a text, behind what stands in its line anyway, fits into one line.
inline bool fits_line(std::string_view text, std::size_t level) {
  return text.find('\n') == std::string_view::npos && 2 * level + text.size() <= kLineWidth;
}

/// `[ a, b ]` of what stands between the brackets, in lines of its own where one is too short for it.
std::string list_text(const std::string& items, std::size_t level);

/// A list of strings that are quoted already, each in a line of its own where one is too short for all.
std::string strings_list_text(const std::vector<std::string>& strings, std::string_view between, std::size_t level);

}  // namespace plugc
