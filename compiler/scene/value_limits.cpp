// Ranges come as `>=0`, `>0`, `<=1`; the two ends of a range are checked in one pass. Words come as a list; MultiTexture.mode
// may give two of them, for colour and alpha, as `MODULATE / REPLACE`, so a string counts as the words between `/` and `,`.

#include "scene/value_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace plugc {
namespace {

/// A bound like `>=0`, `>0`, `<=1`; an empty one holds for every number. Angles are often written rounded (1.5708 for a
/// right angle), so an inclusive bound takes a little more.
struct Bound {
  bool exists = false;
  bool above = false;
  bool inclusive = false;
  double value = 0;

  explicit Bound(std::string_view text) {
    if (text.empty()) return;
    exists = true;
    above = text[0] == '>';
    inclusive = text.size() > 1 && text[1] == '=';
    value = std::strtod(std::string(text.substr(inclusive ? 2 : 1)).c_str(), nullptr);
  }
  bool holds(double number) const {
    constexpr double kTolerance = 1e-4;
    if (!exists || (inclusive && std::abs(number - value) <= kTolerance * std::abs(value))) return true;
    return above ? number > value : number < value;
  }
};

constexpr std::string_view kEmptyWord = "\"\"";  // as the table writes it

std::vector<std::string_view> words_of(std::string_view list) {
  std::vector<std::string_view> words;
  any_alternative(list, [&](std::string_view word) {
    words.push_back(word);
    return false;
  });
  return words;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// The first part of a string that is none of the words.
std::optional<std::string_view> find_odd_word(std::string_view text, std::string_view list) {
  do {
    const std::size_t end = text.find_first_of("/,");
    const std::string_view word = trimmed(text.substr(0, end));
    const std::string_view wanted = word.empty() ? kEmptyWord : word;
    if (!any_alternative(list, [&](std::string_view known) { return known == wanted; })) return word;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  } while (!text.empty());
  return std::nullopt;
}

std::string quoted(std::string_view word) {
  return fmt::format("`{}`", word.empty() ? kEmptyWord : word);
}

/// "; it takes `A`, `B` or `C`", or the one of many that was meant.
std::string expected_words(std::string_view odd, std::span<const std::string_view> words) {
  constexpr std::size_t kMostShown = 8;
  std::string meant = did_you_mean(odd, words);
  if (!meant.empty()) return meant;
  std::string text = "; it takes ";
  const std::size_t shown = std::min(words.size(), kMostShown);
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == words.size();
    text += fmt::format("{}{}", i == 0 ? "" : last ? " or " : ", ", quoted(words[i]));
  }
  if (shown < words.size()) text += fmt::format(" or one of {} more", words.size() - shown);
  return text;
}

}  // namespace

std::optional<OutOfRange> find_out_of_range(const ValueContract& contract, std::span<const double> numbers) {
  if (contract.info == nullptr) return std::nullopt;
  const Bound minimum(contract.info->minimum), maximum(contract.info->maximum);
  if (!minimum.exists && !maximum.exists) return std::nullopt;
  const auto is_out = [&](double number) { return !minimum.holds(number) || !maximum.holds(number); };
  const auto first = std::find_if(numbers.begin(), numbers.end(), is_out);
  if (first == numbers.end()) return std::nullopt;
  const auto others = std::count_if(first + 1, numbers.end(), is_out);
  const std::string_view bound = minimum.holds(*first) ? contract.info->maximum : contract.info->minimum;
  return OutOfRange{
      static_cast<std::size_t>(first - numbers.begin()),
      fmt::format("`{}` of `{}` {} {}{}, but should be {}", contract.field, contract.node, numbers.size() == 1 ? "is" : "holds",
                  *first, others == 0 ? "" : fmt::format(" ({} more out of range)", others), bound)};
}

void check_words(const ValueContract& contract, const Span& value, std::span<const MappedText> strings,
                 Diagnostics& diagnostics) {
  if (contract.info == nullptr || contract.info->words.empty()) return;
  const std::vector<std::string_view> words = words_of(contract.info->words);
  for (const MappedText& string : strings) {
    const std::optional<std::string_view> odd = find_odd_word(string.text(), contract.info->words);
    if (!odd) continue;
    const auto begin = static_cast<std::uint32_t>(odd->data() - string.text().data());
    const Span place = odd->empty() ? value : string.locate(begin, begin + static_cast<std::uint32_t>(odd->size()));
    diagnostics.report(
        DiagnosticId::field_value, place.valid() ? place : value,
        fmt::format("`{}` of `{}` takes no {}{}", contract.field, contract.node, quoted(*odd), expected_words(*odd, words)));
  }
}

}  // namespace plugc
