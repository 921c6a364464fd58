#pragma once
// Code that stands where a url may: the whole text is the url.

#include <algorithm>
#include <string_view>

namespace plugc {

inline constexpr std::string_view kPlainCode = "data:text/plain,";  ///< In front of the code of a shader.

/// Whether it is the code of a Script: `ecmascript:`, `javascript:` and their kind in front.
inline bool is_script(std::string_view code) {
  code.remove_prefix(std::min(code.find_first_not_of(" \t\r\n"), code.size()));
  const std::size_t colon = std::min(code.find(':'), code.size());
  const std::string_view scheme = code.substr(0, colon);
  return colon < code.size() && scheme.ends_with("script") &&
         std::all_of(scheme.begin(), scheme.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

}  // namespace plugc
