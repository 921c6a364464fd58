#include "cli/frame_series.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

namespace plugc {

std::string picture_name(const std::string& path, const FrameSeries& series, std::uint32_t picture) {
  if (series.count == 0) return path;
  const std::filesystem::path whole(path);
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(series.count - 1).size());
  const std::string numbered = fmt::format("{}{:0{}}{}", whole.stem().string(), picture, digits, whole.extension().string());
  return (whole.parent_path() / numbered).string();
}

bool check_series(const FrameSeries& series) {
  if (!std::isfinite(series.time) || series.time < 0) {
    fmt::print(stderr, "plugc: `--time {}` is no time of a scene; write seconds since it was loaded, from 0 on\n", series.time);
    return false;
  }
  if (!std::isfinite(series.step) || series.step < 0) {
    fmt::print(stderr, "plugc: `--step {}` is no step; write seconds from one picture to the next\n", series.step);
    return false;
  }
  return true;
}

}  // namespace plugc
