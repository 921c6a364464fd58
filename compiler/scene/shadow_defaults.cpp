#include "scene/shadow_defaults.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/diagnostics.h"
#include "base/limits.h"

namespace plugc {
namespace {

std::string unknown_method(std::string_view name) {
  const std::string meant = did_you_mean(name, shadow_method_names());
  if (!meant.empty()) return fmt::format("there is no method `{}`{}", name, meant);
  return fmt::format("there is no method `{}`; there are {}", name, fmt::join(shadow_method_names(), ", "));
}

/// 0 for what is none.
std::uint32_t read_size(std::string_view text) {
  std::uint32_t size = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), size);
  const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
  return whole && size <= kMaxShadowMapSide ? size : 0;
}

}  // namespace

ReadShadowDefaults read_shadow_defaults(std::string_view text) {
  ReadShadowDefaults read;
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto method = shadow_method_named(text.substr(0, comma));
  if (!method) {
    read.error = unknown_method(text.substr(0, comma));
    return read;
  }
  read.shadows.method = *method;
  if (comma == text.size()) return read;
  const std::string_view size = text.substr(comma + 1);
  read.shadows.size = read_size(size);
  if (read.shadows.size == 0)
    read.error = fmt::format("`{}` is no size of a shadow map; write a whole number from 1 to {}", size, kMaxShadowMapSide);
  return read;
}

}  // namespace plugc
