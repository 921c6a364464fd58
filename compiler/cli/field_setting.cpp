#include "cli/field_setting.h"

#include <algorithm>
#include <charconv>

namespace plugc {
namespace {

std::optional<double> read_value(std::string_view word) {
  if (word == "TRUE" || word == "true") return 1;
  if (word == "FALSE" || word == "false") return 0;
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<FieldSetting> read_field_setting(std::string_view text) {
  constexpr std::string_view kBlanks = " ,\t\r\n";
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::size_t dot = name.find('.');
  if (equals == std::string_view::npos || dot == 0 || dot >= name.size() - 1) return std::nullopt;
  FieldSetting setting{std::string(name), {}};
  std::string_view rest = text.substr(equals + 1);
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    if (rest.empty()) break;
    const auto value = read_value(rest.substr(0, rest.find_first_of(kBlanks)));
    if (!value) return std::nullopt;
    setting.values.push_back(*value);
    rest.remove_prefix(std::min(rest.find_first_of(kBlanks), rest.size()));
  }
  return setting.values.empty() ? std::nullopt : std::optional(std::move(setting));
}

}  // namespace plugc
